// SPDX-License-Identifier: GPL-3.0-or-later
// Short-hands of the tests of shapes and fillings.
#pragma once
#include "case/Fill.hpp"
#include "case/SoilField.hpp"
#include "case/WallLayers.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace isph::test {

inline ShapeContext contextOf(int dimension)
{
    ShapeContext c;
    c.dimension = dimension;
    c.domain = {{{-1, -1, dimension == 2 ? 0.0 : -1.0}}, {{2, 2, dimension == 2 ? 0.0 : 2.0}}};
    c.caseDir = std::filesystem::temp_directory_path();
    return c;
}

inline std::unique_ptr<Shape> shapeOf(const std::string& text, int dimension)
{
    return readShape(Dictionary::parse(text, "shape"), contextOf(dimension));
}

/// A particlesDict from its text; periodic directions as in "xy".
inline CaseGeometry geometryOf(const std::string& text, const std::string& periodic = "")
{
    std::array<bool, 3> p{};
    for (char c : periodic) p[c - 'x'] = true;
    return readGeometry(Dictionary::parse(text, "particlesDict"), p,
                        std::filesystem::temp_directory_path());
}

/// The message of the FatalError that f throws; fails the test if it throws none.
template <class F>
std::string messageOf(F&& f)
{
    try {
        f();
    } catch (const FatalError& error) {
        return error.what();
    }
    ADD_FAILURE() << "no error was raised";
    return "";
}

inline bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

/// Distance to the nearest other point, images across periodic faces included.
inline Real nearestPair(const CaseGeometry& g, const std::vector<Point>& x)
{
    const PeriodicPoints all(g, x, 2 * g.spacing);
    const PointGrid grid(2 * g.spacing, all.x);
    Real least = 1e300;
    for (std::size_t i = 0; i < x.size(); ++i)
        grid.forEachWithin(x[i], 4 * g.spacing, [&](Index k, const Point& r) {
            if (k != static_cast<Index>(i)) least = std::min(least, norm(r));
        });
    return least;
}

/// sum_j V_j W(x - x_j) over the points and their images; 1 on an endless lattice (to 1e-3 for h
/// = 1.5 d0).
class KernelSum {
public:
    KernelSum(const CaseGeometry& g, Real h) : g_(g), h_(h), grid_(2 * h) {}
    void add(const std::vector<Point>& x, const std::vector<Real>& volume)
    {
        const PeriodicPoints all(g_, x, 2 * h_);
        for (std::size_t k = 0; k < all.x.size(); ++k) {
            grid_.add(all.x[k]);
            volume_.push_back(volume[all.owner[k]]);
        }
    }
    Real at(const Point& x) const
    {
        const PackingKernel kernel{g_.dimension};
        Real sum = 0;
        grid_.forEachWithin(
            x, 2 * h_, [&](Index k, const Point& r) { sum += volume_[k] * kernel.w(norm(r), h_); });
        return sum;
    }

private:
    const CaseGeometry& g_;
    Real h_;
    PointGrid grid_;
    std::vector<Real> volume_;
};

}  // namespace isph::test
