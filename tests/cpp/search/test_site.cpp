#include "pilotage/search/site.hpp"

#include <gtest/gtest.h>

namespace pilotage::test {
namespace {

TEST(SiteTest, IsTheMarkersBoxGrownByItsDiagonal) {
    const Site site(MarkerMap({{1, 0, 0, 0, 0}, {2, 30, 40, 0, 0}}));
    EXPECT_EQ(site.reach_m, 50);
    EXPECT_TRUE(site.holds(-49, 89));
    EXPECT_FALSE(site.holds(-51, 0));
    EXPECT_FALSE(site.holds(0, 91));
    EXPECT_NEAR(site.log_volume(), std::log(130 * 140 * 2 * kPi<double>), 1e-12);
}

TEST(SiteTest, MarkersInALineOrOneOrNoneStillLeaveRoom) {
    for (const MarkerMap& map : {MarkerMap({{1, 0, 5, 0, 0}, {2, 8, 5, 0, 0}}),
                                 MarkerMap({{1, 0, 5, 0, 0}}), MarkerMap()}) {
        const Site site(map);
        EXPECT_TRUE(site.holds(0, 0));
        EXPECT_TRUE(std::isfinite(site.log_volume()));
        EXPECT_GT(site.variances().minCoeff(), 1);
    }
}

}  // namespace
}  // namespace pilotage::test
