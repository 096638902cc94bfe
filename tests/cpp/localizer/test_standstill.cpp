// A robot that stands: its heading stays, whatever the gyro says, and its bias is learned.

#include <algorithm>
#include <random>

#include "support/journeys.hpp"
#include "support/localizers.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_LOCALIZER_SUITE(StandstillTest);

constexpr double kBias_rad_s = 0.004;  // rad/s: 14 degrees a minute
constexpr double kTick_rad = 0.002;

Journey without_camera() {
    Journey journey(kAroundOrigin);
    journey.camera = false;
    return journey;
}

TEST_P(StandstillTest, NeitherHeadingNorItsVarianceDriftWithABiasedGyro) {
    Params params = gyro_params();
    params.gyro_bias.sigma = GetParam().states == kCalibratedStates ? 0.01 : 0;
    params.noise.position_m_per_sqrt_s = params.noise.heading_rad_per_sqrt_s = 0.01;
    Robot robot(GetParam(), params, kAroundOrigin);
    Journey journey = without_camera();
    journey.gyro_bias = kBias_rad_s;
    robot.add(journey.go(2));
    EXPECT_EQ(robot.estimate().motion, MotionState::standing);
    const Estimate before = robot.estimate();
    EXPECT_NEAR(before.pose[kHeading], 0, 0.55 * kBias_rad_s)
        << "only the first window is believed";
    robot.add(journey.go(120));
    const Estimate after = robot.estimate();
    EXPECT_NEAR(after.pose[kHeading], 0, std::abs(before.pose[kHeading]) + 1e-6);
    EXPECT_LE(after.covariance(2, 2), before.covariance(2, 2) * (1 + 1e-5));
    EXPECT_LE(after.covariance(0, 0), before.covariance(0, 0) * (1 + 1e-5));
    EXPECT_EQ(after.omega_rad_s, 0);
    EXPECT_EQ(after.v_m_s, 0);
}

TEST_P(StandstillTest, TeachesTheGyrosBias) {
    if (GetParam().states == kPoseStates) return;
    Params params = gyro_params();
    params.gyro_bias.sigma = 0.01;
    Robot robot(GetParam(), params, kAroundOrigin);
    Journey journey = without_camera();
    journey.gyro_bias = kBias_rad_s;
    robot.add(journey.go(30));
    const double sigma = std::sqrt(robot.covariance()(kGyroBias, kGyroBias));
    EXPECT_NEAR(robot.state()[kGyroBias], kBias_rad_s, 1e-4);
    EXPECT_NEAR(sigma, 0.002 / std::sqrt(29), 1e-4) << "the gyro's noise over the time it stood";
    const double start = robot.pose()[kHeading];
    robot.add(journey.go(60, 0.5, 0.1));
    EXPECT_NEAR(wrap(robot.pose()[kHeading] - start - 6), 0, 0.01) << "and it serves the drive";
}

/// A frozen bias is not touched.
TEST_P(StandstillTest, TeachesNothingWhereTheBiasIsFrozen) {
    if (GetParam().states == kPoseStates) return;
    Params params = gyro_params();
    params.distance_scale.sigma = 0.01;
    Robot robot(GetParam(), params, kAroundOrigin);
    Journey journey = without_camera();
    journey.gyro_bias = kBias_rad_s;
    robot.add(journey.go(10));
    EXPECT_EQ(robot.estimate().motion, MotionState::standing);
    EXPECT_EQ(robot.state()[kGyroBias], 0);
}

/// Creeps and turns so slowly that its wheels tick now and then.
double heading_lost(const LocalizerKind& kind, double tick_every_s, double seconds) {
    Params params = gyro_params();
    Robot robot(kind, params, kAroundOrigin);
    Journey journey = without_camera();
    const double omega = 2 * kTick_rad / tick_every_s;  // both wheels, against each other
    robot.add(journey.go(2));
    robot.add(journey.go(seconds, 0, omega));
    return std::abs(wrap(robot.pose()[kHeading] - journey.truth[kHeading]));
}

TEST_P(StandstillTest, SlowCreepingLosesNoHeadingBeyondATick) {
    EXPECT_LE(heading_lost(GetParam(), 0.3, 120), kTick_rad);
    EXPECT_LE(heading_lost(GetParam(), 0.6, 120), kTick_rad);
    EXPECT_LE(heading_lost(GetParam(), 2, 120), kTick_rad);
}

/// Stands, creeps, turns on the spot, stands.
std::vector<Sample> stop_and_go(Journey& journey) {
    std::vector<Sample> samples = journey.go(2);
    const auto then = [&](double seconds, double v, double omega) {
        const std::vector<Sample> more = journey.go(seconds, v, omega);
        samples.insert(samples.end(), more.begin(), more.end());
    };
    then(1.5, 0.002, 0.002);
    then(1, 0, 0.5);
    then(1.7, 0, 0);
    then(0.5, 0.3, -0.2);
    then(1.3, 0, 0);
    return samples;
}

TEST_P(StandstillTest, IsDecidedAnewByLateSamples) {
    Params params = gyro_params();
    params.gyro_bias.sigma = 0.01;
    params.history.window_s = 20;
    Journey journey(kAroundOrigin);
    journey.gyro_bias = kBias_rad_s;
    std::vector<Sample> samples = stop_and_go(journey);
    Robot in_order(GetParam(), params, kAroundOrigin);
    in_order.add(samples);
    EXPECT_EQ(in_order.estimate().motion, MotionState::standing);
    std::mt19937 generator(3);
    for (int trial = 0; trial < 3; ++trial) {
        std::shuffle(samples.begin(), samples.end(), generator);
        Robot robot(GetParam(), params, kAroundOrigin);
        robot.add(samples);
        const double tolerance = GetParam().is_double ? 1e-12 : 1e-5;
        EXPECT_TRUE(close(robot.state(), in_order.state(), tolerance));
        EXPECT_TRUE(close(robot.covariance(), in_order.covariance(), tolerance));
        EXPECT_EQ(robot.estimate().motion, in_order.estimate().motion);
        EXPECT_EQ(robot.estimate().status, in_order.estimate().status);
    }
}

TEST_P(StandstillTest, EndsInThePastWhenALateTickComes) {
    Params params = gyro_params();
    params.history.window_s = 5;
    Journey journey = without_camera();
    const std::vector<Sample> standing = journey.go(3);
    const std::int64_t tick_at = 2 * kSecond + kPeriod / 2;
    Robot robot(GetParam(), params, kAroundOrigin);
    robot.add(standing);
    EXPECT_EQ(robot.estimate().motion, MotionState::standing);
    robot.add(encoders_at(tick_at, 1, 1));  // there and back
    robot.add(encoders_at(3 * kSecond + kPeriod, 0, 0));
    EXPECT_EQ(robot.estimate().motion, MotionState::standing) << "its window is over";
    robot.add(encoders_at(3 * kSecond - 10 * kPeriod + 1, 1, 1));
    EXPECT_EQ(robot.estimate().motion, MotionState::driving);
}

TEST_P(StandstillTest, ANewDriveBeginsWithItsFirstStep) {
    Robot robot(GetParam(), gyro_params(), kAroundOrigin);
    Journey journey = without_camera();
    robot.add(journey.go(3));
    robot.add(journey.go(1, 0.5, 0.8));
    EXPECT_EQ(robot.estimate().motion, MotionState::driving);
    EXPECT_TRUE(same_pose(robot.pose(), journey.truth, 2e-3)) << "nothing is lost at the start";
    EXPECT_NEAR(robot.estimate().omega_rad_s, 0.8, 1e-5);
}

}  // namespace
}  // namespace pilotage::test
