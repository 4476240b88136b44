// SPDX-License-Identifier: GPL-3.0-or-later
// Points for tests: lattices, shaken ones, and the points of a step made of them.
#pragma once
#include "core/Parallel.hpp"
#include "kernels/Kernel.hpp"
#include "neighbours/PairList.hpp"

#include <random>
#include <string>
#include <vector>

namespace isph {

inline std::unique_ptr<Kernel> kernelNamed(const std::string& name)
{
    return Kernel::select(Dictionary::parse("kernel " + name + ";"));
}

/// Cell centres of a lattice with `count` cells from min to max.
template <int Dim>
std::vector<Vec<Dim>> lattice(const Vec<Dim>& min, const Vec<Dim>& max, std::array<int, Dim> count)
{
    std::vector<Vec<Dim>> x(1, min);
    for (int d = 0; d < Dim; ++d) {
        std::vector<Vec<Dim>> more;
        for (const Vec<Dim>& p : x)
            for (int k = 0; k < count[d]; ++k) {
                more.push_back(p);
                more.back()[d] += (k + 0.5) * (max[d] - min[d]) / count[d];
            }
        x = more;
    }
    return x;
}

/// Every point moved by at most `amount` along each axis, the same way in every run.
template <int Dim>
void shake(std::vector<Vec<Dim>>& x, Real amount)
{
    std::mt19937 generator(7);
    for (Vec<Dim>& p : x)
        for (int d = 0; d < Dim; ++d)
            p[d] += amount * (2 * (static_cast<Real>(generator()) / 4294967296.0) - 1);
}

/// A block of n points along each axis, of unit spacing and volume, shaken by 0.2; h = 1.5.
template <int Dim>
Points<Dim> shakenPoints(int n)
{
    std::array<int, Dim> count;
    count.fill(n);
    Vec<Dim> max;
    for (int d = 0; d < Dim; ++d) max[d] = n;
    Points<Dim> points;
    points.x = lattice<Dim>({}, max, count);
    shake(points.x, 0.2);
    points.water = points.fluid = static_cast<Index>(points.x.size());
    points.volume.assign(points.x.size(), 1);
    points.h.assign(points.x.size(), 1.5);
    points.owner.resize(points.x.size());
    for (Index i = 0; i < points.water; ++i) points.owner[i] = i;
    return points;
}

/// h between 1.2 and 2.1, as in and around soil; volumes as h^Dim.
template <int Dim>
void varyWidths(Points<Dim>& points)
{
    for (Index i = 0; i < points.size(); ++i) {
        points.h[i] = 1.2 + 0.9 * ((i * 7919) % 101) / 100;
        points.volume[i] = std::pow(points.h[i] / 1.5, Dim);
    }
}

}  // namespace isph
