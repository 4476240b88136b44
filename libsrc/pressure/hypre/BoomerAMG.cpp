// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/hypre/BoomerAMG.hpp"

#include "core/Error.hpp"

#include <HYPRE.h>
#include <HYPRE_IJ_mv.h>
#include <HYPRE_krylov.h>
#include <HYPRE_parcsr_ls.h>
#include <fmt/core.h>

#include <cstdlib>
#include <numeric>

namespace isph {

namespace {
const HypreBackend::Table::Entry<BoomerAMG> entry{"BoomerAMG"};

// hypre's numbers for what the study of solvers found best (HYPRE reference manual, BoomerAMG).
constexpr int kHMIS = 10, kPMIS = 8;
constexpr int kExtendedInterpolation = 6, kInterpolationEntries = 4;
constexpr int kL1ForwardGaussSeidel = 13, kL1BackwardGaussSeidel = 14;
constexpr int kDown = 1, kUp = 2;

void startMpi()
{
    int running = 0;
    MPI_Initialized(&running);
    if (running) return;
    MPI_Init(nullptr, nullptr);
    std::atexit([] { MPI_Finalize(); });
}

void check(const char* what)
{
    if (const int error = HYPRE_GetError()) {
        char text[256] = "";
        HYPRE_DescribeError(error, text);
        HYPRE_ClearAllErrors();
        throw FatalError(fmt::format("hypre failed in {}: {}.", what, text));
    }
}
}  // namespace

struct BoomerAMG::State {
    MPI_Comm comm;
    HYPRE_Int first = 0, last = 0;  ///< rows of this rank: first .. last-1
    HYPRE_IJMatrix matrix = nullptr;
    HYPRE_IJVector b = nullptr, x = nullptr;
    HYPRE_Solver multigrid = nullptr, gradients = nullptr;
    std::vector<HYPRE_Int> row, entries, column;
    std::vector<Real> value;

    explicit State(MPI_Comm c) : comm(c) {}
    ~State()
    {
        if (gradients) HYPRE_ParCSRPCGDestroy(gradients);
        dropMultigrid();
        dropSystem();
    }
    void dropMultigrid()
    {
        if (multigrid) HYPRE_BoomerAMGDestroy(multigrid);
        multigrid = nullptr;
    }
    void dropSystem()
    {
        if (matrix) HYPRE_IJMatrixDestroy(matrix);
        if (b) HYPRE_IJVectorDestroy(b);
        if (x) HYPRE_IJVectorDestroy(x);
        matrix = nullptr, b = x = nullptr;
    }
    HYPRE_ParCSRMatrix parMatrix() const { return static_cast<HYPRE_ParCSRMatrix>(object()); }
    void* object() const
    {
        void* inside = nullptr;
        HYPRE_IJMatrixGetObject(matrix, &inside);
        return inside;
    }
    static HYPRE_ParVector par(HYPRE_IJVector vector)
    {
        void* inside = nullptr;
        HYPRE_IJVectorGetObject(vector, &inside);
        return static_cast<HYPRE_ParVector>(inside);
    }
    HYPRE_IJVector makeVector() const;
    void copy(const SymmetricMatrix& a);
    void makeMultigrid(const Dictionary& settings);

