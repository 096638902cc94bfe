// Dead reckoning through the localizer: drives end where geometry says.

#include "support/localizers.hpp"
#include "support/robots.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_LOCALIZER_SUITE(DrivingTest);

TEST_P(DrivingTest, AStandingRobotStaysWhereItIs) {
    Params params = plain_params();
    params.initial = {3, -4, 2, 0.1, 0.05};
    Robot robot(GetParam(), params);
    const Matrix<double, 3> before = robot.estimate().covariance;
    robot.add(drive(500, 0, 0));
    const Estimate e = robot.estimate();
    EXPECT_TRUE(same_pose(e.pose, Pose<double>(3, -4, 2), 1e-6));
    EXPECT_TRUE(close(e.covariance, before, 0)) << "wheels that stand add no noise";
    EXPECT_EQ(e.v_m_s, 0);
    EXPECT_EQ(e.omega_rad_s, 0);
    EXPECT_EQ(e.utime, 500 * kPeriod);
}

TEST_P(DrivingTest, AStraightDriveEndsStraightAhead) {
    Params params = plain_params();
    params.initial.heading_rad = 0.7;
    Robot robot(GetParam(), params);
    robot.add(drive(1000, 10, 10));
    const Pose<double> expected = after_arc({0, 0, 0.7}, 10, 0);
    EXPECT_TRUE(same_pose(robot.pose(), expected, GetParam().tolerance));
    EXPECT_NEAR(robot.estimate().v_m_s, 0.5, 1e-6);
}

TEST_P(DrivingTest, ACircleEndsOnTheCircle) {
    Robot robot(GetParam(), plain_params());
    robot.add(drive(1500, 9, 11));
    EXPECT_TRUE(same_pose(robot.pose(), after_arc({0, 0, 0}, 15, 6), GetParam().tolerance));
    EXPECT_NEAR(robot.estimate().omega_rad_s, 0.2, 1e-6);
}

TEST_P(DrivingTest, ATurnOnTheSpotMovesNothingButTheHeading) {
    Robot robot(GetParam(), plain_params());
    robot.add(drive(600, -4, 4));
    EXPECT_TRUE(same_pose(robot.pose(), Pose<double>(0, 0, wrap(9.6)), GetParam().tolerance));
}

TEST_P(DrivingTest, SpeedsHeldOverTheirIntervalsDriveTheSameCircle) {
    Params params = plain_params();
    params.motion.source = MotionSource::velocity;
    Robot robot(GetParam(), params);
    for (int i = 0; i <= 1500; ++i) robot.add(velocity_at(i * kPeriod, 0.5, 0.2));
    EXPECT_TRUE(same_pose(robot.pose(), after_arc({0, 0, 0}, 15, 6), GetParam().tolerance));
}

TEST_P(DrivingTest, ASpeedHoldsNoLongerThanTheGap) {
    Params params = plain_params();
    params.motion.source = MotionSource::velocity;
    Robot robot(GetParam(), params);
    for (const std::int64_t t : {0, 1, 11}) robot.add(velocity_at(t * kSecond, 1, 0));
    EXPECT_NEAR(robot.pose()[kX], 2 * params.motion.max_gap_s, 1e-6);
    EXPECT_EQ(robot.estimate().utime, 11 * kSecond);
}

TEST_P(DrivingTest, EncodersBridgeAGapInFull) {
    Robot robot(GetParam(), plain_params());
    robot.add(encoders_at(0, 0, 0));
    robot.add(encoders_at(kPeriod, 10, 10));
    robot.add(encoders_at(10 * kSecond, 5010, 5010));
    EXPECT_NEAR(robot.pose()[kX], 5.01, 1e-6);
}

TEST_P(DrivingTest, ASlipAngleTurnsTheDirectionOfTravel) {
    Params params = plain_params();
    params.motion.slip_angle_rad = 0.3;
    Robot robot(GetParam(), params);
    robot.add(drive(100, 10, 10));
    EXPECT_TRUE(same_pose(robot.pose(), Pose<double>(std::cos(0.3), std::sin(0.3), 0),
                          GetParam().tolerance));
}

