// SPDX-License-Identifier: GPL-3.0-or-later
#include "functionObjects/ExpectedField.hpp"
#include "functionObjects/FunctionObject.hpp"
#include "functionObjects/KernelField.hpp"

#include "case/Shape.hpp"
#include "core/Parallel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isph {
namespace {

constexpr const char* kComponent[] = {"x", "y", "z"};

/// A field as a dictionary names it: p, U, U.x or mag(U).
struct FieldName {
    std::string field;
    int component = -1;  ///< all of them
    bool magnitude = false;

    explicit FieldName(const std::string& text) : field(text)
    {
        if (text.starts_with("mag(") && text.ends_with(")")) {
            field = text.substr(4, text.size() - 5);
            magnitude = true;
        } else if (text.size() > 2 && text[text.size() - 2] == '.') {
            const char last = text.back();
            if (last < 'x' || last > 'z') return;
            component = last - 'x';
            field = text.substr(0, text.size() - 2);
        }
    }

    /// Columns of values: 1, or the dimension for a whole vector.
    int width(const FlowView& flow) const
    {
        return component < 0 && !magnitude && !flow.scalars.contains(field) ? flow.dimension : 1;
    }

    Vec<3> at(const FlowView& flow, Index i) const
    {
        const auto scalar = flow.scalars.find(field);
        if (scalar != flow.scalars.end()) return Vec<3>{{scalar->second[i]}};
        return toVec(flow.vectors.at(field)[i]);
    }

    /// What is compared, of an interpolated vector (a scalar stands in its first component).
    Vec<3> chosen(const Vec<3>& value) const
    {
        if (magnitude) return Vec<3>{{norm(value)}};
        return component < 0 ? value : Vec<3>{{value[component]}};
    }

    void require(const FlowView& flow, const Dictionary& dict) const
    {
        const bool asVector = component >= 0 || magnitude;
        if (flow.vectors.contains(field) || (!asVector && flow.scalars.contains(field))) return;
        std::vector<std::string> names;
        for (const auto& entry : flow.vectors) names.push_back(entry.first);
        if (!asVector)
            for (const auto& entry : flow.scalars) names.push_back(entry.first);
        dict.fail("field", fmt::format("Unknown {} {}\n\nValid ones are:\n\n{}",
                                       asVector ? "vector field" : "field", field, listOf(names)));
    }
};

struct Deviation {
    Real weight;   ///< [m^D], or 1 for a point
    Vec<3> error;  ///< measured less expected
    Real size;     ///< |expected|
};

/// Deviation e of a field from what it should be, over the water particles of a region, w_i their
/// occupied volume (theory 1.5), or over points (w = 1) at which it is interpolated (probes).
///   L1 = sum w |e|/sum w    L2 = sqrt(sum w |e|^2/sum w)    Linf = max |e|    bias = sum w e/sum w
///   samples   how many particles or points
/// of the vector if the field is one; its bias has a column for each component. All are divided by
/// `scale`. Points that are not in the water, and places or times that the reference does not reach
/// to, are left out; where nothing is left the run ends with an error.
class ErrorNorms : public FunctionObject {
public:
    static Schema keys()
    {
        Schema own{
            Key::text("field", "Field of the water: p, U, U.x, mag(U), porosity, ..."),
            Key::dictionary("region", "A shape: only the particles or points in it count.")
                .mayBeAbsent(),
            Key::word("at", "particles, the points given, or the places of a profile's rows.")
                .oneOf({"particles", "points", "profile"})
                .byDefault("particles"),
            Key::list("points", "With at points: ((x y z) ...).").units(dims::length).mayBeAbsent(),
            Key::vector("through", "With at profile: a point of its line.")
                .units(dims::length)
                .mayBeAbsent(),
            Key::text("scale",
                      "What the norms are divided by: an expression of t, or largest, of the "
                      "expected values.")
                .byDefault("\"1\""),
            Key::logical("upToConstant",
                         "Whether the bias is taken off first, as for a pressure without level.")
                .byDefault("no"),
        };
        for (const Key& key : ExpectedField::keys()) own.add(key);
        return keysWith(own);
    }

    explicit ErrorNorms(const Dictionary& dict)
        : dict_(dict),
          field_(keys().get<std::string>(dict, "field")),
          expected_(dict),
          scaleText_(keys().get<std::string>(dict, "scale")),
          upToConstant_(keys().get<bool>(dict, "upToConstant"))
    {
        readPlaces();
        if (scaleText_ == "largest") return;
        scale_.emplace(readExpression(dict, "scale", scaleText_, readConstants(dict)));
    }

    bool measuresAtEnd() const override { return true; }

    std::vector<Real> measure(const FlowView& flow) override
    {
        field_.require(flow, dict_);
        width_ = field_.width(flow);
        checkComponents();
        std::vector<Deviation> all =
            at_ == "particles" ? atParticles(flow) : atPoints(KernelField(flow));
        if (all.empty())
            throw FatalError(
                fmt::format("Function object {}: at time {} no particle or point is in the water, "
                            "in the region "
                            "and within the reference",
                            dict_.scopeName(), flow.time));
        return norms(std::move(all), flow.time);
    }

    std::vector<std::string> columns() const override
    {
        std::vector<std::string> names{"L1", "L2", "Linf"};
        if (width_ == 1)
            names.push_back("bias");
        else
            for (int d = 0; d < width_; ++d) names.push_back(fmt::format("bias_{}", kComponent[d]));
        names.push_back("samples");
        return names;
    }

