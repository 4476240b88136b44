// SPDX-License-Identifier: GPL-3.0-or-later
// The matrix of the next coarser level.
#pragma once
#include "pressure/solvers/Aggregation.hpp"

namespace isph {

/// A_c = P^T A P with P_ig = 1 where row i belongs to group g: the sum of all entries between two
/// groups. The diagonal is made as excess + sum of |off-diagonals|, not as the sum of what lies
/// within a group: strong entries there would cancel and take the weak ones' digits with them. So
/// it fits the off-diagonals rounded to single precision: no jump is too large for them. Entries of
/// 0 fill rows up to multiples of four, for rowTimes().
class CoarseMatrixBuilder {
public:
    void build(const SymmetricMatrix& fine, const RowSums& fineSums, const Aggregation& groups,
               SymmetricMatrix& coarse, RowSums& coarseSums);

private:
    /// The rows of a run of groups, made by one thread. The row at hand is summed in `column` and
    /// `value`, whose first two places are its diagonal and what ties it to rows without a group.
    struct Part {
        Index first = 0, last = 0;
        LargeArray<Index> slot;  ///< of group + 1 in the row at hand; less than its base: none yet
        LargeArray<Index> column;
        LargeArray<Real> value;
        LargeArray<Index> columns;  ///< of all rows; the first part's go into the coarse matrix
        LargeArray<float> values;
    };
    Index sumRow(const SymmetricMatrix& fine, const Aggregation& groups, Index g, Index base,
                 Part& part);
    void gather(const SymmetricMatrix& fine, const RowSums& fineSums, const Aggregation& groups,
                Part& part, SymmetricMatrix& coarse, RowSums& coarseSums);
    void join(SymmetricMatrix& coarse);

    std::vector<Part> parts_;
};

/// Brings the columns of every row into ascending order.
void sortColumns(SymmetricMatrix& matrix);

}  // namespace isph
