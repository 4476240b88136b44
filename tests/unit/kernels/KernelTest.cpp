// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/Kernel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace isph;

namespace {

std::unique_ptr<Kernel> kernel(const std::string& name)
{
    return Kernel::select(Dictionary::parse("kernel " + name + ";"));
}

struct Values {
    std::vector<Real> q, w, slope;
};

/// The kernel at n midpoints of [from, to].
Values sample(const Kernel& kernel, Real from, Real to, std::size_t n)
{
    Values v;
    for (std::size_t k = 0; k < n; ++k)
        v.q.push_back(from + (to - from) * (static_cast<Real>(k) + 0.5) / static_cast<Real>(n));
    v.w.resize(n);
    v.slope.resize(n);
    kernel.evaluate(v.q, v.w, v.slope);
    return v;
}

Real at(const Kernel& kernel, Real q)
{
    return sample(kernel, q, q, 1).w[0];
}
Real slopeAt(const Kernel& kernel, Real q)
{
    return sample(kernel, q, q, 1).slope[0];
}

class EveryKernel : public testing::TestWithParam<std::string> {
protected:
    std::unique_ptr<Kernel> kernel_ = kernel(GetParam());
};

TEST_P(EveryKernel, HasTheIntegralOneInTwoAndThreeDimensions)
{
    const Real R = kernel_->supportRadius();
    const std::size_t n = 20000;
    const Values v = sample(*kernel_, 0, R, n);
    Real area = 0, volume = 0;
    for (std::size_t k = 0; k < n; ++k) {
        area += 2 * std::numbers::pi * v.q[k] * v.w[k] * R / n;
        volume += 4 * std::numbers::pi * sqr(v.q[k]) * v.w[k] * R / n;
    }
    // Midpoint rule: error about (R/n)^2/24 times the slope of the integrand, below 1e-7 relative.
    EXPECT_NEAR(kernel_->normalisation(2) * area, 1, 1e-7);
    EXPECT_NEAR(kernel_->normalisation(3) * volume, 1, 1e-7);
}

TEST_P(EveryKernel, HasTheSlopeOfItsShape)
{
    const Real step = 1e-5;
    for (const Real q : sample(*kernel_, step, kernel_->supportRadius() - step, 501).q) {
        const Real derivative = (at(*kernel_, q + step) - at(*kernel_, q - step)) / (2 * step);
        // Central difference: third derivative (below 600 w(0) here) times step^2/6, and round-off
        // w(0) 1e-16/step.
        EXPECT_NEAR(slopeAt(*kernel_, q) * q, derivative, 1e-7 * at(*kernel_, 0)) << "q = " << q;
    }
}

TEST_P(EveryKernel, HasAFiniteSlopeOverDistanceAtTheCentre)
{
    // w'/q -> w''(0), here by the second difference of the even function w.
    const Real step = 1e-3;
    const Real curvature = 2 * (at(*kernel_, step) - at(*kernel_, 0)) / sqr(step);
    EXPECT_NEAR(slopeAt(*kernel_, 0) / curvature, 1,
                10 * step);  // next term is of first order in step
    EXPECT_NEAR(slopeAt(*kernel_, 1e-12) / slopeAt(*kernel_, 0), 1, 1e-11);
}

TEST_P(EveryKernel, IsNowhereNegativeAndFallsMonotonously)
{
    const Values v = sample(*kernel_, 0, kernel_->supportRadius(), 2000);
    for (std::size_t k = 0; k < v.q.size(); ++k) {
        EXPECT_GT(v.w[k], 0) << "q = " << v.q[k];
        EXPECT_LT(v.slope[k], 0) << "q = " << v.q[k];
        EXPECT_LT(v.w[k], k > 0 ? v.w[k - 1] : 1e9) << "q = " << v.q[k];
    }
}

TEST_P(EveryKernel, EndsAtItsSupportRadius)
{
    const Real R = kernel_->supportRadius();
    for (const Real q : {R, R + 1e-9, 1.5 * R, 10 * R}) {
        EXPECT_EQ(at(*kernel_, q), 0) << "q = " << q;
        EXPECT_EQ(slopeAt(*kernel_, q), 0) << "q = " << q;
    }
    EXPECT_GT(at(*kernel_, 0.98 * R), 0);
}

TEST_P(EveryKernel, GivesTheSameBitsAloneAndInARow)
{
    const Values row =
        sample(*kernel_, 0, 1.1 * kernel_->supportRadius(), 37);  // not a vector width
    for (std::size_t k = 0; k < row.q.size(); ++k) {
        EXPECT_EQ(at(*kernel_, row.q[k]), row.w[k]) << "q = " << row.q[k];
        EXPECT_EQ(slopeAt(*kernel_, row.q[k]), row.slope[k]) << "q = " << row.q[k];
    }
}

INSTANTIATE_TEST_SUITE_P(Kernels, EveryKernel,
                         testing::Values("cubicSpline", "quinticSpline", "wendlandC2",
                                         "wendlandC4"),
                         [](const auto& chosen) { return chosen.param; });

TEST(Kernel, NamesAreThoseTested)
{
    EXPECT_EQ(Kernel::table().names(), (std::vector<std::string>{"cubicSpline", "quinticSpline",
                                                                 "wendlandC2", "wendlandC4"}));
}

TEST(Kernel, AnUnknownNameIsRefusedWithFileLineAndTheValidNames)
{
    try {
        Kernel::select(
            Dictionary::parse("smoothingRatio 1.5;\nkernel wendlandC3;\n", "isphSchemes"));
        FAIL() << "accepted";
    } catch (const FatalIOError& error) {
        const std::string text = error.what();
        EXPECT_EQ(error.file(), "isphSchemes");
        EXPECT_EQ(error.line(), 2);
        EXPECT_NE(text.find("Unknown kernel type wendlandC3, did you mean wendlandC2?"),
                  std::string::npos)
            << text;
        EXPECT_NE(text.find("Valid kernel types are:\n\n4\n(\n    cubicSpline\n"),
                  std::string::npos)
            << text;
    }
}

}  // namespace
