// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/solvers/Multigrid.hpp"

#include "pressure/RowTimes.hpp"

#include <algorithm>

namespace isph {

namespace {
/// Damping of Jacobi: stable for every matrix of non-negative row sums (below 1). In 2-D iterations
/// are the same between 0.7 and 0.95, in 3-D they are fewest from 0.9 on.
constexpr Real kDamping = 0.9;
/// Entries below this share of the largest of their rows do not hold a group together.
constexpr Real kStrength = 0.05;
/// The same where places are not known, until groups are few enough: near neighbours if possible,
/// else groups become too large; across a jump of the coefficient only where nothing else is left.
constexpr Real kNeighbourStrengths[] = {0.25, 0.1, kStrength, 0.01, 0};
/// A level must have fewer rows than this share of the finer one's.
constexpr Real kReduction = 0.7;
/// How often cells are doubled to reach that, before neighbours are joined without regard to cells.
constexpr int kDoublings = 3;
/// The coarsest level has no more rows than this: its factor fits the cache.
constexpr std::size_t kDirectRows = 400;
/// An excess below this share of the diagonal is the rounding of a row sum of some 60 terms.
constexpr Real kRounding = 1e-14;
/// Added to the coarsest diagonal, as a share: keeps the factor of a matrix without any tie to p =
/// 0.
constexpr Real kShift = 1e-13;

}  // namespace

/// The smoother, and t in place of the largest entries.
void Multigrid::Level::finish(Span<const Real> diagonal)
{
    forRows(diagonal.size(),
            [&](Index i) { sums.excess[i] = (sums.largest[i] > 0 ? kDamping : 1) / diagonal[i]; });
    begin();
}

bool Multigrid::setUp(const SymmetricMatrix& matrix)
{
    matrix_ = &matrix;
    used_ = 0;
    if (fine_.sums.excess.empty()) fine_.begin();
    if (!sumFine(matrix)) return false;
    fine_.keys.clear();
    if (matrix.places.known()) cellKeys(matrix.places, fine_.keys);
    const bool made = coarsen(matrix);
    finish(matrix);
    return made;
}

void Multigrid::finish(const SymmetricMatrix& matrix)
{
    fine_.finish(matrix.diagonal);
    for (std::size_t l = 0; l < used_; ++l) coarse_[l]->finish(coarse_[l]->matrix.diagonal);
}

/// What grouping needs of the rows of A. False where a diagonal is not positive.
bool Multigrid::sumFine(const SymmetricMatrix& matrix)
{
    const std::size_t n = matrix.size();
    fine_.sums.resize(n);
    const int failures = sumRows(n, [&](Index i) {
        Real sum = 0;
        float lowest = 0;
        const PairIndex end = matrix.rowStart[i + 1];
#pragma omp simd reduction(+ : sum) reduction(min : lowest)
        for (PairIndex k = matrix.rowStart[i]; k < end; ++k) {
            sum += static_cast<Real>(matrix.offDiagonal[k]);
            lowest = std::min(lowest, matrix.offDiagonal[k]);
        }
        const Real excess = matrix.diagonal[i] + sum;
        fine_.sums.excess[i] = excess > kRounding * matrix.diagonal[i] ? excess : 0;
        fine_.sums.largest[i] = -static_cast<Real>(lowest);
        return matrix.diagonal[i] > 0 ? 0 : 1;
    });
    return failures == 0;
}

bool Multigrid::coarsen(const SymmetricMatrix& matrix)
{
    direct_ = true;
    if (matrix.size() <= kDirectRows) return factor_.forget(), factor_.factorise(matrix);
    const SymmetricMatrix* finer = &matrix;
    for (Level* level = &fine_;;) {
        if (!group(*finer, *level)) return direct_ = false, true;
        addLevel(*finer, *level);
        CoarseLevel& coarse = *coarse_[used_ - 1];
        if (coarse.matrix.size() <= kDirectRows) return factorise(coarse.matrix);
        finer = &coarse.matrix, level = &coarse;
    }
}

/// Groups the rows of a level. False where all stay out: the smoother solves them.
bool Multigrid::group(const SymmetricMatrix& matrix, Level& level)
{
    const std::size_t n = matrix.size();
    const auto enough = [&, most = kReduction * static_cast<Real>(n)] {
        return static_cast<Real>(level.groups.size()) < most;
    };
    if (!level.keys.empty()) {
        level.groups.byCells(matrix, level.sums, level.keys, kStrength);
        for (int doubling = 0; doubling < kDoublings && !enough(); ++doubling) {
            forRows(n, [&](Index i) { level.keys[i] = coarserKey(level.keys[i]); });
            level.groups.byCells(matrix, level.sums, level.keys, kStrength);
        }
        if (enough()) return level.groups.size() > 0;
    }
    for (const Real strength : kNeighbourStrengths) {
        level.groups.byNeighbours(matrix, level.sums, strength);
        if (enough()) break;
    }
    return level.groups.size() > 0;
}

/// The level below `level`, whose rows have been grouped.
void Multigrid::addLevel(const SymmetricMatrix& matrix, const Level& level)
{
    if (used_ == coarse_.size()) coarse_.push_back(std::make_unique<CoarseLevel>());
    CoarseLevel& coarse = *coarse_[used_++];
    if (coarse.sums.excess.empty()) coarse.begin();
    builder_.build(matrix, level.sums, level.groups, coarse.matrix, coarse.sums);
    const std::size_t n = level.groups.size();
    for (LargeArray<Real>* v : {&coarse.r, &coarse.x, &coarse.c, &coarse.d, &coarse.v})
        v->resize(n);
    coarse.keys.resize(level.keys.empty() ? 0 : n);
    if (!level.keys.empty())
        forRows(n,
                [&](Index g) { coarse.keys[g] = coarserKey(level.keys[level.groups[g].front()]); });
}

bool Multigrid::factorise(SymmetricMatrix& coarsest)
{
    for (Real& diagonal : coarsest.diagonal) diagonal *= 1 + kShift;
    sortColumns(coarsest);
    factor_.forget();  // an ordering of an earlier step would leave its trace in the bits
    return factor_.factorise(coarsest);
}

Real Multigrid::operatorComplexity() const
{
    const auto entries = [](const auto& a) {
        return static_cast<Real>(a.column.size() + a.size());
    };
    Real sum = entries(*matrix_);
    for (std::size_t l = 0; l < used_; ++l) sum += entries(coarse_[l]->matrix);
    return sum / entries(*matrix_);
}

void Multigrid::apply(Span<const Real> r, Span<Real> z)
{
    Team::run(r.size(), [&](Team& team) { apply(team, r, z); });
}

void Multigrid::apply(Team& team, Span<const Real> r, Span<Real> z)
{
    if (direct_ && used_ == 0)
        team.single([&](Team&) { factor_.apply(r, z); });
    else
        cycle(team, *matrix_, fine_, 0, r, z);
}

/// z = B r. Both smoothing steps are the same, so B is symmetric but for the inner iterations.
/// Every thread has its rows of z when it returns, others may not have theirs.
void Multigrid::cycle(Team& team, const SymmetricMatrix& matrix, Level& level, std::size_t coarser,
                      Span<const Real> r, Span<Real> z)
{
    const std::size_t n = matrix.size();
    const Span<const Real> inverse = level.inverse;
    const Span<Real> t = level.t;
    team.forRows(n, [&](Index i) { t[i] = inverse[i] * r[i]; });
    team.wait();
    if (coarser < used_) {
        team.forRows(n, [&](Index i) { z[i] = r[i] - rowTimes(matrix, t, i); });
        team.wait();
        correct(team, level, coarser, z);
        team.wait();
    }
    team.forRows(n, [&](Index i) { z[i] = t[i] + inverse[i] * (r[i] - rowTimes(matrix, t, i)); });
}

/// t += P e with A_c e = P^T residual.
void Multigrid::correct(Team& team, Level& level, std::size_t coarser, Span<const Real> residual)
{
    CoarseLevel& coarse = *coarse_[coarser];
    const Aggregation& groups = level.groups;
    team.forRows(groups.size(), [&](Index g) {
        Real sum = 0;
        for (const Index i : groups[g]) sum += residual[i];
        coarse.r[g] = sum;
    });
    if (groups.size() < Team::kTeamRows)
        team.single([&](Team& alone) { solveCoarse(alone, coarser); });
    else {
        team.wait();
        solveCoarse(team, coarser);
    }
    team.forRows(level.t.size(), [&](Index i) {
        if (groups.group[i] >= 0) level.t[i] += coarse.x[groups.group[i]];
    });
}

/// x ~ A^-1 r by one step of conjugate gradients, by two where one does not quarter the residual.
/// All threads have their rows of x when it returns.
void Multigrid::solveCoarse(Team& team, std::size_t l)
{
    CoarseLevel& level = *coarse_[l];
    if (direct_ && l + 1 == used_) return factor_.apply(level.r, level.x);
    const std::size_t n = level.matrix.size();
    const SymmetricMatrix& a = level.matrix;
    const Span<Real> r = level.r, x = level.x, c = level.c, d = level.d, v = level.v;
    cycle(team, a, level, l + 1, r, c);
    team.wait();
    const Vec<3> first = team.sumRows(n, [&](Index i) {
        v[i] = rowTimes(a, c, i);
        return Vec<3>{c[i] * v[i], c[i] * r[i], sqr(r[i])};
    });
    const Real cv = first[0], step = cv > 0 ? first[1] / cv : 0;
    const Real left = team.sumRows(n, [&](Index i) {
        r[i] -= step * v[i];
        return sqr(r[i]);
    });
    constexpr Real enough = 1.0 / 16;  // of the square
    if (!(left > enough * first[2])) {
        team.forRows(n, [&](Index i) { x[i] = step * c[i]; });
        return team.wait();
    }
    cycle(team, a, level, l + 1, r, d);
    team.wait();
    const Vec<3> second = team.sumRows(n, [&](Index i) {
        return Vec<3>{d[i] * v[i], d[i] * rowTimes(a, d, i), d[i] * r[i]};
    });
    const Real curvature = second[1] - sqr(second[0]) / cv;
    const Real stepD = curvature > 0 ? second[2] / curvature : 0;
    const Real stepC = step - stepD * second[0] / cv;
    team.forRows(n, [&](Index i) { x[i] = stepC * c[i] + stepD * d[i]; });
    team.wait();
}

}  // namespace isph
