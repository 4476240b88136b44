// SPDX-License-Identifier: GPL-3.0-or-later
#include "functionObjects/FunctionObject.hpp"
#include "functionObjects/KernelField.hpp"

#include "core/Parallel.hpp"

#include <fmt/format.h>

#include <cmath>

namespace isph {
namespace {

/// Where the water is: of its particles, all of one mass,                                     [m]
///   min_x, max_x      smallest and largest coordinate; the surface is half a spacing further out
///   centre_x          centre of mass
///   deviation_x       sqrt of the mean of (x - centre_x)^2: half a semi-axis of an ellipse in 2-D,
///                     1/sqrt(12) of the length of a block
/// and so in y and z; besides
///   angularMomentum   sum m ((x - centre) x (u - mean u))_z                    [kg m2/s], in 2-D
///   /m occupied          sum m/(eps rho0), the space that water and its soil fill         [m3],
///   2-D m2 particles         how many there are
class WaterExtent : public FunctionObject {
public:
    static Schema keys() { return keysWith({}); }
    explicit WaterExtent(const Dictionary&) {}

    bool measuresAtEnd() const override { return true; }

    std::vector<Real> measure(const FlowView& flow) override
    {
        dimension_ = flow.dimension;
        const std::size_t n = flow.position.size();
        const std::vector<Vector3>& u = flow.vector("U");
        const auto mean = [&](auto&& term) {
            return n == 0 ? Vec<3>{} : orderedSum(n, term) / static_cast<Real>(n);
        };
        const Vec<3> centre = mean([&](Index i) { return toVec(flow.position[i]); });
        const Vec<3> drift = mean([&](Index i) { return toVec(u[i]); });
        const Vec<3> square = mean([&](Index i) {
            Vec<3> a = toVec(flow.position[i]) - centre;
            for (int d = 0; d < 3; ++d) a[d] = sqr(a[d]);
            return a;
        });
        std::vector<Real> row;
        for (int d = 0; d < dimension_; ++d) {
            Real low = n == 0 ? 0 : flow.position[0][d], high = low;
            for (const Vector3& x : flow.position)
                low = std::min(low, x[d]), high = std::max(high, x[d]);
            row.insert(row.end(), {low, high, centre[d], std::sqrt(square[d])});
        }
        row.push_back(flow.particleMass() * orderedSum(n, [&](Index i) {
                          const Vec<3> r = toVec(flow.position[i]) - centre,
                                       v = toVec(u[i]) - drift;
                          return r[0] * v[1] - r[1] * v[0];
                      }));
        row.push_back(orderedSum(n, [&](Index i) { return flow.occupiedVolume(i); }));
        row.push_back(static_cast<Real>(n));
        return row;
    }

    std::vector<std::string> columns() const override
    {
        std::vector<std::string> names;
        for (int d = 0; d < dimension_; ++d)
            for (const char* what : {"min", "max", "centre", "deviation"})
                names.push_back(fmt::format("{}_{}", what, static_cast<char>('x' + d)));
        names.insert(names.end(), {"angularMomentum", "occupied", "particles"});
        return names;
    }

    std::vector<std::string> header() const override
    {
        return {
            "lengths [m]; angularMomentum [kg m2/s], in 2-D per metre; occupied [m3], 2-D [m2]"};
    }

private:
    int dimension_ = 2;
};

const FunctionObject::Table::Entry<WaterExtent> entry{"waterExtent"};

}  // namespace
}  // namespace isph
