#include "pilotage/wall_map.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"
#include "support/scalars.hpp"
#include "support/worlds.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(WallMapTest);

constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <typename Scalar = double>
Scalar range(const WallMap& map, double x, double y, double angle) {
    const Vector<Scalar, 2> forward(Scalar(std::cos(angle)), Scalar(std::sin(angle)));
    return map.cast(Scalar(x), Scalar(y), forward).range_m;
}

// The runnable example: from the middle of a room of 4 m by 2 m.
TEST(WallMap, BeamMeetsTheWallAhead) {
    const WallMap room(ring({{0, 0}, {4, 0}, {4, 2}, {0, 2}}));
    EXPECT_DOUBLE_EQ(range(room, 1, 1, 0), 3);
    EXPECT_DOUBLE_EQ(range(room, 1, 1, kPi<double> / 2), 1);
    EXPECT_DOUBLE_EQ(range(room, 1, 1, kPi<double>), 1);
    EXPECT_DOUBLE_EQ(range(room, 1, 1, kPi<double> / 4), std::sqrt(2.0));  // a corner of two walls
}

TYPED_TEST(WallMapTest, NearestOfSeveralWallsCounts) {
    const WallMap corridor({{9, -1, 9, 1}, {3, -1, 3, 1}, {6, 1, 6, -1}, {-2, 1, -2, -1}});
    EXPECT_EQ(range<TypeParam>(corridor, 0, 0, 0), 3);
    EXPECT_EQ(range<TypeParam>(corridor, 4, 0, 0), 2);
}

TEST(WallMap, ConcaveRoomHidesWhatIsBehindItsCorner) {
    const WallMap room(ring({{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 2}, {0, 2}}));  // an L
    EXPECT_DOUBLE_EQ(range(room, 1, 1, 0), 3);
    EXPECT_DOUBLE_EQ(range(room, 1, 1, kPi<double> / 2), 1);
    EXPECT_DOUBLE_EQ(range(room, 3, 3, kPi<double>), 1);
    EXPECT_NEAR(range(room, 1, 1, 0.7853), std::hypot(3, 3), 1e-3);  // just past the inner corner
    EXPECT_NEAR(range(room, 1, 1, 0.7855), std::hypot(1, 1), 1e-3);  // just on it
}

TEST(WallMap, FromOutsideTheNearSideIsSeen) {
    const WallMap box(ring({{0, 0}, {4, 0}, {4, 2}, {0, 2}}));
    EXPECT_DOUBLE_EQ(range(box, -3, 1, 0), 3);
    EXPECT_EQ(range(box, -3, 1, kPi<double>), kInfinity);
}

TEST(WallMap, NothingAheadIsInfinitelyFar) {
    EXPECT_EQ(range(WallMap{}, 0, 0, 0), kInfinity);
    EXPECT_EQ(range(WallMap({{1, 1, 2, 1}}), 0, 0, 0), kInfinity);
    EXPECT_EQ(range(WallMap({{1, 0, 2, 0}}), 0, 0, 0), kInfinity);  // a wall seen end on
    EXPECT_FALSE(WallMap{}.cast(0.0, 0.0, Vector<double, 2>(1, 0)).any());
}

TEST(WallMap, NormalIsAcrossTheWall) {
    const auto hit = WallMap({{2, -1, 3, 4}}).cast(0.0, 0.0, Vector<double, 2>(1, 0));
    EXPECT_DOUBLE_EQ(hit.normal.dot(Vector<double, 2>(1, 5)), 0);
    EXPECT_GT(hit.normal.norm(), 0);
}

// Aimed at the vertices of a polygon from anywhere inside: rounding opens no gap between walls.
TEST(WallMap, BeamThroughAVertexNeverSlipsOut) {
    Draw draw(7);
    std::vector<Vector<double, 2>> corners;
    for (int i = 0; i < 40; ++i)
        corners.emplace_back(17.3 * std::cos(i * kPi<double> / 20),
                             9.1 * std::sin(i * kPi<double> / 20));
    const WallMap room(ring(corners));
    for (int i = 0; i < 2000; ++i) {
        const Vector<double, 2> at(draw.uniform(-9, 9), draw.uniform(-5, 5));
        for (const auto& corner : corners) {
            const Vector<double, 2> way = corner - at;
            const auto hit = room.cast(at[0], at[1], Vector<double, 2>(way.normalized()));
            ASSERT_NEAR(hit.range_m, way.norm(), 1e-9) << at.transpose();
        }
    }
}

}  // namespace
}  // namespace pilotage::test
