// SPDX-License-Identifier: GPL-3.0-or-later
// Smoothing kernels, W(r, h) = sigma_D/h^D w(q), q = r/h.                          [theory (2.1)]
#pragma once
#include "core/Types.hpp"
#include "selection/ModelTable.hpp"

namespace isph {

/// A kernel's shape. Families of particles are evaluated array by array: one virtual call a row,
/// none a pair.
class Kernel {
public:
    static constexpr const char* family = "kernel";
    using Table = ModelTable<Kernel>;
    static Table& table();
    /// The kernel named by the word at `key` of `dict`.
    static std::unique_ptr<Kernel> select(const Dictionary& dict, std::string_view key = "kernel");

    virtual ~Kernel() = default;

    /// Radius of the support in units of h: 2, quintic spline 3.
    virtual Real supportRadius() const = 0;
    /// sigma_D, so that the integral of W over the support is 1.
    virtual Real normalisation(int dimension) const = 0;
    /// w[k] = w(q_k) and slope[k] = w'(q_k)/q_k (its limit at q = 0), for q >= 0. Beyond the
    /// support both are 0.
    virtual void evaluate(Span<const Real> q, Span<Real> w, Span<Real> slope) const = 0;
};

/// sum_j d0^D W(x_j, h) over a full lattice of spacing d0 with a point at x = 0, in 2 or 3
/// dimensions.
Real latticeSum(const Kernel& kernel, int dimension, Real hOverSpacing);

/// lambda = -sum V x.gradW over a full lattice, about the dimension.                 [theory (2.7)]
Real latticeSupport(const Kernel& kernel, int dimension, Real hOverSpacing);

}  // namespace isph
