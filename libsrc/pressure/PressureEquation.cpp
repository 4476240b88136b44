// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/PressureEquation.hpp"

#include <algorithm>

namespace isph {

void PressureRows::number(const std::vector<SurfaceRole>& role, Index water)
{
    row.assign(water, -1);
    particle.clear();
    for (Index i = 0; i < water; ++i)
        if (role[i] != SurfaceRole::surface) {
            row[i] = static_cast<Index>(particle.size());
            particle.push_back(i);
        }
}

namespace {
/// D_i: divergence of the drag-damped predictor, each pair through the face between its partners.  (5.2)
/// Along a soil surface water keeps its own damping, so that soil is no no-slip wall to it.
template <int Dim, class Medium>
Vec<Dim> pairFlux(const Medium& medium, Index i, Index j, Real s_i, const Vec<Dim>& w_i, const Vec<Dim>& w_j)
{
    if constexpr (!Medium::hasSoil) {
        return w_j - w_i;
    } else {
        const Vec<Dim> sum = w_i + w_j;
        const Vec<Dim> n = medium.normal(i, j);
        const Real across = dot(sum, n);
        return s_i * (sum - 2 * w_i) + (medium.damping(i, j) - s_i) * across * n;
    }
}

void countEntries(const PressureRows& rows, const auto& pairs, const auto& points, const auto& role,
                  SymmetricMatrix& matrix)
{
    matrix.rowStart.assign(rows.size() + 1, 0);
    parallelForDynamic(rows.size(), [&](Index r) {
        PairIndex entries = 0;
        pairs.forWater(rows.particle[r], [&](const auto& pair) {
            entries += role[points.owner[pair.j]] != SurfaceRole::surface;
        });
        matrix.rowStart[r + 1] = entries;
    });
    for (std::size_t r = 0; r < rows.size(); ++r) matrix.rowStart[r + 1] += matrix.rowStart[r];
    matrix.column.resize(matrix.rowStart.back());
    matrix.offDiagonal.resize(matrix.rowStart.back());
    matrix.diagonal.resize(rows.size());
}

/// Images stand behind the water in a row of pairs: their columns are moved to their places.
void sortRow(SymmetricMatrix& matrix, PairIndex first, PairIndex last)
{
    for (PairIndex k = first + 1; k < last; ++k)
        for (PairIndex m = k; m > first && matrix.column[m] < matrix.column[m - 1]; --m) {
            std::swap(matrix.column[m], matrix.column[m - 1]);
            std::swap(matrix.offDiagonal[m], matrix.offDiagonal[m - 1]);
        }
}
}  // namespace

template <int Dim, class Medium>
void assemble(const Points<Dim>& points, const PairList<Dim>& pairs, const Corrections<Dim>& corrections,
              const std::vector<SurfaceRole>& role, const Medium& medium,
              const PressureSource<Dim>& source, const PressureRows& rows, SymmetricMatrix& matrix,
              std::vector<Real>& rhs, std::vector<char>& anchored)
{
    countEntries(rows, pairs, points, role, matrix);
    rhs.resize(rows.size());
    anchored.assign(rows.size(), 0);
    parallelForDynamic(rows.size(), [&](Index r) {
        const Index i = rows.particle[r];
        const Real V_i = points.volume[i], s_i = medium.damping(i);
        const Vec<Dim> w_i = source.v[i];
        Real diagonal = 0, gravity = 0;
        Real divergence = 0, known = 0;
        PairIndex entry = matrix.rowStart[r];
        pairs.forWater(i, [&](const auto& pair) {
            const Index j = pair.j, owner = points.owner[j];
            const Real weight = points.volume[j] * pair.F() * medium.beta(i, j);
            diagonal += weight;
            gravity -= weight * dot(source.force, pair.x_ij);
            const Vec<Dim> gradient = corrections.L[i] * pair.gradW();
            divergence += points.volume[j] * dot(pairFlux<Dim>(medium, i, j, s_i, w_i, source.v[j]), gradient);
            if (role[owner] == SurfaceRole::surface) {
                anchored[r] = 1;
                if (!source.surfacePressure.empty()) known += weight * source.surfacePressure[owner];
                return;
            }
            matrix.column[entry] = rows.row[owner];
            matrix.offDiagonal[entry++] = -V_i * weight;
        });
        pairs.forWalls(i, [&](const auto& pair) {   // walls at rest
            divergence -= points.volume[pair.j] * s_i * dot(w_i, corrections.L[i] * pair.gradW());
        });
        Real deferred = 0;
        if (role[i] == SurfaceRole::near) {
            const Vec<Dim> c = atMost(source.forceGradient[i], norm(source.force));
            deferred = -medium.beta(i) * dot(c, corrections.lopsided[i]);
        }
        matrix.diagonal[r] = V_i * diagonal;
        rhs[r] = -V_i * (divergence - source.divergence[i] + gravity + deferred - known);
        if (points.images() > 0) sortRow(matrix, matrix.rowStart[r], matrix.rowStart[r + 1]);
    });
    // A row without neighbours has no pressure; a one keeps the matrix positive definite.
    parallelFor(rows.size(), [&](Index r) {
        if (matrix.diagonal[r] <= 0) matrix.diagonal[r] = 1, rhs[r] = 0, anchored[r] = 1;
    });
}

#define ISPH_INSTANTIATE(Dim, Medium)                                                                   \
    template void assemble(const Points<Dim>&, const PairList<Dim>&, const Corrections<Dim>&,           \
                           const std::vector<SurfaceRole>&, const Medium<Dim>&,                         \
                           const PressureSource<Dim>&, const PressureRows&, SymmetricMatrix&,           \
                           std::vector<Real>&, std::vector<char>&);
ISPH_INSTANTIATE(2, ClearWater)
ISPH_INSTANTIATE(3, ClearWater)
ISPH_INSTANTIATE(2, WaterInSoil)
ISPH_INSTANTIATE(3, WaterInSoil)
#undef ISPH_INSTANTIATE

}  // namespace isph
