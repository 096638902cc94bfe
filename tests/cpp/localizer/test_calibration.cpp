// Calibration states: found where they may move, exactly as configured where they are frozen.

#include "support/localizers.hpp"
#include "support/random.hpp"
#include "support/robots.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_LOCALIZER_SUITE(CalibrationTest);

const MarkerMap kGroundMarkers(
    {{1, 6, 2, 0, 0}, {2, -3, 5, 0, 0}, {3, 4, -4, 0, 0}, {4, -6, -5, 0, 0}});

constexpr double kTrueBias = 0.03, kTrueDistance = 1.04, kTrueRotation = 0.97;

/// Drives a minute in slow eights on wheels and a gyro that err, with good sightings.
void drive_erring(Robot& robot) {
    Draw draw(3);
    Pose<double> truth(0, 0, 0);
    std::int64_t left = 0, right = 0;
    for (int i = 0; i <= 3000; ++i) {
        const double distance = 0.01, turn = (i / 750) % 2 ? -0.008 : 0.008;
        if (i > 0) {
            truth = after_arc(truth, distance, turn);
            truth[kHeading] = wrap(truth[kHeading]);
            const double lean = turn * plain_params().wheels.track_width_m / 2;
            left += std::llround(1e6 * (distance - lean));
            right += std::llround(1e6 * (distance + lean));
        }
        robot.add(gyro_at(i * kPeriod, turn / kTrueRotation / 0.02 + kTrueBias));
        robot.add(encoders_at(i * kPeriod, left, right));
        if (i % 5) continue;
        for (const Marker& marker : kGroundMarkers.markers()) {
            Vector<double, 3> seen = view(truth, marker);
            seen += Vector<double, 3>(0.005, 0, 0.02).cwiseProduct(draw.normal<double, 3>());
            robot.add(sighting_at(i * kPeriod, marker.id, only(seen, true, false, true)));
        }
    }
}

Params erring_params() {
    Params params = plain_params();
    params.motion.heading = HeadingSource::gyro;
    params.wheels.left_m_per_tick = params.wheels.right_m_per_tick = 1e-6 / kTrueDistance;
    params.sensors[0].sigma_bearing_rad = 0.005;
    params.sensors[0].sigma_range_m = 0.02;
    params.sensors[0].fusion = Fusion::plain;
    return params;
}

TEST_P(CalibrationTest, FindsBiasAndScales) {
    if (GetParam().states == kPoseStates) return;
    Params params = erring_params();
    params.gyro_bias = {0, 0.05, 0};
    params.distance_scale = {1, 0.05, 0};
    params.rotation_scale = {1, 0.05, 0};
    Robot robot(GetParam(), params, kGroundMarkers);
    drive_erring(robot);
    const Eigen::VectorXd x = robot.state();
    const Eigen::MatrixXd p = robot.covariance();
    const double truth[] = {kTrueBias, kTrueDistance, kTrueRotation};
    for (int i = 0; i < 3; ++i) {
        const double sigma = std::sqrt(p(kGyroBias + i, kGyroBias + i));
        EXPECT_NEAR(x[kGyroBias + i], truth[i], 4 * sigma) << "state " << i;
        EXPECT_LT(sigma, 0.01) << "state " << i;
    }
}

/// One of them at a time: the others stay as they are, to the last bit, and have no variance.
TEST_P(CalibrationTest, MovesOnlyWhatIsNotFrozen) {
    if (GetParam().states == kPoseStates) return;
    for (int moving = 0; moving < 3; ++moving) {
        Params params = erring_params();
        CalibrationParams* states[] = {&params.gyro_bias, &params.distance_scale,
                                       &params.rotation_scale};
        const double initial[] = {0.0123, 1.0271, 0.9871};
        for (int i = 0; i < 3; ++i) states[i]->initial = initial[i];
        states[moving]->sigma = 0.05;
        Robot robot(GetParam(), params, kGroundMarkers);
        drive_erring(robot);
        for (int i = 0; i < 3; ++i) {
            const int at = kGyroBias + i;
            const double frozen = GetParam().is_double ? initial[i] : double(float(initial[i]));
            if (i == moving) {
                EXPECT_NE(robot.state()[at], frozen);
                continue;
            }
            EXPECT_EQ(robot.state()[at], frozen) << "state " << i << " beside " << moving;
            EXPECT_TRUE((robot.covariance().row(at).array() == 0).all());
        }
    }
}

/// All frozen, six states are three: the same pose, at the configured calibration.
TEST_P(CalibrationTest, AllFrozenIsTheThreeStateFilter) {
    Params params = erring_params();
    params.gyro_bias.initial = kTrueBias;
    params.distance_scale.initial = kTrueDistance;
    params.rotation_scale.initial = kTrueRotation;
    Robot robot(GetParam(), params, kGroundMarkers);
    Robot three({GetParam().is_double, kPoseStates, 0}, params, kGroundMarkers);
    drive_erring(robot);
    drive_erring(three);
    const double tolerance = GetParam().is_double ? 1e-9 : 1e-3;
    EXPECT_TRUE(same_pose(robot.pose(), three.pose(), tolerance));
    EXPECT_TRUE(close(robot.estimate().covariance, three.estimate().covariance, tolerance));
    EXPECT_NEAR(robot.estimate().v_m_s, three.estimate().v_m_s, tolerance);
    EXPECT_NEAR(robot.estimate().v_m_s, 0.5, 1e-3) << "true, not measured";
}

TEST_P(CalibrationTest, AWalkLetsAStateMoveFromACertainStart) {
    if (GetParam().states == kPoseStates) return;
    Params params = erring_params();
    params.gyro_bias.walk = 0.01;
    params.distance_scale.initial = kTrueDistance;
    params.rotation_scale.initial = kTrueRotation;
    Robot robot(GetParam(), params, kGroundMarkers);
    drive_erring(robot);
    EXPECT_NEAR(robot.state()[kGyroBias], kTrueBias, 0.02);
}

}  // namespace
}  // namespace pilotage::test
