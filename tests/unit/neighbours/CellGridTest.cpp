// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Scatter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace isph;

namespace {

template <int Dim>
void expectEveryNearPointToBeVisitedOnce(const std::vector<Vec<Dim>>& x, Real edge, Real radius)
{
    CellGrid<Dim> grid;
    grid.build(x, edge);
    for (const Vec<Dim>& centre : x) {
        std::vector<Index> seen;
        grid.forEachNear(centre, radius, [&](Index j) { seen.push_back(j); });
        std::sort(seen.begin(), seen.end());
        ASSERT_EQ(std::adjacent_find(seen.begin(), seen.end()), seen.end());
        for (Index j = 0; j < static_cast<Index>(x.size()); ++j)
            if (norm(x[j] - centre) < radius) {
                ASSERT_TRUE(std::binary_search(seen.begin(), seen.end(), j));
            }
    }
}

TEST(CellGrid, VisitsEveryPointWithinTheRadiusOnce)
{
    expectEveryNearPointToBeVisitedOnce<2>(shakenPoints<2>(12).x, 3, 3);
    expectEveryNearPointToBeVisitedOnce<3>(shakenPoints<3>(7).x, 2, 1.5);
}

TEST(CellGrid, FindsTheWaterWhenADropIsFarAway)
{
    std::vector<Vec<2>> x = shakenPoints<2>(10).x;
    x.push_back({1e7, -1e7});   // 1e13 cells of this edge: they have to grow
    expectEveryNearPointToBeVisitedOnce<2>(x, 3, 3);
}

TEST(CellGrid, WithoutPointsVisitsNothing)
{
    CellGrid<2> grid;
    grid.build({}, 1);
    EXPECT_TRUE(grid.empty());
    grid.forEachNear({0, 0}, 1, [](Index) { ADD_FAILURE(); });
}

TEST(CellGrid, ItsOrderHoldsEveryPointOnce)
{
    CellGrid<3> grid;
    grid.build(shakenPoints<3>(6).x, 2);
    EXPECT_EQ(std::set<Index>(grid.order().begin(), grid.order().end()).size(), 216u);
}

TEST(CellGrid, PlacesOutsideTheCloudAreSearchedToo)
{
    const std::vector<Vec<2>> x = {{0, 0}, {5, 5}};
    CellGrid<2> grid;
    grid.build(x, 1);
    std::vector<Index> seen;
    grid.forEachNear({-0.9, -0.1}, 1, [&](Index j) { seen.push_back(j); });
    EXPECT_EQ(seen, std::vector<Index>{0});
}

}  // namespace
