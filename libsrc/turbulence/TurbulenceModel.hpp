// SPDX-License-Identifier: GPL-3.0-or-later
// Eddy viscosity of the free water.                                                   [theory 8]
#pragma once
#include "core/Types.hpp"
#include "selection/ModelTable.hpp"

#include <string>

namespace isph {

class TurbulenceModel {
public:
    static constexpr const char* family = "turbulenceModel";
    using Table = ModelTable<TurbulenceModel>;
    static Table& table();
    /// The model that constant/turbulenceProperties names, with its <type>Coeffs.
    static std::unique_ptr<TurbulenceModel> select(const Dictionary& turbulenceProperties);

    virtual ~TurbulenceModel() = default;

    /// False where nuT is 0 everywhere: strain rates then need not be computed at all.
    virtual bool active() const = 0;
    /// in   strainRate[N] = |S| = sqrt(2 S:S) [1/s], S the symmetric gradient of the pore velocity;
    ///      porosity[N], 0 < eps <= 1;  spacing d0 [m], the width of the filter
    /// out  nuT[N] [m2/s], overwritten; 0 inside the pores (shear between grains is part of the
    ///      drag already, and the Darcy velocity has none that an eddy viscosity could be made of)
    virtual void eddyViscosity(Span<const Real> strainRate, Span<const Real> porosity, Real spacing,
                               Span<Real> nuT) const = 0;
    /// The formula in one line with its coefficients, for the log.
    virtual std::string formula() const = 0;
};

}  // namespace isph
