// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/Vec.hpp"

#include <gtest/gtest.h>

using namespace isph;

TEST(Mat, TheInverseTimesTheMatrixIsTheIdentity)
{
    const Mat<3> m{{Vec<3>{{2, 1, 0.5}}, Vec<3>{{-1, 3, 0.25}}, Vec<3>{{0, 0.5, 1}}}};
    const Mat<3> product = m * inverse(m);
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(product[r][c], r == c, 1e-14);
}

TEST(Mat, TheSmallestEigenvalueOfARotatedDiagonalIsItsSmallestEntry)
{
    // R diag(1, 2, 5) R^T with R a rotation by 0.7 about the axis (1,1,0)/sqrt(2), by Rodrigues
    const Real s = std::sqrt(0.5), c = std::cos(0.7), z = std::sin(0.7);
    Mat<3> cross{{Vec<3>{{0, 0, s}}, Vec<3>{{0, 0, -s}}, Vec<3>{{-s, s, 0}}}};
    Mat<3> rotation = Mat<3>::identity() + z * cross + (1 - c) * (cross * cross);
    Mat<3> diagonal;
    diagonal[0][0] = 1, diagonal[1][1] = 2, diagonal[2][2] = 5;
    EXPECT_NEAR(smallestEigenvalue(rotation * diagonal * transpose(rotation)), 1.0, 1e-13);
    EXPECT_NEAR(smallestEigenvalue(Mat<2>{{Vec<2>{{3, 1}}, Vec<2>{{1, 3}}}}), 2.0, 1e-14);
}
