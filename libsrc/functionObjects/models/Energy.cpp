// SPDX-License-Identifier: GPL-3.0-or-later
#include "functionObjects/FunctionObject.hpp"
#include "functionObjects/KernelField.hpp"

#include "core/Parallel.hpp"

#include <algorithm>
#include <limits>

namespace isph {
namespace {

/// Energy of the water, in 2-D per metre of width.
///   kinetic       sum m |u|^2/2 [J], u the pore velocity
///   potential     - sum m g.x [J], g with the uniform body force; it jumps where a particle leaves
///                 through a periodic end along g
///   total         their sum
///   change        of the total since the run began (through restarts, from the first row of its
///   file) gravityPower  sum m g.u [W], the rate at which gravity turns potential into kinetic
///   energy: what the
///                 kinetic energy gains less than its time integral is dissipated
///   maxSpeed      largest |u| [m/s]
class Energy : public FunctionObject {
public:
    static Schema keys() { return keysWith({}); }
    explicit Energy(const Dictionary&) {}

    std::vector<Real> measure(const FlowView& flow) override
    {
        const std::vector<Vector3>& u = flow.vector("U");
        const std::size_t n = flow.position.size();
        const Real mass = flow.particleMass();
        const Vec<3> g = toVec(flow.gravity);
        const Real kinetic =
            mass * orderedSum(n, [&](Index i) { return 0.5 * normSqr(toVec(u[i])); });
        const Real potential =
            -mass * orderedSum(n, [&](Index i) { return dot(g, toVec(flow.position[i])); });
        const Real power = mass * orderedSum(n, [&](Index i) { return dot(g, toVec(u[i])); });
        const Real fastest = orderedMax(n, 0, [&](Index i) { return norm(toVec(u[i])); });
        const Real total = kinetic + potential;
        if (std::isnan(start_)) start_ = total;
        return {kinetic, potential, total, total - start_, power, fastest};
    }

    std::vector<std::string> columns() const override { return kColumns; }

    std::vector<std::string> header() const override
    {
        return {"energies [J], in 2-D [J/m]; gravityPower [W]; maxSpeed [m/s]"};
    }

    void resume(Span<const Real> first) override
    {
        if (first.size() == kColumns.size()) start_ = first[2] - first[3];
    }

private:
    static inline const std::vector<std::string> kColumns{"kinetic", "potential",    "total",
                                                          "change",  "gravityPower", "maxSpeed"};
    Real start_ = std::numeric_limits<Real>::quiet_NaN();  ///< total at the beginning, none yet
};

const FunctionObject::Table::Entry<Energy> entry{"energy"};

}  // namespace
}  // namespace isph
