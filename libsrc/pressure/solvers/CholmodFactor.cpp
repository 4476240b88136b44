// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/solvers/CholmodFactor.hpp"

#include "core/Error.hpp"

#include <cholmod.h>
#include <dlfcn.h>
#include <fmt/core.h>
#include <omp.h>

#include <algorithm>
#include <limits>

namespace isph {

namespace {
/// OpenBLAS has threads of its own, and its results depend on their number. Other implementations
/// of the BLAS have no such function and are left as they are.
void useOneBlasThread()
{
    using SetThreads = void (*)(int);
    if (void* symbol = dlsym(RTLD_DEFAULT, "openblas_set_num_threads"))
        reinterpret_cast<SetThreads>(symbol)(1);
}

/// A kept ordering is given up when the factor has grown by this over that of the step it is from.
constexpr double kMostGrowth = 1.3;

/// While it lives, parallel regions of this thread run on one thread: CHOLMOD asks for four.
class OneThread {
public:
    OneThread() : levels_(omp_get_max_active_levels()) { omp_set_max_active_levels(0); }
    ~OneThread() { omp_set_max_active_levels(levels_); }
    OneThread(const OneThread&) = delete;
    OneThread& operator=(const OneThread&) = delete;

private:
    int levels_;
};
}  // namespace

struct CholmodFactor::State {
    cholmod_common common{};
    cholmod_factor* factor = nullptr;
    bool numeric = false;  ///< the factor holds numbers, not only the pattern
    cholmod_dense *x = nullptr, *y = nullptr, *e = nullptr;  ///< kept by CHOLMOD between solves
    LargeArray<PairIndex> rowStart;                          ///< pattern that was analysed
    LargeArray<Index> column;
    std::vector<int> ordering;  ///< found anew last, for freshFill entries of the factor
    double freshFill = 0;
    std::vector<int> start, row;  ///< lower half with diagonal, by columns, as CHOLMOD wants it
    std::vector<Real> value;

    State()
    {
        cholmod_start(&common);
        common.print = 0;
    }
    ~State()
    {
        cholmod_free_dense(&x, &common);
        cholmod_free_dense(&y, &common);
        cholmod_free_dense(&e, &common);
        cholmod_free_factor(&factor, &common);
        cholmod_finish(&common);
    }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    void copyLowerHalf(const SymmetricMatrix& matrix);
    cholmod_sparse view();
    void analyse(cholmod_sparse& a);
    bool analyseInKeptOrder(cholmod_sparse& a);
    void check() const;
};

void CholmodFactor::State::copyLowerHalf(const SymmetricMatrix& matrix)
{
    const std::size_t n = matrix.size();
    start.resize(n + 1), row.clear(), value.clear();
    for (std::size_t i = 0; i < n; ++i) {
        start[i] = static_cast<int>(row.size());
        row.push_back(static_cast<int>(i));
        value.push_back(matrix.diagonal[i]);
        for (PairIndex k = matrix.rowStart[i]; k < matrix.rowStart[i + 1]; ++k) {
            if (matrix.column[k] <= static_cast<Index>(i)) continue;
            row.push_back(matrix.column[k]);
            value.push_back(static_cast<Real>(matrix.offDiagonal[k]));
        }
    }
    start[n] = static_cast<int>(row.size());
}

cholmod_sparse CholmodFactor::State::view()
{
    cholmod_sparse a{};
    a.nrow = a.ncol = start.size() - 1;
    a.nzmax = row.size();
    a.p = start.data(), a.i = row.data(), a.x = value.data();
    a.stype = -1;
    a.itype = CHOLMOD_INT, a.xtype = CHOLMOD_REAL, a.dtype = CHOLMOD_DOUBLE;
    a.sorted = a.packed = 1;
    return a;
}

void CholmodFactor::State::analyse(cholmod_sparse& a)
{
    if (analyseInKeptOrder(a)) return;
    cholmod_free_factor(&factor, &common);
    factor = cholmod_analyze(&a, &common);
    check();
    const int* order = static_cast<const int*>(factor->Perm);
    ordering.assign(order, order + a.nrow);
    freshFill = common.lnz;
}

bool CholmodFactor::State::analyseInKeptOrder(cholmod_sparse& a)
{
    if (ordering.size() != a.nrow || ordering.empty()) return false;
    cholmod_free_factor(&factor, &common);
    const int methods = common.nmethods;
    const int first = common.method[0].ordering;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_GIVEN;
    factor = cholmod_analyze_p(&a, ordering.data(), nullptr, 0, &common);
    common.nmethods = methods;
    common.method[0].ordering = first;
    return factor && common.lnz <= kMostGrowth * freshFill;
}

void CholmodFactor::State::check() const
{
    if (common.status == CHOLMOD_OUT_OF_MEMORY || common.status == CHOLMOD_TOO_LARGE)
        throw FatalError(
            fmt::format("CHOLMOD: the factor of {} rows is too large for {}. Choose solver PCG.",
                        start.size() - 1,
                        common.status == CHOLMOD_TOO_LARGE ? "32-bit addresses" : "the memory"));
    if (common.status < 0)
        throw FatalError(fmt::format("CHOLMOD failed with status {}.", common.status));
}

CholmodFactor::CholmodFactor() : state_(std::make_unique<State>())
{
    useOneBlasThread();
}
CholmodFactor::~CholmodFactor() = default;

bool CholmodFactor::factorise(const SymmetricMatrix& matrix)
{
    const OneThread guard;
    State& s = *state_;
    s.numeric = false;
    if (matrix.column.size() / 2 + matrix.size() > std::numeric_limits<int>::max()) {
        s.common.status = CHOLMOD_TOO_LARGE;
        s.check();
    }
    s.copyLowerHalf(matrix);
    cholmod_sparse a = s.view();
    if (!s.factor || s.rowStart != matrix.rowStart || s.column != matrix.column) {
        s.analyse(a);
        s.rowStart = matrix.rowStart;
        s.column = matrix.column;
    }
    cholmod_factorize(&a, s.factor, &s.common);
    s.check();
    s.numeric = s.factor->minor == s.factor->n;
    return s.numeric;
}

void CholmodFactor::apply(Span<const Real> r, Span<Real> z)
{
    const OneThread guard;
    State& s = *state_;
    cholmod_dense b{};
    b.nrow = b.d = b.nzmax = r.size();
    b.ncol = 1;
    b.x = const_cast<Real*>(r.data());  // CHOLMOD does not write to it
    b.xtype = CHOLMOD_REAL, b.dtype = CHOLMOD_DOUBLE;
    cholmod_solve2(CHOLMOD_A, s.factor, &b, nullptr, &s.x, nullptr, &s.y, &s.e, &s.common);
    s.check();
    const Real* x = static_cast<const Real*>(s.x->x);
    std::copy(x, x + r.size(), z.begin());
}

bool CholmodFactor::holds(std::size_t n) const
{
    return state_->numeric && state_->factor->n == n;
}

void CholmodFactor::forget()
{
    cholmod_free_factor(&state_->factor, &state_->common);
    state_->numeric = false;
    state_->ordering.clear();
}

}  // namespace isph
