// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/PressureEquation.hpp"

#include "operators/Gradient.hpp"

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
/// What the rows ask of a partner, side by side in memory.
template <int Dim>
struct Partner {
    /// Row: -1 at the surface
    enum Place : int {
        x = 0,
        v = Dim,
        volume = 2 * Dim,
        row,
        size = 8
    };
};

template <int Dim>
Records<Partner<Dim>::size> partnersOf(const Points<Dim>& points, const PairList<Dim>& pairs,
                                       const PressureRows& rows, Span<const Vec<Dim>> v)
{
    using P = Partner<Dim>;
    const auto partners = pairs.template records<P::size>();
    parallelFor(points.fluid, [&](Index i) {
        Real* to = partners[i];
        for (int d = 0; d < Dim; ++d) to[P::x + d] = points.x[i][d], to[P::v + d] = v[i][d];
        to[P::volume] = points.volume[i];
        to[P::row] = rows.row[i < points.water ? i : points.owner[i]];
    });
    return partners;
}

/// Sums over the water partners of a row, those of every lane apart.
template <int Dim, class Medium>
struct RowSum {
    using P = Partner<Dim>;
    const Medium& medium;
    Index i;
    const Real* own;
    Lanes diagonal{};
    std::array<Lanes, Dim> side{};   ///< sum V_i V_j F beta x_ij
    OuterSum<Dim> flux{};            ///< of D_i, as far as it is s_i div w
    Lanes crossing{};                ///< what the faces of soil add to it
    Lanes swiftness{};               ///< sum V_i V_j F beta B_ij

    /// Returns the coefficients V_i V_j F beta of eight pairs, rounded to single precision, the
    /// same from both sides of a pair.
    Lanes add(const PairLanes& pairs, const std::array<Lanes, P::size>& of)
    {
        const Lanes VSlope = of[P::volume] * pairs.slope;
        std::array<Lanes, Dim> x, change;
        for (int d = 0; d < Dim; ++d) {
            x[d] = own[P::x + d] - of[P::x + d];
            change[d] = of[P::v + d] - own[P::v + d];
        }
        const Lanes weight =
            roundLanes(-2 * ((own[P::volume] * of[P::volume]) * pairs.slope) * betas(pairs.j, x));
        if constexpr (Medium::hasSoil) {
            crossing += VSlope * heldAtFaces(pairs.j, change, x);
            for (int d = 0; d < Dim; ++d) change[d] *= medium.damping(i);
        }
        if constexpr (Medium::hasSoil) swiftness += weight * swiftnesses(pairs.j);
        diagonal += weight;
        for (int d = 0; d < Dim; ++d) {
            side[d] += weight * x[d];
            change[d] *= VSlope;
        }
        flux.add(change, x);
        return weight;
    }

private:
    Lanes betas(const Index* j, const std::array<Lanes, Dim>& x) const
    {
        if constexpr (!Medium::hasSoil) return allLanes(medium.beta(i));
        Lanes beta{};
        for (int l = 0; l < kLanes; ++l) beta[l] = medium.beta(i, j[l], lane(x, l));
        return beta;
    }
    /// B_ij, half where but one of the two carries v.                               [theory (3.13)]
    Lanes swiftnesses(const Index* j) const
    {
        Lanes all{};
        for (int l = 0; l < kLanes; ++l) {
            const int carriers = medium.carries(i) + medium.carries(j[l]);
            if (carriers > 0) all[l] = Real(0.5) * carriers * medium.swiftness(i, j[l]);
        }
        return all;
    }
    /// (s_ij - s_i)(w_i + w_j).x_ij, through a face where there is one: each pair has its own
    /// damping.                                                                               (5.2)
    Lanes heldAtFaces(const Index* j, const std::array<Lanes, Dim>& change,
                      const std::array<Lanes, Dim>& x) const
    {
        Lanes held{};
        for (int l = 0; l < kLanes; ++l) {
            const Vec<Dim> x_ij = lane(x, l);
            Vec<Dim> w = lane(change, l);
            for (int d = 0; d < Dim; ++d) w[d] += 2 * own[P::v + d];
            held[l] = (medium.damping(i, j[l], x_ij) - medium.damping(i)) *
                      medium.damped(i, j[l], w, x_ij);
        }
        return held;
    }
};

