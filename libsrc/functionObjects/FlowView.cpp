// SPDX-License-Identifier: GPL-3.0-or-later
#include "functionObjects/FlowView.hpp"

#include <fmt/core.h>

#include <cmath>

namespace isph {

namespace {
Real power(Real a, int dimension)
{
    return dimension == 2 ? sqr(a) : cube(a);
}

template <class Field>
const Field& named(const std::map<std::string, Field>& fields, const std::string& name,
                   const char* kind)
{
    const auto it = fields.find(name);
    if (it != fields.end()) return it->second;
    std::vector<std::string> names;
    for (const auto& [other, field] : fields) names.push_back(other);
    throw FatalError(fmt::format("There is no {} field {}.\n\nThe {} fields are:\n\n{}", kind, name,
                                 kind, listOf(names)));
}
}  // namespace

Real FlowView::particleMass() const
{
    return density * power(spacing, dimension);
}

Real FlowView::smoothingLength(std::size_t i) const
{
    const Real eps = porosity[i];
    return smoothingRatio * spacing / (dimension == 2 ? std::sqrt(eps) : std::cbrt(eps));
}

Real FlowView::occupiedVolume(std::size_t i) const
{
    return power(spacing, dimension) / porosity[i];
}

const std::vector<Real>& FlowView::scalar(const std::string& name) const
{
    return named(scalars, name, "scalar");
}

const std::vector<Vector3>& FlowView::vector(const std::string& name) const
{
    return named(vectors, name, "vector");
}

}  // namespace isph
