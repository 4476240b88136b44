// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of the solvers share.
#pragma once
#include "core/Parallel.hpp"
#include "pressure/PressureSolver.hpp"

#include "ParticleMatrix.hpp"

#include <algorithm>
#include <string>

namespace isph::test {

inline std::unique_ptr<PressureSolver> solverOf(const std::string& keys)
{
    return PressureSolver::select(Dictionary::parse(keys, "isphSolution"));
}

/// |b - A x|_2 in extended precision, by code that shares nothing with the solvers'.
inline Real trueResidual(const SymmetricMatrix& a, const std::vector<Real>& x,
                         const std::vector<Real>& b)
{
    long double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        long double r = b[i] - static_cast<long double>(a.diagonal[i]) * x[i];
        for (PairIndex k = a.rowStart[i]; k < a.rowStart[i + 1]; ++k)
            r -= static_cast<long double>(a.offDiagonal[k]) * x[a.column[k]];
        sum += r * r;
    }
    return static_cast<Real>(std::sqrt(sum));
}

inline Real norm(const std::vector<Real>& v)
{
    Real sum = 0;
    for (const Real value : v) sum += sqr(value);
    return std::sqrt(sum);
}

/// Sets the number of threads and puts it back.
class Threads {
public:
    explicit Threads(int threads) : before_(threadCount()) { setThreadCount(threads); }
    ~Threads() { setThreadCount(before_); }
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;

private:
    int before_;
};

/// The rows of a dense matrix.
inline SymmetricMatrix fromDense(const std::vector<std::vector<Real>>& dense)
{
    SymmetricMatrix a;
    for (std::size_t i = 0; i < dense.size(); ++i) {
        for (std::size_t j = 0; j < dense.size(); ++j)
            if (j != i && dense[i][j] != 0) {
                a.column.push_back(static_cast<Index>(j));
                a.offDiagonal.push_back(static_cast<float>(dense[i][j]));
            }
        a.diagonal.push_back(dense[i][i]);
        a.rowStart.push_back(static_cast<PairIndex>(a.column.size()));
    }
    return a;
}

/// -x'' on a chain of n points, with p = 0 beyond both ends.
inline SymmetricMatrix chain(std::size_t n)
{
    std::vector<std::vector<Real>> dense(n, std::vector<Real>(n, 0));
    for (std::size_t i = 0; i < n; ++i) {
        dense[i][i] = 2;
        if (i > 0) dense[i][i - 1] = dense[i - 1][i] = -1;
    }
    return fromDense(dense);
}

}  // namespace isph::test
