// Wheels and gyro that contradict each other: a spinning wheel, a gyro in degrees, a gyro mounted
// upside down. The truth stays inside the covariance, and sightings bring the robot back.

#include "support/journeys.hpp"
#include "support/localizers.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_LOCALIZER_SUITE(SlipTest);

struct Spin {
    double left_m_s, right_m_s;
};
constexpr Spin kSpins[] = {{0.5, 0}, {0, 0.5}, {-0.5, 0}, {0, -0.5}, {2, 0}};

/// As long as a window of the check and a step: sooner nothing can be known.
constexpr double kUnnoticed_s = 0.6;

/// Sightings from metres off are fused as if the world were linear there; the next ones mend it.
constexpr double kFirstFrames_s = 0.5;

/// Every tenth of a second, the truth is inside the covariance wherever the status says OK.
void expect_honest(Robot& robot, Journey& journey, double seconds, double v, double omega) {
    for (int i = 0; i < std::lround(10 * seconds); ++i) {
        robot.add(journey.go(0.1, v, omega));
        const Estimate e = robot.estimate();
        if (e.status != Status::ok) continue;
        ASSERT_LT(contradiction(e.pose, e.covariance, journey.truth), kRare)
            << "OK after " << i / 10.0 << " s at " << e.pose.transpose() << ", in truth "
            << journey.truth.transpose();
    }
}

TEST_P(SlipTest, OfAWheelKeepsTheTruthInsideTheCovariance) {
    for (const HeadingSource heading : {HeadingSource::gyro, HeadingSource::both})
        for (const Spin& spin : kSpins) {
            SCOPED_TRACE(::testing::Message() << spin.left_m_s << " " << spin.right_m_s);
            Robot robot(GetParam(), params_with(heading), kAroundOrigin);
            Journey journey(kAroundOrigin);
            journey.camera = false;
            robot.add(journey.go(2, 0.4, 0));
            const double sure = robot.covariance()(0, 0);
            journey.left_spin_m_s = spin.left_m_s;
            journey.right_spin_m_s = spin.right_m_s;
            robot.add(journey.go(3, 0.4, 0));
            EXPECT_EQ(robot.estimate().motion, MotionState::slipping);
            EXPECT_GT(robot.covariance()(0, 0), 10 * sure);
            journey.left_spin_m_s = journey.right_spin_m_s = 0;
            robot.add(journey.go(1, 0.4, 0));
            const Estimate e = robot.estimate();
            EXPECT_EQ(e.motion, MotionState::driving);
            EXPECT_LT(contradiction(e.pose, e.covariance, journey.truth), kRare);
        }
}

TEST_P(SlipTest, IsMadeGoodBySightings) {
    for (const Spin& spin : kSpins) {
        SCOPED_TRACE(::testing::Message() << spin.left_m_s << " " << spin.right_m_s);
        Robot robot(GetParam(), params_with(HeadingSource::gyro), kAroundOrigin);
        Journey journey(kAroundOrigin);
        robot.add(journey.go(2, 0.1, 0.1));
        ASSERT_EQ(robot.estimate().status, Status::ok);
        journey.camera = false;
        journey.left_spin_m_s = spin.left_m_s;
        journey.right_spin_m_s = spin.right_m_s;
        robot.add(journey.go(kUnnoticed_s, 0.1, 0.1));
        expect_honest(robot, journey, 3, 0.1, 0.1);
        journey.left_spin_m_s = journey.right_spin_m_s = 0;
        journey.camera = true;
        robot.add(journey.go(kFirstFrames_s, 0.1, 0.1));
        expect_honest(robot, journey, 15, 0.1, 0.1);
        EXPECT_EQ(robot.estimate().status, Status::ok);
        EXPECT_TRUE(same_pose(robot.pose(), journey.truth, 0.15));
    }
}

/// The wheels turn less than the gyro: it is suspected, and the wheels carry the heading.
TEST_P(SlipTest, AGyroInDegreesIsNotFollowed) {
    for (const double omega : {0.3, -0.3}) {
        Robot robot(GetParam(), params_with(HeadingSource::gyro), kAroundOrigin);
        Journey journey(kAroundOrigin);
        journey.camera = false;
        journey.gyro_scale = 180 / kPi<double>;
        robot.add(journey.go(1, 0.2, omega));
        EXPECT_EQ(robot.estimate().motion, MotionState::slipping);
        EXPECT_GT(robot.covariance()(2, 2), 0.9) << "of the first half second nothing is known";
        const double off = robot.pose()[kHeading] - journey.truth[kHeading];
        robot.add(journey.go(5, 0.2, omega));
        EXPECT_NEAR(wrap(robot.pose()[kHeading] - journey.truth[kHeading] - off), 0, 0.02)
            << "the turn of the wheels";
    }
}

TEST_P(SlipTest, AGyroOfTheWrongSignIsNotFollowed) {
    Robot robot(GetParam(), params_with(HeadingSource::gyro), kAroundOrigin);
    Journey journey(kAroundOrigin);
    journey.camera = false;
    journey.gyro_scale = -1;
    robot.add(journey.go(1, 0.2, 0.4));
    const double off = robot.pose()[kHeading] - journey.truth[kHeading];
    EXPECT_NEAR(off, -2 * 0.4 * 0.5, 0.02) << "of the first half second only";
    robot.add(journey.go(4, 0.2, 0.4));
    const Estimate e = robot.estimate();
    EXPECT_NEAR(wrap(e.pose[kHeading] - journey.truth[kHeading] - off), 0, 0.02);
    EXPECT_LT(contradiction(e.pose, e.covariance, journey.truth), kRare);
}

/// With sightings the status is OK only where the pose is right, and most of the time it is.
TEST_P(SlipTest, AWrongGyroIsSurvivedWithSightings) {
    for (const double scale : {180 / kPi<double>, -1.0}) {
        SCOPED_TRACE(scale);
        Robot robot(GetParam(), params_with(HeadingSource::gyro), kAroundOrigin);
        Journey journey(kAroundOrigin);
        robot.add(journey.go(2, 0.2, 0));
        journey.gyro_scale = scale;
        robot.add(journey.go(kUnnoticed_s, 0.2, 0.3));
        expect_honest(robot, journey, 40, 0.2, 0.3);
        EXPECT_TRUE(same_pose(robot.pose(), journey.truth, 0.3));
    }
}

/// A gyro that says nothing but zero looks like wheels that slip.
TEST_P(SlipTest, AGyroStuckAtZeroIsPulledAlongBySightings) {
    Robot robot(GetParam(), params_with(HeadingSource::gyro), kAroundOrigin);
    Journey journey(kAroundOrigin);
    robot.add(journey.go(2, 0.2, 0));
    journey.gyro_scale = 0;
    for (int i = 0; i < 400; ++i) {
        robot.add(journey.go(0.1, 0.2, 0.3));
        if (robot.estimate().status != Status::ok) continue;
        ASSERT_TRUE(same_pose(robot.pose(), journey.truth, 0.3)) << "step " << i;
    }
}

/// Skid steering turns a robot less than its wheels, always; that is no slip.
TEST_P(SlipTest, TenPercentOfScaleIsNone) {
    Params params = params_with(HeadingSource::gyro);
    params.wheels.track_width_m = 0.45;
    Robot robot(GetParam(), params, kAroundOrigin);
    Journey journey(kAroundOrigin);
    journey.camera = false;
    for (int i = 0; i < 100; ++i) {
        robot.add(journey.go(0.1, 0.3, 0.8));
        ASSERT_EQ(robot.estimate().motion, MotionState::driving);
    }
}

}  // namespace
}  // namespace pilotage::test