/// sum_rc L_rc M_rc
template <int Dim>
Real contract(const Mat<Dim>& L, const Mat<Dim>& M)
{
    Real sum = 0;
    for (int r = 0; r < Dim; ++r) sum += dot(L[r], M[r]);
    return sum;
}

/// s_i w_i - v_i, what the pressure takes from the predictor. In soil, which may be driven by more
/// than gravity, it is taken as it was; at a surface noise could be more.            [theory (5.4)]
template <int Dim, class Medium>
Vec<Dim> lastChange(Index i, SurfaceRole role, const Medium& medium,
                    const PressureSource<Dim>& source)
{
    const Vec<Dim>& c = source.forceGradient[i];
    const bool driven = medium.inSoil(i) && role == SurfaceRole::inner;
    return medium.beta(i) *
           (driven ? c : atMost(c, std::max(source.strongest, norm(source.force))));
}

/// |T_i| h_i that counts of an inner particle beside walls: packings leave 0.1, a free surface 1.2;
/// more is a corner with less room than a particle takes.
constexpr Real kMostLopsided = 0.3;   // [theory (5.4)]

void countEntries(const PressureRows& rows, const auto& pairs, const auto& role,
                  SymmetricMatrix& matrix)
{
    matrix.rowStart.resize(rows.size() + 1);
    matrix.rowStart[0] = 0;
    parallelForDynamic(rows.size(), [&](Index r) {
        const Index i = rows.particle[r];
        PairIndex entries = pairs.waterNeighbours(i);
        if (role[i] != SurfaceRole::inner)
            pairs.forWater(
                i, [&](const auto& pair) { entries -= role[pair.j] == SurfaceRole::surface; });
        matrix.rowStart[r + 1] = entries;
    });
    for (std::size_t r = 0; r < rows.size(); ++r) matrix.rowStart[r + 1] += matrix.rowStart[r];
    const auto entries = static_cast<std::size_t>(matrix.rowStart.back());
    matrix.column.resize(entries), matrix.offDiagonal.resize(entries);
    matrix.diagonal.resize(rows.size());
}

/// Writes the entries of eight partners from `entry` on, all of them unknowns.
PairIndex writeAll(SymmetricMatrix& matrix, PairIndex entry, const Lanes& row, const Lanes& value)
{
    storeLanes(row, &matrix.column[entry]);
    storeLanes(value, &matrix.offDiagonal[entry]);
    return entry + kLanes;
}

/// Writes those of the first `pairs` partners that are unknowns; returns the next place.
PairIndex writeUnknowns(SymmetricMatrix& matrix, PairIndex entry, const Lanes& row,
                        const Lanes& value, Index pairs)
{
    std::array<Real, kLanes> rows, values;
    storeLanes(row, rows.data()), storeLanes(value, values.data());
    for (Index l = 0; l < pairs; ++l) {
        if (rows[l] < 0) continue;
        matrix.column[entry] = static_cast<Index>(rows[l]);
        matrix.offDiagonal[entry++] = static_cast<float>(values[l]);
    }
    return entry;
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
/// Round-off in the places of images may round the two entries of a pair apart by one unit: both
/// become what the lower row has, and row sums stay.
void makeSymmetric(SymmetricMatrix& matrix, Index r)
{
    constexpr float rounding = 1e-6F;
    const auto column = matrix.column.begin();
    for (PairIndex k = matrix.rowStart[r]; k < matrix.rowStart[r + 1] && matrix.column[k] < r;
         ++k) {
        const Index c = matrix.column[k];
        const auto last = column + matrix.rowStart[c + 1];
        const auto mirrored = std::lower_bound(column + matrix.rowStart[c], last, r);
        if (mirrored == last || *mirrored != r) continue;
        float& a = matrix.offDiagonal[k];
        const float b = matrix.offDiagonal[mirrored - column];
        if (std::abs(a - b) > -rounding * a)
            continue;  // a narrow box: another image of the same particle
        matrix.diagonal[r] += static_cast<Real>(a) - static_cast<Real>(b);
        a = b;
    }
}
}  // namespace

