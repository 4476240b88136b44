// SPDX-License-Identifier: GPL-3.0-or-later
// Periodic directions: particles wrap around, and images of those near a side stand beyond the
// other.
#pragma once
#include "particles/Particles.hpp"
#include "particles/Points.hpp"

#include <array>

namespace isph {

/// The box that a scene repeats in some directions.
template <int Dim>
struct PeriodicBox {
    Vec<Dim> min{}, max{};
    std::array<bool, Dim> periodic{};

    bool any() const
    {
        for (const bool p : periodic)
            if (p) return true;
        return false;
    }
    Real length(int d) const { return max[d] - min[d]; }
    /// Into [min, max) along the periodic directions.
    Vec<Dim> wrap(Vec<Dim> x) const;
    /// f(shift) for every image of x that stands within `reach` outside the box, x itself excepted.
    template <class F>
    void forImages(const Vec<Dim>& x, Real reach, F&& f) const;
    /// Throws FatalError unless every periodic length is at least two supports (four smoothing
    /// lengths), so that a particle and its image are never both neighbours of a third.
    void requireLength(Real support) const;
};

template <int Dim>
template <class F>
void PeriodicBox<Dim>::forImages(const Vec<Dim>& x, Real reach, F&& f) const
{
    std::array<int, Dim> low{}, high{};
    for (int d = 0; d < Dim; ++d) {
        if (!periodic[d]) continue;
        if (x[d] + length(d) < max[d] + reach) high[d] = 1;
        if (x[d] - length(d) > min[d] - reach) low[d] = -1;
    }
    const auto emit = [&](const std::array<int, Dim>& k) {
        Vec<Dim> shift;
        bool self = true;
        for (int d = 0; d < Dim; ++d) {
            shift[d] = k[d] * length(d);
            self = self && k[d] == 0;
        }
        if (!self) f(shift);
    };
    std::array<int, Dim> k = low;
    for (bool more = true; more;) {
        emit(k);
        more = false;
        for (int d = 0; d < Dim && !more; ++d) {
            if (k[d] < high[d]) ++k[d], more = true;
            else k[d] = low[d];
        }
    }
}

extern template struct PeriodicBox<2>;
extern template struct PeriodicBox<3>;

}  // namespace isph
