// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the fluid that no free surface reaches: their pressure has no level of its own.
#pragma once
#include "pressure/SymmetricMatrix.hpp"

#include <vector>

namespace isph {

/// Rows of the floating components, one component after the other. Each begins with its lowest row.
struct FloatingComponents {
    std::vector<PairIndex> start{0};  ///< size()+1
    std::vector<Index> row;

    std::size_t size() const { return start.size() - 1; }
    Span<const Index> operator[](std::size_t c) const
    {
        return {row.data() + start[c], static_cast<std::size_t>(start[c + 1] - start[c])};
    }
};

/// Finds the connected components without an anchored row. It keeps its work array.
class ComponentFinder {
public:
    /// anchored[i] != 0: row i has a neighbour whose pressure is given, so its diagonal exceeds the
    /// sum of its off-diagonals by construction. Coefficients that are 0 connect nothing. Costs a
    /// few looks at each row where every row is reached from an anchored one, O(nonzeros) at most.
    const FloatingComponents& find(const SymmetricMatrix& matrix, Span<const char> anchored);

private:
    void sweepTwice(const SymmetricMatrix& matrix, PairIndex first, PairIndex last);
    void sweep(const SymmetricMatrix& matrix, Index i);
    void flood(const SymmetricMatrix& matrix, Index seed);

    std::vector<char> reached_;
    FloatingComponents floating_;
};

/// Makes the singular blocks of floating components definite without changing their solution.
///
/// A block A_c of zero row sums has the constant vector 1 as null space, so A_c x = b has solutions
/// only where 1.b = 0: the mean of b over the component is subtracted from it (the projection onto
/// what can be solved). Then the diagonal a_00 of the component's first row is doubled. The new
/// block A_c + a_00 e_0 e_0^T is positive definite, and its solution solves A_c x = b as well:
/// multiplied by 1^T the new system reads  1^T A_c x + a_00 x_0 = 1^T b,  that is a_00 x_0 = 0. So
/// x_0 = 0, the added term vanishes, and among all solutions the one with x_0 = 0 is found.
/// A row without any coefficient gets the diagonal 1, hence x = 0.
void makeSolvable(SymmetricMatrix& matrix, Span<Real> b, const FloatingComponents& floating);

/// Shifts a start x of the solver so that x_0 = 0 in each component, as in the solution.
void startAtZero(Span<Real> x, const FloatingComponents& floating);

/// Shifts x in each floating component so that its mean there is 0.
void removeMean(Span<Real> x, const FloatingComponents& floating);

}  // namespace isph
