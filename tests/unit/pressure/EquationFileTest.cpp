// SPDX-License-Identifier: GPL-3.0-or-later
#include "LayeredTank.hpp"
#include "SolverTesting.hpp"

#include "core/Error.hpp"
#include "pressure/EquationFile.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <fmt/core.h>

using namespace isph;
using namespace isph::test;
namespace fs = std::filesystem;

namespace {

class EquationFile : public testing::Test {
protected:
    EquationFile() { fs::create_directories(folder_); }
    ~EquationFile() override { fs::remove_all(folder_); }

    const fs::path folder_ = fs::temp_directory_path() / fmt::format("isphEquation{}", getpid());
    const PressureSystem system_ = pressureSystem(LayeredTank{.dimension = 3, .particles = 500});
};

}  // namespace

TEST_F(EquationFile, GivesBackWhatWasWritten)
{
    const std::vector<Real> x(system_.b.size(), 0.25);
    writeEquation(folder_ / "a", system_.matrix, system_.b, x);
    const Equation equation = readEquation(folder_ / "a");
    EXPECT_EQ(equation.matrix.rowStart, system_.matrix.rowStart);
    EXPECT_EQ(equation.matrix.column, system_.matrix.column);
    EXPECT_EQ(equation.matrix.offDiagonal, system_.matrix.offDiagonal);
    EXPECT_EQ(equation.matrix.diagonal, system_.matrix.diagonal);
    EXPECT_EQ(equation.matrix.places.dimension, 3);
    EXPECT_EQ(equation.matrix.places.coordinate, system_.matrix.places.coordinate);
    EXPECT_EQ(equation.b, system_.b);
    EXPECT_EQ(equation.x, x);
}

TEST_F(EquationFile, CutOffIsAnErrorThatNamesTheFile)
{
    const fs::path file = folder_ / "cut";
    for (const int divisor : {1000, 2}) {
        writeEquation(file, system_.matrix, system_.b, system_.b);
        fs::resize_file(file, fs::file_size(file) / divisor);
        try {
            readEquation(file);
            ADD_FAILURE() << "no error";
        } catch (const FatalError& error) {
            EXPECT_NE(std::string(error.what()).find(file.string()), std::string::npos);
        }
    }
}

TEST_F(EquationFile, IsWrittenEveryIntervalWithTheFirstGuess)
{
    const char* before = std::getenv("FOAM_CASE");
    const std::string home = before ? before : "";
    setenv("FOAM_CASE", folder_.c_str(), 1);
    const auto solver = solverOf("solver PCG; recordInterval 2;");
    std::vector<Real> x(system_.b.size(), 0.5);
    for (int step = 0; step < 3; ++step) solver->solve(system_.matrix, system_.b, x);
    before ? setenv("FOAM_CASE", home.c_str(), 1) : unsetenv("FOAM_CASE");
    const fs::path written = folder_ / "postProcessing" / "pressureEquation";
    EXPECT_EQ(readEquation(written / "0.equation").x, std::vector<Real>(x.size(), 0.5));
    EXPECT_FALSE(fs::exists(written / "1.equation"));
    EXPECT_EQ(readEquation(written / "2.equation").x, x) << "converged at the first solve";
}