    std::vector<std::string> header() const override
    {
        return {fmt::format("error of {} over {}, divided by {}",
                            dict_.tokens("field").front().text, at_, scaleText_)};
    }

private:
    void readPlaces()
    {
        at_ = keys().get<std::string>(dict_, "at");
        const auto belongs = [&](const char* key, const char* where) {
            if (dict_.found(key) == (at_ == where)) return;
            dict_.fail(key, fmt::format("{} belongs to at {}; it is {}", key, where,
                                        dict_.found(key) ? "here with at " + at_ : "missing"));
        };
        belongs("points", "points");
        belongs("through", "profile");
        if (at_ == "profile" && !expected_.isProfile())
            dict_.fail("at", "at profile needs a reference along x, y or z");
        if (at_ == "points") points_ = dict_.get<std::vector<Vector3>>("points", dims::length);
        if (at_ == "profile")
            points_ = expected_.profilePoints(dict_.get<Vector3>("through", dims::length));
    }

    void checkComponents() const
    {
        if (expected_.components() == width_ ||
            (width_ == 2 && expected_.components() == 3))  // z of a case of two dimensions
            return;
        dict_.fail(expected_.components() == 1 ? "field" : "expressions",
                   fmt::format("{} has {} components, but {} are expected of it",
                               dict_.tokens("field").front().text, width_, expected_.components()));
    }

    const Shape* region(const FlowView& flow)
    {
        if (!dict_.found("region") || region_) return region_.get();
        ShapeContext context;
        context.dimension = flow.dimension;
        context.domain.include(toVec(flow.domainMin));
        context.domain.include(toVec(flow.domainMax));
        region_ = readShape(dict_.subDict("region"), context);
        return region_.get();
    }

    bool counts(const Shape* region, const Vec<3>& x, Real time) const
    {
        return expected_.covers(x.c, time) && (!region || region->signedDistance(x) <= 0);
    }

    Deviation deviation(Real weight, const Vec<3>& measured, const Vec<3>& x, Real time) const
    {
        Vec<3> expected{}, error{};
        for (int d = 0; d < width_; ++d) {
            expected[d] = expected_.value(d, x.c, time);
            error[d] = measured[d] - expected[d];
        }
        return {weight, error, norm(expected)};
    }

    std::vector<Deviation> atParticles(const FlowView& flow)
    {
        const Shape* inside = region(flow);
        std::vector<Deviation> all;
        for (std::size_t i = 0; i < flow.position.size(); ++i) {
            const Vec<3> x = toVec(flow.position[i]);
            if (!counts(inside, x, flow.time)) continue;
            const Vec<3> measured = field_.chosen(field_.at(flow, static_cast<Index>(i)));
            all.push_back(deviation(flow.occupiedVolume(i), measured, x, flow.time));
        }
        return all;
    }

    std::vector<Deviation> atPoints(const KernelField& field)
    {
        const FlowView& flow = field.flow();
        const Shape* inside = region(flow);
        std::vector<Deviation> all;
        KernelSamples samples;
        for (const Vector3& point : points_) {
            const Vec<3> x = pointIn(flow, point);
            if (!counts(inside, x, flow.time) || !field.shares(x).inWater()) continue;
            field.gatherOneSide(x, samples);
            const std::vector<Real> weights =
                interpolationWeights(samples, flow.dimension, field.water().reach());
            Vec<3> value{};
            for (std::size_t k = 0; k < samples.size(); ++k)
                value += weights[k] * field_.at(flow, samples.owner[k]);
            all.push_back(deviation(1, field_.chosen(value), x, flow.time));
        }
        return all;
    }

    Real scaleAt(Real time, const std::vector<Deviation>& all) const
    {
        Real scale = scale_ ? std::abs((*scale_)({0, 0, 0}, time)) : 0;
        if (!scale_)
            for (const Deviation& one : all) scale = std::max(scale, one.size);
        if (scale > 0) return scale;
        throw FatalError(
            fmt::format("Function object {}: the scale {} is {} at time {}: errors "
                        "cannot be divided by it",
                        dict_.scopeName(), scaleText_, scale, time));
    }

    std::vector<Real> norms(std::vector<Deviation> all, Real time) const
    {
        const std::size_t n = all.size();
        const Real whole = orderedSum(n, [&](Index k) { return all[k].weight; });
        const Vec<3> bias =
            orderedSum(n, [&](Index k) { return all[k].weight * all[k].error; }) / whole;
        if (upToConstant_)
            for (Deviation& one : all) one.error -= bias;
        const Real first =
            orderedSum(n, [&](Index k) { return all[k].weight * norm(all[k].error); });
        const Real second =
            orderedSum(n, [&](Index k) { return all[k].weight * normSqr(all[k].error); });
        // Not orderedMax, which passes over what is no number.
        Real largest = 0;
        for (const Deviation& one : all)
            if (!(norm(one.error) <= largest)) largest = norm(one.error);
        const Real scale = scaleAt(time, all);
        std::vector<Real> row{first / whole / scale, std::sqrt(second / whole) / scale,
                              largest / scale};
        for (int d = 0; d < width_; ++d) row.push_back(bias[d] / scale);
        row.push_back(static_cast<Real>(n));
        return row;
    }

    Dictionary dict_;
    FieldName field_;
    ExpectedField expected_;
    std::string scaleText_;
    std::optional<FieldExpression> scale_;
    bool upToConstant_;
    std::string at_;
    std::vector<Vector3> points_;
    std::unique_ptr<Shape> region_;
    int width_ = 1;
};

const FunctionObject::Table::Entry<ErrorNorms> entry{"errorNorms"};

}  // namespace
}  // namespace isph
