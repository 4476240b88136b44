// SPDX-License-Identifier: GPL-3.0-or-later
// What VTK complains about, as text for our errors instead of lines on the user's screen.
#pragma once
#include <memory>
#include <string>

namespace isph {

/// While it lives VTK prints nothing; what it says is kept here.
class VtkMessages {
public:
    VtkMessages();
    ~VtkMessages();
    VtkMessages(const VtkMessages&) = delete;
    VtkMessages& operator=(const VtkMessages&) = delete;

    bool failed() const;               ///< there was an error among them
    const std::string& first() const;  ///< the first message: later ones follow from it

private:
    struct Content;
    std::unique_ptr<Content> content_;
};

}  // namespace isph
