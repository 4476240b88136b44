// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressure/EquationFile.hpp"

#include "core/Error.hpp"

#include <fmt/core.h>

#include <array>
#include <cstdlib>
#include <fstream>

namespace isph {

namespace {
const std::string kMagic = "isphEquation2\n";

template <class T>
void put(std::ofstream& out, Span<const T> values)
{
    out.write(reinterpret_cast<const char*>(values.data()),
              static_cast<std::streamsize>(values.size_bytes()));
}

template <class Array>
void take(std::ifstream& in, Array& values, std::size_t n)
{
    values.resize(n);
    in.read(reinterpret_cast<char*>(values.data()),
            static_cast<std::streamsize>(n * sizeof(values[0])));
}

[[noreturn]] void fail(const std::filesystem::path& file, const char* what)
{
    throw FatalError(fmt::format("{} {}.", file.string(), what));
}
}  // namespace

void writeEquation(const std::filesystem::path& file, const SymmetricMatrix& matrix,
                   Span<const Real> b, Span<const Real> x)
{
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
    std::ofstream out(file, std::ios::binary);
    const std::array<std::int64_t, 3> sizes{static_cast<std::int64_t>(matrix.size()),
                                            static_cast<std::int64_t>(matrix.column.size()),
                                            matrix.places.dimension};
    out << kMagic;
    put<std::int64_t>(out, sizes);
    put<PairIndex>(out, matrix.rowStart);
    put<Index>(out, matrix.column);
    put<float>(out, matrix.offDiagonal);
    for (const Span<const Real> values : {Span<const Real>(matrix.diagonal), b, x})
        put<Real>(out, values);
    if (matrix.places.known()) {
        put<Real>(out, matrix.places.coordinate);
        put<Real>(out, matrix.places.spacing);
        put<Index>(out, matrix.places.particle);
    }
    if (!out.flush()) fail(file, "cannot be written");
}

Equation readEquation(const std::filesystem::path& file)
{
    std::ifstream in(file, std::ios::binary);
    if (!in) fail(file, "cannot be opened");
    std::string magic(kMagic.size(), ' ');
    in.read(magic.data(), static_cast<std::streamsize>(magic.size()));
    std::vector<std::int64_t> sizes;
    take(in, sizes, 3);
    if (!in || magic != kMagic) fail(file, "holds no pressure equation of this version");
    const auto rows = static_cast<std::size_t>(sizes[0]),
               entries = static_cast<std::size_t>(sizes[1]);
    Equation equation;
    SymmetricMatrix& matrix = equation.matrix;
    take(in, matrix.rowStart, rows + 1);
    take(in, matrix.column, entries);
    take(in, matrix.offDiagonal, entries);
    take(in, matrix.diagonal, rows);
    take(in, equation.b, rows);
    take(in, equation.x, rows);
    matrix.places.dimension = static_cast<int>(sizes[2]);
    if (matrix.places.known()) {
        take(in, matrix.places.coordinate, rows * matrix.places.dimension);
        take(in, matrix.places.spacing, rows);
    }
    if (!in) fail(file, "ends before its time");
    if (matrix.places.known() && in.peek() != EOF) take(in, matrix.places.particle, rows);
    if (!in) fail(file, "ends before its time");
    return equation;
}

SolverReport RecordingSolver::solve(const SymmetricMatrix& matrix, Span<const Real> b, Span<Real> x)
{
    if (solves_++ % interval_ == 0) {
        const char* folder = std::getenv("FOAM_CASE");
        writeEquation(std::filesystem::path(folder ? folder : ".") / "postProcessing" /
                          "pressureEquation" / fmt::format("{}.equation", solves_ - 1),
                      matrix, b, x);
    }
    return solver_->solve(matrix, b, x);
}

}  // namespace isph
