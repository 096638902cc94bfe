// A robot that is picked up: the gyro turns while the wheels stand.

#include "support/journeys.hpp"
#include "support/localizers.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_LOCALIZER_SUITE(LiftTest);

TEST_P(LiftTest, TurnsTheHeadingByTheGyroAndDoubtsThePosition) {
    for (const double rate : {0.7, -0.7}) {
        Robot robot(GetParam(), gyro_params(), kAroundOrigin);
        Journey journey(kAroundOrigin);
        journey.camera = false;
        robot.add(journey.go(3));
        const double sure = robot.covariance()(0, 0);
        journey.carried_m_s = 0.8;
        journey.carried_rad_s = rate;
        robot.add(journey.go(3));
        const Estimate e = robot.estimate();
        EXPECT_EQ(e.motion, MotionState::lifted);
        EXPECT_NEAR(wrap(e.pose[kHeading] - journey.truth[kHeading]), 0, 2e-3)
            << "what was not believed at first is made good";
        EXPECT_GT(e.covariance(0, 0), sure + 1);
        EXPECT_LT(contradiction(e.pose, e.covariance, journey.truth), kRare);
    }
}

TEST_P(LiftTest, EndsWithTheTicksOfTheWheels) {
    Robot robot(GetParam(), gyro_params(), kAroundOrigin);
    Journey journey(kAroundOrigin);
    journey.camera = false;
    robot.add(journey.go(2));
    journey.carried_rad_s = 0.7;
    robot.add(journey.go(1.2));
    EXPECT_EQ(robot.estimate().motion, MotionState::lifted);
    journey.carried_rad_s = 0;
    robot.add(journey.go(0.1, 0.5, 0));
    EXPECT_EQ(robot.estimate().motion, MotionState::driving);
    const double variance = robot.covariance()(0, 0);
    robot.add(journey.go(2, 0.5, 0));
    EXPECT_LT(robot.covariance()(0, 0), variance + 0.1) << "driving again doubts no more";
}

TEST_P(LiftTest, IsFoundAgainBySightingsAndNeverOkWhereItIsNot) {
    Robot robot(GetParam(), gyro_params(), kAroundOrigin);
    Journey journey(kAroundOrigin);
    robot.add(journey.go(3));
    ASSERT_EQ(robot.estimate().status, Status::ok);
    journey.camera = false;
    journey.carried_m_s = 0.8;
    journey.carried_rad_s = 0.7;
    robot.add(journey.go(3));
    EXPECT_NE(robot.estimate().status, Status::ok) << "2 m off";
    journey.camera = true;
    journey.carried_m_s = journey.carried_rad_s = 0;
    for (int i = 0; i < 200; ++i) {
        robot.add(journey.go(0.1, 0.3, 0.1));
        const Estimate e = robot.estimate();
        if (e.status != Status::ok) continue;
        ASSERT_LT(contradiction(e.pose, e.covariance, journey.truth), kRare) << "step " << i;
    }
    EXPECT_EQ(robot.estimate().status, Status::ok);
    EXPECT_TRUE(same_pose(robot.pose(), journey.truth, 0.15));
}

/// Without a turn nothing on board notices; the sightings do.
TEST_P(LiftTest, WithoutATurnIsToldByTheSightings) {
    Robot robot(GetParam(), gyro_params(), kAroundOrigin);
    Journey journey(kAroundOrigin);
    robot.add(journey.go(3));
    journey.camera = false;
    journey.carried_m_s = 1;
    robot.add(journey.go(3));
    journey.carried_m_s = 0;
    journey.camera = true;
    EXPECT_EQ(robot.estimate().motion, MotionState::standing);
    robot.add(journey.go(1));
    EXPECT_TRUE(robot.estimate().status != Status::ok ||
                same_pose(robot.pose(), journey.truth, 0.3));
    robot.add(journey.go(30));
    EXPECT_EQ(robot.estimate().status, Status::ok);
    EXPECT_TRUE(same_pose(robot.pose(), journey.truth, 0.15));
}

TEST_P(LiftTest, IsNoLiftWhereTheGyroIsSilent) {
    Robot robot(GetParam(), gyro_params(), kAroundOrigin);
    Journey journey(kAroundOrigin);
    journey.camera = journey.gyro = false;
    journey.carried_rad_s = 0.7;
    robot.add(journey.go(3));
    EXPECT_EQ(robot.estimate().motion, MotionState::standing);
}

}  // namespace
}  // namespace pilotage::test
