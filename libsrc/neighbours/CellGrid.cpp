// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbours/CellGrid.hpp"

#include "core/Parallel.hpp"

namespace isph {

namespace {
constexpr Real kCellsPerPoint = 4;   // bounds the memory of sparse clouds (drops far from the bulk)
constexpr Real kLeastCells = 4096;
}  // namespace

template <int Dim>
void CellGrid<Dim>::build(Span<const Vec<Dim>> x, Real edge, int slices)
{
    point_.resize(x.size());
    cell_.resize(x.size());
    if (x.empty()) {
        count_.fill(1);
        start_.assign(2, 0);
        return;
    }
    Vec<Dim> low = x[0], high = x[0];
    for (const Vec<Dim>& p : x)
        for (int d = 0; d < Dim; ++d) {
            low[d] = std::min(low[d], p[d]);
            high[d] = std::max(high[d], p[d]);
        }
    for (int d = 0; d < Dim; ++d) edge_[d] = edge;
    edge_[0] /= slices;
    const Real most = std::max(kLeastCells, kCellsPerPoint * static_cast<Real>(x.size()));
    for (;; edge_ *= 1.5) {
        Real cells = 1;
        for (int d = 0; d < Dim; ++d) cells *= std::floor((high[d] - low[d]) / edge_[d]) + 2;
        if (cells <= most) break;
    }
    Index cells = 1;
    for (int d = 0; d < Dim; ++d) {
        inverseEdge_[d] = 1 / edge_[d];
        origin_[d] = std::floor(low[d] * inverseEdge_[d]) * edge_[d];
        count_[d] = static_cast<Index>((high[d] - origin_[d]) * inverseEdge_[d]) + 1;
        cells *= count_[d];
    }
    parallelFor(x.size(), [&](Index i) {
        Index c = cellOf(x[i][Dim - 1], Dim - 1);
        for (int d = Dim - 2; d >= 0; --d) c = c * count_[d] + cellOf(x[i][d], d);
        cell_[i] = c;
    });
    start_.assign(cells + 2, 0);   // counted one place ahead, so that filling moves it into place
    for (const Index c : cell_) ++start_[c + 2];
    for (Index c = 0; c < cells; ++c) start_[c + 2] += start_[c + 1];
    for (std::size_t i = 0; i < x.size(); ++i)
        point_[start_[cell_[i] + 1]++] = static_cast<Index>(i);
}

template class CellGrid<2>;
template class CellGrid<3>;

}  // namespace isph
