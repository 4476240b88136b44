// SPDX-License-Identifier: GPL-3.0-or-later
#include "functionObjects/FunctionObject.hpp"
#include "functionObjects/KernelField.hpp"

#include "core/Parallel.hpp"

#include <fmt/core.h>

namespace isph {
namespace {

/// Fields at points, interpolated by moving least squares (KernelField.hpp): exact for linear
/// fields where the neighbours carry a gradient, also in the surface of a wall. A point that is not
/// in the water (Shares::inWater) gives 0 for every field, the pressure of the air.
///   fields (p U mag(U));   a scalar gives one column a point, a vector one a component (x y, in
///   3-D z), mag(...) the magnitude of the interpolated vector.
class Probes : public FunctionObject {
public:
    static Schema keys()
    {
        return keysWith(
            {Key::list("fields",
                       "Fields of the water: p, U, UDarcy, porosity, ...; mag(U): its magnitude."),
             Key::list("probeLocations", "Points ((x y z) ...), or ((x y) ...) in 2-D.")
                 .units(dims::length)});
    }

    explicit Probes(const Dictionary& dict)
        : dict_(dict), points_(dict.get<std::vector<Vector3>>("probeLocations", dims::length))
    {
        if (points_.empty()) dict.fail("probeLocations", "probeLocations holds no point");
        for (const Token& token : dict.tokens("fields")) readName(token);
        if (quantities_.empty()) dict.fail("fields", "fields holds no name");
    }

    std::vector<Real> measure(const FlowView& flow) override
    {
        for (Quantity& quantity : quantities_) quantity.find(flow, dict_);
        dimension_ = flow.dimension;
        requireInDomain(flow);
        const KernelField field(flow);
        const std::size_t width = columnsOfPoint().size();
        std::vector<Real> row(points_.size() * width);
        parallelFor(points_.size(), [&](Index p) {
            sample(field, pointIn(flow, points_[p]), Span<Real>(row).subspan(p * width, width));
        });
        return row;
    }

    std::vector<std::string> columns() const override
    {
        std::vector<std::string> all;
        for (std::size_t p = 0; p < points_.size(); ++p)
            for (const std::string& name : columnsOfPoint())
                all.push_back(fmt::format("{}_{}", name, p));
        return all;
    }

    std::vector<std::string> header() const override
    {
        std::vector<std::string> lines;
        for (std::size_t p = 0; p < points_.size(); ++p)
            lines.push_back(
                fmt::format("Probe {} ({} {} {})", p, points_[p][0], points_[p][1], points_[p][2]));
        return lines;
    }

private:
    struct Quantity {
        std::string field;
        bool magnitude = false;
        const std::vector<Real>* scalar = nullptr;
        const std::vector<Vector3>* vector = nullptr;

        void find(const FlowView& flow, const Dictionary& dict)
        {
            const auto asScalar = flow.scalars.find(field);
            const auto asVector = flow.vectors.find(field);
            scalar = asScalar == flow.scalars.end() || magnitude ? nullptr : &asScalar->second;
            vector = asVector == flow.vectors.end() ? nullptr : &asVector->second;
            if (scalar || vector) return;
            std::vector<std::string> names;
            if (!magnitude)
                for (const auto& entry : flow.scalars) names.push_back(entry.first);
            for (const auto& entry : flow.vectors) names.push_back(entry.first);
            dict.fail("fields", fmt::format("Unknown {} {}\n\nValid ones are:\n\n{}",
                                            magnitude ? "vector field in mag" : "field", field,
                                            listOf(names)));
        }
    };

    /// A probe that can never see water is a slip of the pen.
    void requireInDomain(const FlowView& flow) const
    {
        for (const Vector3& x : points_)
            for (int d = 0; d < flow.dimension; ++d)
                if (flow.domainMin[d] < flow.domainMax[d] &&
                    (x[d] < flow.domainMin[d] || x[d] > flow.domainMax[d]))
                    dict_.fail("probeLocations",
                               fmt::format("the probe ({} {} {}) lies outside the domain, which is "
                                           "{} to {} along {}",
                                           x[0], x[1], x[2], flow.domainMin[d], flow.domainMax[d],
                                           "xyz"[d]));
    }

    void readName(const Token& token)
    {
        // The dictionary's list (p mag(U)) comes as the marks ( p mag ( U ) ) or with mag(U) as one
        // word.
        if (token.kind == Token::Kind::punctuation || token.kind == Token::Kind::number) return;
        if (token.text == "mag") {
            pendingMagnitude_ = true;
            return;
        }
        Quantity quantity{token.text, pendingMagnitude_};
        pendingMagnitude_ = false;
        if (token.text.starts_with("mag(") && token.text.ends_with(")"))
            quantity = {token.text.substr(4, token.text.size() - 5), true};
        quantities_.push_back(quantity);
    }

    std::vector<std::string> columnsOfPoint() const
    {
        constexpr const char* component[] = {"x", "y", "z"};
        std::vector<std::string> names;
        for (const Quantity& quantity : quantities_)
            if (quantity.magnitude)
                names.push_back("mag(" + quantity.field + ")");
            else if (quantity.scalar)
                names.push_back(quantity.field);
            else
                for (int d = 0; d < dimension_; ++d)
                    names.push_back(quantity.field + "_" + component[d]);
        return names;
    }

    void sample(const KernelField& field, const Vec<3>& x, Span<Real> values) const
    {
        if (!field.shares(x).inWater()) return;
        KernelSamples samples;
        field.gatherOneSide(x, samples);
        const std::vector<Real> weights =
            interpolationWeights(samples, dimension_, field.water().reach());
        std::size_t k = 0;
        for (const Quantity& quantity : quantities_) {
            if (quantity.scalar) {
                for (std::size_t j = 0; j < samples.size(); ++j)
                    values[k] += weights[j] * (*quantity.scalar)[samples.owner[j]];
                ++k;
                continue;
            }
            Vec<3> value{};
            for (std::size_t j = 0; j < samples.size(); ++j)
                value += weights[j] * toVec((*quantity.vector)[samples.owner[j]]);
            if (quantity.magnitude)
                values[k++] = norm(value);
            else
                for (int d = 0; d < dimension_; ++d) values[k++] = value[d];
        }
    }

    Dictionary dict_;
    std::vector<Vector3> points_;
    std::vector<Quantity> quantities_;
    bool pendingMagnitude_ = false;
    int dimension_ = 0;
};

const FunctionObject::Table::Entry<Probes> entry{"probes"};

}  // namespace
}  // namespace isph
