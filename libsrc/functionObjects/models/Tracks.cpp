// SPDX-License-Identifier: GPL-3.0-or-later
#include "functionObjects/FunctionObject.hpp"
#include "functionObjects/KernelField.hpp"

#include "core/Error.hpp"

#include <fmt/format.h>

#include <unordered_map>

namespace isph {
namespace {

/// Ways of single particles: for each point the particle that is nearest to it at the first
/// measurement, its id and its place [m] from then on. Through a periodic end it comes in at the
/// other. A particle that leaves the flow ends the run with an error.
class Tracks : public FunctionObject {
public:
    static Schema keys()
    {
        return keysWith({Key::list("points", "Points ((x y z) ...), or ((x y) ...) in 2-D.")
                             .units(dims::length)});
    }

    explicit Tracks(const Dictionary& dict)
        : dict_(dict), points_(dict.get<std::vector<Vector3>>("points", dims::length))
    {
        if (points_.empty()) dict.fail("points", "points holds no point");
    }

    bool measuresAtEnd() const override { return true; }

    std::vector<Real> measure(const FlowView& flow) override
    {
        dimension_ = flow.dimension;
        if (ids_.empty()) choose(flow);
        std::unordered_map<std::int64_t, std::size_t> place;
        for (std::size_t i = 0; i < flow.id.size(); ++i) place[flow.id[i]] = i;
        std::vector<Real> row;
        for (const std::int64_t id : ids_) {
            const auto it = place.find(id);
            if (it == place.end())
                throw FatalError(
                    fmt::format("Function object {}: particle {} is not in the flow at "
                                "time {}",
                                dict_.scopeName(), id, flow.time));
            row.push_back(static_cast<Real>(id));
            for (int d = 0; d < dimension_; ++d) row.push_back(flow.position[it->second][d]);
        }
        return row;
    }

    std::vector<std::string> columns() const override
    {
        std::vector<std::string> names;
        for (std::size_t k = 0; k < points_.size(); ++k) {
            names.push_back(fmt::format("id_{}", k));
            for (int d = 0; d < dimension_; ++d)
                names.push_back(fmt::format("{}_{}", static_cast<char>('x' + d), k));
        }
        return names;
    }

    std::vector<std::string> header() const override { return {"places [m] of particles"}; }

    void resume(Span<const Real> first) override
    {
        const std::size_t width = first.size() / points_.size();
        if (width * points_.size() != first.size() || width < 3) return;
        for (std::size_t k = 0; k < points_.size(); ++k)
            ids_.push_back(static_cast<std::int64_t>(first[k * width]));
    }

private:
    void choose(const FlowView& flow)
    {
        for (const Vector3& point : points_) {
            const Vec<3> x = pointIn(flow, point);
            std::size_t nearest = 0;
            for (std::size_t i = 1; i < flow.position.size(); ++i)
                if (normSqr(toVec(flow.position[i]) - x) <
                    normSqr(toVec(flow.position[nearest]) - x))
                    nearest = i;
            if (flow.id.empty()) throw FatalError("tracks: there is no water to follow");
            ids_.push_back(flow.id[nearest]);
        }
    }

    Dictionary dict_;
    std::vector<Vector3> points_;
    std::vector<std::int64_t> ids_;
    int dimension_ = 2;
};

const FunctionObject::Table::Entry<Tracks> entry{"tracks"};

}  // namespace
}  // namespace isph
