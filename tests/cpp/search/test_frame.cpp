#include "pilotage/search/frame.hpp"

#include "support/matchers.hpp"
#include "support/random.hpp"

namespace pilotage::test {
namespace {

TEST(FrameTest, SomethingOneMetreAheadOfARobotThatLooksNorth) {
    const Frame robot(Pose<double>(3, 4, kPi<double> / 2));
    EXPECT_TRUE(
        same_pose(robot.out_of({1, 0, 0.1}), Pose<double>(3, 5, kPi<double> / 2 + 0.1), 1e-12));
}

TEST(FrameTest, IntoUndoesOutOf) {
    Draw draw(1);
    for (int i = 0; i < 100; ++i) {
        const auto outer = draw.pose<double>(), inner = draw.pose<double>();
        EXPECT_TRUE(same_pose(Frame(outer).into(Frame(outer).out_of(inner)), inner, 1e-12));
    }
}

TEST(FrameTest, OneByTurnIsOneByHeading) {
    const Pose<double> pose(1, 2, -2.5);
    const Frame frame({1, 2}, {std::cos(-2.5), std::sin(-2.5)});
    EXPECT_TRUE(same_pose(frame.pose(), pose, 1e-12));
    EXPECT_TRUE(same_pose(frame.out_of({5, 6, 1}), Frame(pose).out_of({5, 6, 1}), 1e-12));
}

}  // namespace
}  // namespace pilotage::test
