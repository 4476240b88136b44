// SPDX-License-Identifier: GPL-3.0-or-later
// Checks that go on after a failure and are counted.
#pragma once
#include <functional>
#include <string>

namespace isph {

class Checklist {
public:
    /// Runs one check. It passes unless it throws; what it returns is printed behind "ok".
    /// Returns whether it passed.
    bool check(const std::string& what, const std::function<std::string()>& work);
    /// Something worth knowing that is no failure.
    void note(const std::string& text);
    int failures() const { return failures_; }

private:
    int failures_ = 0;
};

}  // namespace isph