template <int Dim, class Medium>
void assemble(const Points<Dim>& points, const PairList<Dim>& pairs,
              const Corrections<Dim>& corrections, const std::vector<SurfaceRole>& role,
              const Medium& medium, const PressureSource<Dim>& source, const PressureRows& rows,
              SymmetricMatrix& matrix, std::vector<Real>& rhs, std::vector<char>& anchored)
{
    using P = Partner<Dim>;
    countEntries(rows, pairs, role, matrix);
    rhs.resize(rows.size());
    anchored.resize(rows.size());
    const auto partners = partnersOf<Dim>(points, pairs, rows, source.v);
    parallelForDynamic(rows.size(), [&](Index r) {
        const Index i = rows.particle[r];
        const Real V_i = points.volume[i];
        RowSum<Dim, Medium> sum{medium, i, partners[i]};
        PairIndex entry = matrix.rowStart[r], left = pairs.waterNeighbours(i);
        Real known = 0;
        pairs.forWaterLanes(i, [&](const PairLanes& eight) {
            const auto of = partners.gather(eight.j);
            const Lanes weight = sum.add(eight, of);
            const auto count = static_cast<Index>(std::min<PairIndex>(left, kLanes));
            const bool inner = role[i] == SurfaceRole::inner;
            entry = inner && count == kLanes
                        ? writeAll(matrix, entry, of[P::row], -weight)
                        : writeUnknowns(matrix, entry, of[P::row], -weight, count);
            left -= count;
            if (inner || source.surfacePressure.empty()) return;
            for (Index l = 0; l < count; ++l)
                if (of[P::row][l] < 0)
                    known += weight[l] * source.surfacePressure[points.owner[eight.j[l]]];
        });
        anchored[r] = entry - matrix.rowStart[r] < pairs.waterNeighbours(i);
        Vec<Dim> wallGradient;
        pairs.forWalls(
            i, [&](const auto& pair) { wallGradient += points.volume[pair.j] * pair.gradW(); });
        const Mat<Dim>& L = corrections.L[i];
        const Real divergence =
            contract(L, sum.flux.total()) + sumOf(sum.crossing) -
            medium.damping(i) * dot(source.v[i], L * wallGradient);  // walls at rest
        const bool atWall = role[i] == SurfaceRole::inner && pairs.wallNeighbours(i) > 0;
        const Vec<Dim> T = atWall ? atMost(corrections.lopsided[i], kMostLopsided / points.h[i])
                                  : corrections.lopsided[i];
        const Real deferred = -dot(lastChange(i, role[i], medium, source), T);
        matrix.diagonal[r] = sumOf(sum.diagonal);
        rhs[r] = dot(source.force, sumOf(sum.side)) + sumOf(sum.swiftness) + known -
                 V_i * (divergence - source.divergence[i] + deferred);
        if (pairs.seesImages(i)) sortRow(matrix, matrix.rowStart[r], matrix.rowStart[r + 1]);
    });
    if (points.images() > 0)
        parallelForDynamic(rows.size(), [&](Index r) {
            if (pairs.seesImages(rows.particle[r])) makeSymmetric(matrix, r);
        });
    // A row without neighbours has no pressure; a one keeps the matrix positive definite.
    parallelFor(rows.size(), [&](Index r) {
        if (matrix.diagonal[r] <= 0) matrix.diagonal[r] = 1, rhs[r] = 0, anchored[r] = 1;
    });
}

#define ISPH_INSTANTIATE(Dim, Medium)                                                         \
    template void assemble(const Points<Dim>&, const PairList<Dim>&, const Corrections<Dim>&, \
                           const std::vector<SurfaceRole>&, const Medium<Dim>&,               \
                           const PressureSource<Dim>&, const PressureRows&, SymmetricMatrix&, \
                           std::vector<Real>&, std::vector<char>&);
ISPH_INSTANTIATE(2, ClearWater)
ISPH_INSTANTIATE(3, ClearWater)
ISPH_INSTANTIATE(2, WaterInSoil)
ISPH_INSTANTIATE(3, WaterInSoil)
#undef ISPH_INSTANTIATE

}  // namespace isph
