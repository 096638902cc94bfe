// Markers are found by id, whatever the order in which they were given.

#include "pilotage/marker_map.hpp"

#include <gtest/gtest.h>

namespace pilotage::test {
namespace {

TEST(MarkerMapTest, FindsEachMarkerByItsId) {
    const MarkerMap map({{7, 1, 2, 3, 0.1}, {2147483647, 4, 5, 6, 0}, {0, 7, 8, 9, 0}});
    ASSERT_NE(map.find(7), nullptr);
    EXPECT_EQ(map.find(7)->x_m, 1);
    EXPECT_EQ(map.find(7)->sigma_m, 0.1);
    ASSERT_NE(map.find(0), nullptr);
    EXPECT_EQ(map.find(0)->y_m, 8);
    ASSERT_NE(map.find(2147483647), nullptr);
    EXPECT_EQ(map.find(2147483647)->z_m, 6);
}

TEST(MarkerMapTest, FindsNothingForAnIdThatIsNotThere) {
    const MarkerMap map({{3, 0, 0, 0, 0}, {5, 0, 0, 0, 0}});
    for (const std::int32_t id : {-1, 0, 2, 4, 6, 2147483647, -2147483647 - 1})
        EXPECT_EQ(map.find(id), nullptr) << id;
}

TEST(MarkerMapTest, IsEmptyUntilMarkersAreGiven) {
    EXPECT_TRUE(MarkerMap().markers().empty());
    EXPECT_EQ(MarkerMap().find(0), nullptr);
    EXPECT_EQ(MarkerMap().find(-1), nullptr);
}

TEST(MarkerMapTest, WantsLabelsWhereAnyMarkerHasOne) {
    const MarkerMap plain({{3, 0, 0, 0, 0}, {5, 0, 0, 0, 0}});
    const MarkerMap labelled({{3, 0, 0, 0, 0}, {5, 0, 0, 0, 0, 0}});
    EXPECT_EQ(plain.wanted_label(7), -1);
    EXPECT_EQ(labelled.wanted_label(7), 7);
    EXPECT_EQ(labelled.wanted_label(-1), -1);
}

TEST(MarkerMapTest, ListsItsMarkersById) {
    const MarkerMap map({{9, 0, 0, 0, 0}, {1, 0, 0, 0, 0}, {4, 0, 0, 0, 0}});
    ASSERT_EQ(map.markers().size(), 3U);
    EXPECT_EQ(map.markers()[0].id, 1);
    EXPECT_EQ(map.markers()[1].id, 4);
    EXPECT_EQ(map.markers()[2].id, 9);
}

}  // namespace
}  // namespace pilotage::test
