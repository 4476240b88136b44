// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/Timers.hpp"

#include <ctime>

namespace isph {

double wallSeconds()
{
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}

double cpuSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double Timers::total() const
{
    double sum = 0;
    for (const Part& part : parts_) sum += part.seconds;
    return sum;
}

std::size_t Timers::slot(std::string_view part)
{
    for (std::size_t k = 0; k < parts_.size(); ++k)
        if (parts_[k].name == part) return k;
    parts_.push_back({std::string(part), 0});
    return parts_.size() - 1;
}

}  // namespace isph