TEST_P(DrivingTest, WheelsMayCountBackwardsOrDifferently) {
    Params params = plain_params();
    params.wheels.left_m_per_tick = -0.001;
    params.wheels.right_m_per_tick = 0.0005;
    Robot robot(GetParam(), params);
    robot.add(drive(1500, -9, 22));
    EXPECT_TRUE(same_pose(robot.pose(), after_arc({0, 0, 0}, 15, 6), GetParam().tolerance));
}

TEST_P(DrivingTest, TheFirstCountsMayBeAnything) {
    Robot robot(GetParam(), plain_params());
    for (int i = 0; i <= 100; ++i)
        robot.add(encoders_at(i * kPeriod, 9'000'000'000'000 + 10 * i, -77 + 10 * i));
    EXPECT_TRUE(same_pose(robot.pose(), Pose<double>(1, 0, 0), GetParam().tolerance));
}

TEST_P(DrivingTest, NoTravelIsLostWhereStampsRepeat) {
    Robot robot(GetParam(), plain_params());
    for (int i = 0; i <= 1500; ++i)  // stamped in pairs
        robot.add(encoders_at((i / 2) * 2 * kPeriod, 9 * i, 11 * i, i));
    EXPECT_TRUE(same_pose(robot.pose(), after_arc({0, 0, 0}, 15, 6), GetParam().tolerance));
    EXPECT_EQ(robot.tally.count(Verdict::fused), 1501);
}

TEST_P(DrivingTest, AStepBackInTimeIsALateSampleInItsPlace) {
    Robot robot(GetParam(), plain_params());
    EXPECT_TRUE(robot.add(encoders_at(0, 0, 0)));
    EXPECT_TRUE(robot.add(encoders_at(2 * kPeriod, 18, 22)));
    EXPECT_FALSE(robot.add(encoders_at(kPeriod, 9, 11))) << "the newest motion is no newer";
    EXPECT_TRUE(robot.add(encoders_at(3 * kPeriod, 27, 33)));
    EXPECT_EQ(robot.estimate().utime, 3 * kPeriod);
    EXPECT_TRUE(same_pose(robot.pose(), after_arc({0, 0, 0}, 0.03, 0.012), 1e-6));
    EXPECT_EQ(robot.tally.count(Verdict::fused), 4);
}

TEST_P(DrivingTest, CountersThatWrapDriveOn) {
    for (const std::int64_t turn : {std::int64_t{1} << 16, std::int64_t{1} << 32})
        for (const std::int64_t first : {turn / 2, turn}) {  // signed and unsigned counters
            Robot robot(GetParam(), plain_params());
            for (int i = 0; i <= 200; ++i) {
                std::int64_t left = first - 500 + 9 * i, right = first - 700 + 11 * i;
                if (left >= first) left -= turn;
                if (right >= first) right -= turn;
                robot.add(encoders_at(i * kPeriod, left, right));
            }
            EXPECT_TRUE(same_pose(robot.pose(), after_arc({0, 0, 0}, 2, 0.8), 1e-4)) << turn;
            EXPECT_EQ(robot.tally.rejected(), 0);
        }
}

TEST_P(DrivingTest, CountersThatStartAgainLoseOneStepAndAreCounted) {
    Robot robot(GetParam(), plain_params());
    for (int i = 0; i <= 100; ++i)
        robot.add(encoders_at(i * kPeriod, 20'000 + 10 * i, 20'000 + 10 * i));
    for (int i = 1; i <= 100; ++i) robot.add(encoders_at((100 + i) * kPeriod, 10 * i, 10 * i));
    EXPECT_TRUE(same_pose(robot.pose(), Pose<double>(1.99, 0, 0), 1e-4));
    EXPECT_EQ(robot.tally.count(Verdict::counter_reset), 1);
    EXPECT_EQ(robot.tally.of(encoders_at(101 * kPeriod, 10, 10)), Verdict::counter_reset);
    expect_sums_hold(robot);
}

}  // namespace
}  // namespace pilotage::test
