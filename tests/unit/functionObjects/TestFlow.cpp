// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestFlow.hpp"

#include <map>
#include <random>

namespace isph::test {

namespace {
const Kernel* kernelNamed(const std::string& name)
{
    static std::map<std::string, std::unique_ptr<Kernel>> all;
    auto& kernel = all[name];
    if (!kernel) kernel = Kernel::select(Dictionary::parse("kernel " + name + ";"));
    return kernel.get();
}
}  // namespace

FlowView emptyTank(const Tank& tank)
{
    FlowView flow;
    flow.dimension = tank.dimension;
    flow.spacing = tank.spacing;
    flow.density = 1000;
    flow.gravity = {0, -9.81, 0};
    flow.kernel = kernelNamed(tank.kernel);
    flow.smoothingRatio = tank.smoothingRatio;
    const int layers = 4;
    const auto count = [&](Real l) { return static_cast<int>(std::lround(l / tank.spacing)); };
    const int nx = count(tank.length), ny = count(tank.height);
    const int nz = tank.dimension == 3 ? count(tank.width) : 1;
    const int deep = tank.dimension == 3 ? layers : 0;
    for (int k = -deep; k < nz + deep; ++k)
        for (int j = -layers; j < ny; ++j)
            for (int i = -layers; i < nx + layers; ++i) {
                const bool inside = i >= 0 && i < nx && j >= 0 && k >= 0 && k < nz;
                if (inside) continue;
                const Real z = tank.dimension == 3 ? (k + 0.5) * tank.spacing : 0;
                flow.wallPosition.push_back(
                    {(i + 0.5) * tank.spacing, (j + 0.5) * tank.spacing, z});
                flow.wallVolume.push_back(tank.dimension == 2 ? sqr(tank.spacing)
                                                              : cube(tank.spacing));
            }
    flow.scalars["p"];
    flow.vectors["U"];
    return flow;
}

void addWater(FlowView& flow, const Vector3& low, const Vector3& high, Real porosity)
{
    const Real s = flow.spacing / std::pow(porosity, 1.0 / flow.dimension);
    const Real tiny = 1e-9 * s;
    std::array<std::vector<Real>, 3> line;
    for (int d = 0; d < flow.dimension; ++d)
        for (Real x = low[d] + 0.5 * s; x < high[d] - tiny; x += s) line[d].push_back(x);
    if (flow.dimension == 2) line[2] = {0};
    for (const Real z : line[2])
        for (const Real y : line[1])
            for (const Real x : line[0]) {
                flow.id.push_back(static_cast<std::int64_t>(flow.position.size()));
                flow.position.push_back({x, y, z});
                flow.porosity.push_back(porosity);
                flow.scalars["p"].push_back(0);
                flow.vectors["U"].push_back({});
            }
}

void jitter(FlowView& flow, Real share)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<Real> uniform(-share, share);
    for (std::size_t i = 0; i < flow.position.size(); ++i)
        for (int d = 0; d < flow.dimension; ++d)
            flow.position[i][d] +=
                uniform(random) * flow.spacing / std::pow(flow.porosity[i], 1.0 / flow.dimension);
}

Vector3 turned(const Vector3& x, Real angle)
{
    const Real c = std::cos(angle), s = std::sin(angle);
    return {c * x[0] - s * x[1], s * x[0] + c * x[1], x[2]};
}

void turn(FlowView& flow, Real angle)
{
    for (Vector3& x : flow.position) x = turned(x, angle);
    for (Vector3& x : flow.wallPosition) x = turned(x, angle);
    flow.gravity = turned(flow.gravity, angle);
}

void setPressure(FlowView& flow, const std::function<Real(const Vector3&)>& p)
{
    flow.scalars["p"].clear();
    for (const Vector3& x : flow.position) flow.scalars["p"].push_back(p(x));
}

void setVelocity(FlowView& flow, const std::function<Vector3(const Vector3&)>& u)
{
    flow.vectors["U"].clear();
    for (const Vector3& x : flow.position) flow.vectors["U"].push_back(u(x));
}

std::unique_ptr<FunctionObject> make(const std::string& text)
{
    const Dictionary dict = Dictionary::parse(text, "controlDict");
    return FunctionObject::table().make(dict.get<std::string>("type"), dict, dict, "type");
}

}  // namespace isph::test
