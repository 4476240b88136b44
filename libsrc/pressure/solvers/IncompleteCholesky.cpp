// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/solvers/IncompleteCholesky.hpp"

#include "core/Parallel.hpp"

#include <algorithm>
#include <cmath>

namespace isph {

namespace {
constexpr std::size_t kLeastRows = 2000;  ///< below, two starts do not pay for starting threads
constexpr Real kLeastPivot = 1e-13;       ///< of the diagonal; below, only rounding is left of it
}  // namespace

std::optional<Real> IncompleteCholesky::factorise(const SymmetricMatrix& matrix)
{
    number(matrix);
    countColumns(matrix);
    for (const Real shift : {0.0, 1e-3, 1e-2, 1e-1, 1.0, 10.0})
        if (eliminate(matrix, shift)) return shift;
    return {};
}

void IncompleteCholesky::number(const SymmetricMatrix& matrix)
{
    const auto n = static_cast<Index>(matrix.size());
    const Index half = matrix.size() < kLeastRows ? n : n / 2;
    newRow_.resize(n), oldRow_.resize(n);
    for (Index i = 0; i < half; ++i) newRow_[i] = i;
    Index upper = half, middle = n;
    for (Index i = half; i < n; ++i) {
        const PairIndex first = matrix.rowStart[i];  // columns ascend: the first one tells
        const bool touches = first < matrix.rowStart[i + 1] && matrix.column[first] < half;
        newRow_[i] = touches ? --middle : -1;
    }
    for (Index i = n - 1; i >= half; --i)
        if (newRow_[i] < 0) newRow_[i] = upper++;
    for (Index i = 0; i < n; ++i) oldRow_[newRow_[i]] = i;
    sections_ = {Section{0, half}, Section{half, middle}, Section{middle, n}};
}

void IncompleteCholesky::countColumns(const SymmetricMatrix& matrix)
{
    const std::size_t n = matrix.size();
    lowerStart_.resize(n + 1), upperStart_.resize(n + 1);
    lowerStart_[0] = upperStart_[0] = 0;
    parallelFor(n, [&](Index k) {
        const Index i = oldRow_[k];
        PairIndex below = 0;
        for (PairIndex e = matrix.rowStart[i]; e < matrix.rowStart[i + 1]; ++e)
            below += newRow_[matrix.column[e]] < k;
        lowerStart_[k + 1] = below;
        upperStart_[k + 1] = matrix.rowStart[i + 1] - matrix.rowStart[i] - below;
    });
    for (std::size_t k = 0; k < n; ++k) {
        lowerStart_[k + 1] += lowerStart_[k];
        upperStart_[k + 1] += upperStart_[k];
    }
    lowerColumn_.resize(lowerStart_[n]), lower_.resize(lowerStart_[n]);
    upperColumn_.resize(upperStart_[n]), upper_.resize(upperStart_[n]);
    pivot_.resize(n), inverseRoot_.resize(n), y_.resize(n);
}

bool IncompleteCholesky::eliminate(const SymmetricMatrix& matrix, Real shift)
{
    bool positive = true;
#pragma omp parallel for reduction(&& : positive) if (sections_[1].first < sections_[1].last)
    for (int half = 0; half < 2; ++half)
        positive = eliminate(matrix, sections_[half], shift, work_[half]) && positive;
    return positive && eliminate(matrix, sections_[2], shift, work_[0]);
}

bool IncompleteCholesky::eliminate(const SymmetricMatrix& matrix, Section section, Real shift,
                                   Workspace& work)
{
    if (work.slot.size() < matrix.size()) work.slot.resize(matrix.size(), 0);
    for (Index k = section.first; k < section.last; ++k)
        if (!eliminateRow(matrix, k, shift, work)) return false;
    return true;
}

/// Row k of U = D L^T and of L; the rows of its lower columns are complete.
/// The lower half is eliminated as well: by symmetry it has the values of the columns of U.
bool IncompleteCholesky::eliminateRow(const SymmetricMatrix& matrix, Index k, Real shift,
                                      Workspace& work)
{
    const Index i = oldRow_[k];
    const auto slots = static_cast<Index>(2 + matrix.rowStart[i + 1] - matrix.rowStart[i]);
    if (work.value.size() < static_cast<std::size_t>(slots)) work.value.resize(2 * slots);
    Index* slot = work.slot.data();
    Real* value = work.value.data();
    value[0] = 0;
    value[1] = matrix.diagonal[i] * (1 + shift);
    slot[k] = 1;
    PairIndex low = lowerStart_[k], high = upperStart_[k];
    for (Index next = 2; next < slots; ++next) {
        const PairIndex e = matrix.rowStart[i] + next - 2;
        const Index column = newRow_[matrix.column[e]];
        (column < k ? lowerColumn_[low++] : upperColumn_[high++]) = column;
        value[next] = static_cast<Real>(matrix.offDiagonal[e]);
        slot[column] = next;
    }
    std::sort(lowerColumn_.begin() + lowerStart_[k], lowerColumn_.begin() + low);
    for (PairIndex e = lowerStart_[k]; e < low; ++e) {
        const Index m = lowerColumn_[e];
        const Real u_mk = value[slot[m]], factor = u_mk / pivot_[m];
        lower_[e] = static_cast<float>(u_mk * inverseRoot_[m]);
        for (PairIndex q = upperStart_[m]; q < upperStart_[m + 1]; ++q)
            value[slot[upperColumn_[q]]] -= factor * upper_[q];
    }
    for (PairIndex e = lowerStart_[k]; e < low; ++e) slot[lowerColumn_[e]] = 0;
    for (PairIndex e = upperStart_[k]; e < high; ++e) {
        upper_[e] = value[slot[upperColumn_[e]]];
        slot[upperColumn_[e]] = 0;
    }
    slot[k] = 0;
    pivot_[k] = value[1] + relaxation_ * value[0];
    inverseRoot_[k] = 1 / std::sqrt(pivot_[k]);
    return pivot_[k] > kLeastPivot * matrix.diagonal[i];
}

/// z = L^-T L^-1 r. The halves touch their own rows and those of the middle only.
void IncompleteCholesky::apply(Span<const Real> r, Span<Real> z)
{
    const bool twoHalves = sections_[1].first < sections_[1].last;
#pragma omp parallel for if (twoHalves)
    for (int half = 0; half < 2; ++half) forward(sections_[half], r);
    forward(sections_[2], r);
    backward(sections_[2], z);
#pragma omp parallel for if (twoHalves)
    for (int half = 0; half < 2; ++half) backward(sections_[half], z);
}

/// L y = r
void IncompleteCholesky::forward(Section section, Span<const Real> r)
{
    for (Index k = section.first; k < section.last; ++k) {
        Real sum = r[oldRow_[k]];
        for (PairIndex e = lowerStart_[k]; e < lowerStart_[k + 1]; ++e)
            sum -= static_cast<Real>(lower_[e]) * y_[lowerColumn_[e]];
        y_[k] = sum * inverseRoot_[k];
    }
}

/// L^T z = y, by columns of L^T
void IncompleteCholesky::backward(Section section, Span<Real> z)
{
    for (Index k = section.last; k-- > section.first;) {
        const Real z_k = y_[k] * inverseRoot_[k];
        z[oldRow_[k]] = z_k;
        for (PairIndex e = lowerStart_[k]; e < lowerStart_[k + 1]; ++e)
            y_[lowerColumn_[e]] -= static_cast<Real>(lower_[e]) * z_k;
    }
}

}  // namespace isph
