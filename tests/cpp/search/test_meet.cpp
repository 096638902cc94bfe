// Where two sightings put the robot: against exact geometry.

#include "pilotage/search/meet.hpp"

#include "pilotage/search/rigid_fit.hpp"
#include "support/geometry.hpp"
#include "support/matchers.hpp"
#include "support/random.hpp"

namespace pilotage::test {
namespace {

struct Meeting {
    Pose<double> robot, place;
    Point a, b;
};

std::vector<Meeting> meetings() {
    Draw draw(1);
    std::vector<Meeting> result;
    for (int i = 0; i < 100; ++i) {
        const auto robot = draw.pose<double>();
        const auto near = [&] {
            return Point(robot[kX] + draw.uniform(-9, 9), robot[kY] + draw.uniform(-9, 9));
        };
        result.push_back({robot, {draw.uniform(-1, 1), draw.uniform(-1, 1), 0}, near(), near()});
    }
    return result;
}

bool puts(const Places& places, const Pose<double>& robot) {
    for (int i = 0; i < places.count; ++i)
        if ((places.place[i] - robot.head<2>()).norm() < 1e-5) return true;
    return false;
}

TEST(MeetTest, RaysAndCirclesFromTwoPlacesMeetWhereTheRobotIs) {
    for (const Meeting& s : meetings())
        for (const bool ray_a : {true, false})
            for (const bool ray_b : {true, false}) {
                const Clue a = exact_clue(s.robot, {0, 0, 0}, s.a, ray_a, !ray_a);
                const Clue b = exact_clue(s.robot, s.place, s.b, ray_b, !ray_b);
                EXPECT_TRUE(puts(meet(a, b, direction(s.robot[kHeading])), s.robot))
                    << ray_a << ray_b;
            }
}

TEST(MeetTest, MarkersAreAheadOfTheirBearings) {
    for (const Meeting& s : meetings()) {
        const Clue a = exact_clue(s.robot, {0, 0, 0}, s.a, true, false);
        const Clue b = exact_clue(s.robot, {0, 0, 0}, s.b, true, false);
        EXPECT_TRUE(ahead(a, s.robot.head<2>(), direction(s.robot[kHeading])));
        EXPECT_FALSE(ahead(a, s.robot.head<2>(), direction(s.robot[kHeading] + kPi<double>)));
        EXPECT_EQ(meet(a, b, direction(s.robot[kHeading] + kPi<double>)).count, 0);
    }
}

TEST(MeetTest, TwoDistancesLeaveTheMirrorImage) {
    const Clue a = exact_clue({3, 4, 0}, {0, 0, 0}, {0, 0}, false, true);
    const Clue b = exact_clue({3, 4, 0}, {0, 0, 0}, {10, 0}, false, true);
    const Places places = meet(a, b, {1, 0});
    ASSERT_EQ(places.count, 2);
    EXPECT_NEAR((places.place[0] - Point(3, 4)).norm() * (places.place[1] - Point(3, 4)).norm(), 0,
                1e-9);
    EXPECT_NEAR((places.place[0] - Point(3, -4)).norm() * (places.place[1] - Point(3, -4)).norm(),
                0, 1e-9);
}

TEST(MeetTest, CirclesThatNoiseKeepsApartMeetHalfwayAndFarOnesDoNot) {
    Clue a, b;
    a.marker = {0, 0};
    b.marker = {10, 0};
    a.place = b.place = {0, 0};
    a.has_distance = b.has_distance = true;
    a.distance_m = b.distance_m = 4.9;
    EXPECT_EQ(meet(a, b, {1, 0}).count, 1);
    b.distance_m = 3;
    EXPECT_EQ(meet(a, b, {1, 0}).count, 0);
    b.distance_m = 20;
    EXPECT_EQ(meet(a, b, {1, 0}).count, 0);
    b.marker = a.marker;
    EXPECT_EQ(meet(a, b, {1, 0}).count, 0);
}

TEST(RigidFitTest, TwoPointsGiveThePose) {
    for (const Meeting& s : meetings()) {
        const Clue a = exact_clue(s.robot, {0, 0, 0}, s.a, true, true);
        const Clue b = exact_clue(s.robot, s.place, s.b, true, true);
        ASSERT_TRUE(same_distance(a, b));
        const Point turn = turn_by(a, b);
        EXPECT_TRUE(same_pose(Frame(place_by(a, b, turn), turn).pose(), s.robot, 1e-9));
        EXPECT_TRUE(close(place_by_point(a, turn), s.robot.head<2>(), 1e-9));
    }
}

TEST(RigidFitTest, PointsTooFarApartAreOtherMarkers) {
    const Clue a = exact_clue({0, 0, 0}, {0, 0, 0}, {5, 1}, true, true);
    Clue b = exact_clue({0, 0, 0}, {0, 0, 0}, {5, -1}, true, true);
    b.marker = {5, -1.1};
    EXPECT_FALSE(same_distance(a, b));
    b.variance_m2 = 0.01;
    EXPECT_TRUE(same_distance(a, b));
}

}  // namespace
}  // namespace pilotage::test
