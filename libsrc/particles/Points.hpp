// SPDX-License-Identifier: GPL-3.0-or-later
// The points that pair sums run over, in four ranges:
//     [ water | images of water | walls | images of walls ]
//     0       water             fluid                     size()
// Rows of sums belong to water only; images (periodic ones now, those of other ranks later) are
// seen as partners.
#pragma once
#include "core/Parallel.hpp"
#include "core/Vec.hpp"

#include <array>
#include <vector>

namespace isph {

template <int Dim>
struct Points {
    Index water = 0;
    Index fluid = 0;
    std::vector<Vec<Dim>> x;
    /// M/(eps rho0) of water, that of wall particles if wetted, else 0 [m^D]
    std::vector<Real> volume;
    std::vector<Real> h;         ///< smoothing length [m]
    std::vector<Index> owner;  ///< of images: the water or wall number they copy; of others: itself

    Index size() const { return static_cast<Index>(x.size()); }
    Index images() const { return fluid - water; }

    /// Copies a field of the water particles to their images. field.size() >= fluid.
    template <class T>
    void refresh(std::vector<T>& field) const
    {
        parallelFor(images(), [&](Index k) { field[water + k] = field[owner[water + k]]; });
    }
};

}  // namespace isph