    Dictionary settings = Dictionary::parse("", "hypre");
};

HYPRE_IJVector BoomerAMG::State::makeVector() const
{
    HYPRE_IJVector vector = nullptr;
    HYPRE_IJVectorCreate(comm, first, last - 1, &vector);
    HYPRE_IJVectorSetObjectType(vector, HYPRE_PARCSR);
    HYPRE_IJVectorInitialize(vector);
    return vector;
}

/// The rows first .. last-1 of a; the diagonal comes first in each row, as hypre wants it.
void BoomerAMG::State::copy(const SymmetricMatrix& a)
{
    dropSystem();
    const auto rows = static_cast<std::size_t>(last - first);
    row.resize(rows), entries.resize(rows);
    std::iota(row.begin(), row.end(), first);
    column.clear(), value.clear();
    for (HYPRE_Int i = first; i < last; ++i) {
        entries[i - first] = static_cast<HYPRE_Int>(a.rowStart[i + 1] - a.rowStart[i]) + 1;
        column.push_back(i), value.push_back(a.diagonal[i]);
        const auto from = a.rowStart[i], to = a.rowStart[i + 1];
        column.insert(column.end(), a.column.begin() + from, a.column.begin() + to);
        value.insert(value.end(), a.offDiagonal.begin() + from, a.offDiagonal.begin() + to);
    }
    HYPRE_IJMatrixCreate(comm, first, last - 1, first, last - 1, &matrix);
    HYPRE_IJMatrixSetObjectType(matrix, HYPRE_PARCSR);
    HYPRE_IJMatrixSetRowSizes(matrix, entries.data());
    HYPRE_IJMatrixInitialize(matrix);
    HYPRE_IJMatrixSetValues(matrix, last - first, entries.data(), row.data(), column.data(),
                            value.data());
    HYPRE_IJMatrixAssemble(matrix);
    b = makeVector(), x = makeVector();
}

void BoomerAMG::State::makeMultigrid(const Dictionary& chosen)
{
    const Schema keys = BoomerAMG::keys();
    dropMultigrid();
    HYPRE_BoomerAMGCreate(&multigrid);
    HYPRE_BoomerAMGSetCoarsenType(
        multigrid, keys.get<std::string>(chosen, "coarsening") == "HMIS" ? kHMIS : kPMIS);
    HYPRE_BoomerAMGSetAggNumLevels(multigrid, keys.get<int>(chosen, "aggressiveLevels"));
    HYPRE_BoomerAMGSetStrongThreshold(multigrid, keys.get<Real>(chosen, "strongThreshold"));
    HYPRE_BoomerAMGSetInterpType(multigrid, kExtendedInterpolation);
    HYPRE_BoomerAMGSetPMaxElmts(multigrid, kInterpolationEntries);
    HYPRE_BoomerAMGSetCycleRelaxType(multigrid, kL1ForwardGaussSeidel, kDown);
    HYPRE_BoomerAMGSetCycleRelaxType(multigrid, kL1BackwardGaussSeidel, kUp);
    HYPRE_BoomerAMGSetRelaxOrder(multigrid, 0);
    HYPRE_BoomerAMGSetTol(multigrid, 0);  // a preconditioner: one cycle
    HYPRE_BoomerAMGSetMaxIter(multigrid, 1);
    HYPRE_BoomerAMGSetup(multigrid, parMatrix(), par(b), par(x));
    check("the setup of BoomerAMG");
}

BoomerAMG::BoomerAMG(const Dictionary& settings) : BoomerAMG(settings, (startMpi(), MPI_COMM_SELF))
{
}

BoomerAMG::BoomerAMG(const Dictionary& settings, MPI_Comm comm)
    : state_(std::make_unique<State>(comm))
{
    HYPRE_Init();
    state_->settings = settings;
    HYPRE_ParCSRPCGCreate(comm, &state_->gradients);
    HYPRE_PCGSetTwoNorm(state_->gradients, 1);
    HYPRE_PCGSetTol(state_->gradients, 0);
}

BoomerAMG::~BoomerAMG() = default;

void BoomerAMG::setUp(const SymmetricMatrix& matrix, bool newHierarchy)
{
    setUpRows(matrix, 0, static_cast<Index>(matrix.size()), newHierarchy);
}

void BoomerAMG::setUpRows(const SymmetricMatrix& matrix, Index first, Index last, bool newHierarchy)
{
    State& s = *state_;
    s.first = first, s.last = last;
    s.copy(matrix);
    check("taking the matrix");
    if (newHierarchy || !s.multigrid) s.makeMultigrid(s.settings);
    HYPRE_PCGSetPrecond(
        s.gradients, reinterpret_cast<HYPRE_PtrToSolverFcn>(HYPRE_BoomerAMGSolve),
        // the hierarchy is there already
        [](HYPRE_Solver, HYPRE_Matrix, HYPRE_Vector, HYPRE_Vector) -> HYPRE_Int { return 0; },
        s.multigrid);
    HYPRE_ParCSRPCGSetup(s.gradients, s.parMatrix(), s.par(s.b), s.par(s.x));
    check("the setup of conjugate gradients");
}

int BoomerAMG::iterate(Span<const Real> b, Span<Real> x, Real target, int maxIter)
{
    State& s = *state_;
    const HYPRE_Int rows = s.last - s.first;
    HYPRE_IJVectorSetValues(s.b, rows, s.row.data(), b.data());
    HYPRE_IJVectorSetValues(s.x, rows, s.row.data(), x.data());
    HYPRE_IJVectorAssemble(s.b), HYPRE_IJVectorAssemble(s.x);
    HYPRE_PCGSetAbsoluteTol(s.gradients, target);
    HYPRE_PCGSetMaxIter(s.gradients, maxIter);
    HYPRE_ParCSRPCGSolve(s.gradients, s.parMatrix(), s.par(s.b), s.par(s.x));
    HYPRE_ClearAllErrors();  // not converged is told by the residual, which the caller measures
    HYPRE_IJVectorGetValues(s.x, rows, s.row.data(), x.data());
    HYPRE_Int iterations = 0;
    HYPRE_PCGGetNumIterations(s.gradients, &iterations);
    return iterations;
}

}  // namespace isph
