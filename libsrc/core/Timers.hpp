// SPDX-License-Identifier: GPL-3.0-or-later
// Wall time of the parts of a step, for the table at the end of the log.
#pragma once
#include <chrono>
#include <string>
#include <string_view>
#include <vector>

namespace isph {

double wallSeconds();   ///< since an arbitrary start
double cpuSeconds();    ///< of this process, all threads

class Timers {
public:
    /// Adds the time from construction to destruction to a part.
    class Scope {
    public:
        Scope(Timers& timers, std::string_view part)
            : timers_(timers), part_(timers.slot(part)), start_(wallSeconds())
        {
        }
        ~Scope() { timers_.parts_[part_].seconds += wallSeconds() - start_; }
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;

    private:
        Timers& timers_;
        std::size_t part_;
        double start_;
    };

    Scope scope(std::string_view part) { return Scope(*this, part); }

    struct Part {
        std::string name;
        double seconds = 0;
    };
    const std::vector<Part>& parts() const { return parts_; }
    double total() const;

private:
    std::size_t slot(std::string_view part);
    std::vector<Part> parts_;
};

}  // namespace isph
