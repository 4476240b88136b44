// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrator/PressureStage.hpp"

#include "pressure/RowPlaces.hpp"

namespace isph {

template <int Dim>
template <class Medium>
void PressureStage<Dim>::solve(Scene<Dim>& scene, const Medium& medium,
                               const PressureSource<Dim>& source, Span<const Real> rowFactor,
                               Timers& timers, StepFields<Dim>& fields, StepReport& report)
{
    const Points<Dim>& points = fields.points;
    Water<Dim>& water = scene.water;
    const Real rho = scene.scheme.density;
    SymmetricMatrix matrix;
    {
        const auto timer = timers.scope("pressure assembly");
        fields.pairs.releaseRecords();   // the matrix takes the place of the predictor's
        rows_.number(fields.role, points.water);
        assemble(points, fields.pairs, fields.corrections, fields.role, medium, source, rows_,
                 matrix, rhs_, anchored_);
        placeRows(points, rows_.particle, matrix.places);
        if (!rowFactor.empty())
            parallelFor(rows_.size(), [&](Index r) { rhs_[r] *= rowFactor[rows_.particle[r]]; });
    }
    const auto timer = timers.scope("pressure solve");
    unknown_.resize(rows_.size());
    parallelFor(rows_.size(), [&](Index r) { unknown_[r] = water.p[rows_.particle[r]] / rho; });
    const FloatingComponents& floating = components_.find(matrix, anchored_);
    makeSolvable(matrix, rhs_, floating);
    startAtZero(unknown_, floating);
    // Of the memory of a step, its arrays and the solver's are never needed at once.
    fields.pairs.releaseRecords();
    report.pressure = scene.solver->solve(matrix, rhs_, unknown_);
    scene.solver->rest();
    removeMean(unknown_, floating);
    report.unknowns = rows_.size();
    report.surfaceParticles = points.water - static_cast<Index>(rows_.size());
    fields.p.resize(points.fluid);
    const auto atSurface = [&](Index i) {
        return source.surfacePressure.empty() ? 0 : source.surfacePressure[i];
    };
    parallelFor(points.water, [&](Index i) {
        fields.p[i] = rows_.row[i] < 0 ? atSurface(i) : unknown_[rows_.row[i]];
        water.p[i] = rho * fields.p[i];
    });
    points.refresh(fields.p);
}

#define ISPH_INSTANTIATE(Dim, Medium)                                                              \
    template void PressureStage<Dim>::solve(Scene<Dim>&, const Medium<Dim>&,                       \
                                            const PressureSource<Dim>&, Span<const Real>, Timers&, \
                                            StepFields<Dim>&, StepReport&);
ISPH_INSTANTIATE(2, ClearWater)
ISPH_INSTANTIATE(3, ClearWater)
ISPH_INSTANTIATE(2, WaterInSoil)
ISPH_INSTANTIATE(3, WaterInSoil)
#undef ISPH_INSTANTIATE

}  // namespace isph
