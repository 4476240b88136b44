// SPDX-License-Identifier: GPL-3.0-or-later
// A user's model: a = 0.001 1/s, b as given.
#include "porous/PorousModel.hpp"

namespace isph {

class QuadraticDrag : public PorousModel {
public:
    static Schema keys()
    {
        return {Key::scalar("porosity", "share of the pores").above(0).below(1),
                Key::scalar("b", "quadratic resistance [1/m]").atLeast(0)};
    }

    explicit QuadraticDrag(const Dictionary& dict)
        : PorousModel(keys().get<Real>(dict, "porosity")), b_(keys().get<Real>(dict, "b"))
    {
    }

    Resistance resistance(Real, Real) const override { return {1e-3, b_}; }
    std::string formula() const override
    {
        return "quadraticDrag: a = 0.001, b from the dictionary";
    }

private:
    Real b_;
};

namespace {
const PorousModel::Table::Entry<QuadraticDrag> entry{"quadraticDrag"};
}

}  // namespace isph
