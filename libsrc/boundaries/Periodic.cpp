// SPDX-License-Identifier: GPL-3.0-or-later
#include "boundaries/Periodic.hpp"

#include "core/Error.hpp"

#include <fmt/core.h>

#include <cmath>

namespace isph {

template <int Dim>
Vec<Dim> PeriodicBox<Dim>::wrap(Vec<Dim> x) const
{
    for (int d = 0; d < Dim; ++d) {
        if (!periodic[d]) continue;
        x[d] -= length(d) * std::floor((x[d] - min[d]) / length(d));
        if (x[d] >= max[d]) x[d] -= length(d);   // a tiny negative offset rounds up to max
    }
    return x;
}

template <int Dim>
void PeriodicBox<Dim>::requireLength(Real support) const
{
    for (int d = 0; d < Dim; ++d)
        if (periodic[d] && length(d) < 2 * support)
            throw FatalError(fmt::format(
                "The period {:g} m in direction {} is shorter than two kernel supports of {:g} m.\n"
                "Use a finer spacing or a longer domain.", length(d), "xyz"[d], support));
}

template struct PeriodicBox<2>;
template struct PeriodicBox<3>;

}  // namespace isph
