// Covariances through the localizer: independent of the sample rate, and with everything that is
// configured.

#include "support/localizers.hpp"
#include "support/robots.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_LOCALIZER_SUITE(NoiseTest);

const MarkerMap kGroundMarker({{1, 6, 2, 0, 0}});

Params noisy_params(HeadingSource heading) {
    Params params = params_with(heading);
    params.noise = {0.03, 0.01, 0.02, 0.01, 0.005, 0.01, 0.004};
    params.gyro_bias = {0, 0.01, 0.002};
    params.distance_scale = {1, 0.02, 0.01};
    params.rotation_scale = {1, 0.02, 0.01};
    return params;
}

/// A drive of ten seconds along an S, sampled `rate` times a second.
Eigen::MatrixXd covariance_after(const LocalizerKind& kind, HeadingSource heading, int rate) {
    Params params = noisy_params(heading);
    params.wheels.left_m_per_tick = params.wheels.right_m_per_tick = 1e-6;
    Robot robot(kind, params, kGroundMarker);
    for (int i = 0; i <= 10 * rate; ++i) {
        const double t = double(i) / rate;
        const double travel = 0.5 * t, lean = 0.1 * (1 - std::cos(0.6 * t));
        const auto utime = static_cast<std::int64_t>(i) * kSecond / rate;
        robot.add(gyro_at(utime, 2 * 0.1 * 0.6 * std::sin(0.6 * t) / 0.5));
        robot.add(encoders_at(utime, std::llround((travel - lean) * 1e6),
                              std::llround((travel + lean) * 1e6)));
    }
    return robot.covariance();
}

TEST_P(NoiseTest, DoesNotDependOnTheSampleRate) {
    for (const HeadingSource heading :
         {HeadingSource::wheels, HeadingSource::gyro, HeadingSource::both}) {
        const Eigen::MatrixXd fifty = covariance_after(GetParam(), heading, 50);
        for (const int rate : {100, 200}) {
            const Eigen::MatrixXd faster = covariance_after(GetParam(), heading, rate);
            for (int i = 0; i < fifty.rows(); ++i)
                for (int j = 0; j < fifty.cols(); ++j) {
                    const double scale = std::sqrt(fifty(i, i) * fifty(j, j));
                    EXPECT_NEAR(faster(i, j), fifty(i, j), 0.01 * scale)
                        << rate << " Hz, entry " << i << ", " << j;
                }
        }
    }
}

TEST_P(NoiseTest, GrowsWithTimeUntilTheRobotIsSeenToStand) {
    Robot standing(GetParam(), noisy_params(HeadingSource::wheels), kGroundMarker);
    standing.add(drive(100, 0, 0));
    const double heading = standing.estimate().covariance(2, 2);
    const double start = std::pow(plain_params().initial.sigma_heading_rad, 2);
    const double moving_s = 0.5;  // the first window
    EXPECT_NEAR(heading, start + 0.004 * 0.004 * moving_s, 1e-7) << "only with time";
    EXPECT_NEAR(standing.estimate().covariance(0, 0), 0.01 + 0.01 * 0.01 * moving_s, 1e-6);
}

/// With a certain pose S is R.
SightingReport report_of(const LocalizerKind& kind, const SensorParams& sensor, double survey_sigma,
                         const Vector<double, 3>& measured) {
    Params params = plain_params();
    params.initial.sigma_position_m = params.initial.sigma_heading_rad = 0;
    params.sensors[0] = sensor;
    Robot robot(kind, params, MarkerMap({{1, 6, 2, 0, survey_sigma}}));
    robot.add(encoders_at(0, 0, 0));
    robot.add(sighting_at(1, 1, measured));
    robot.add(encoders_at(kPeriod, 0, 0));
    return robot.tally.reports.at(0);
}

TEST_P(NoiseTest, OfASightingIsTheSensorsWhereItStatesNone) {
    SensorParams sensor;
    sensor.sigma_bearing_rad = 0.03;
    sensor.sigma_elevation_rad = 0.04;
    sensor.sigma_range_m = 0.5;
    const SightingReport report = report_of(GetParam(), sensor, 0, {0.3, 0, 6});
    EXPECT_NEAR(report.sigma[0], 0.03, 1e-6);
    EXPECT_NEAR(report.sigma[1], 0.04, 1e-6);
    EXPECT_NEAR(report.sigma[2], 0.5, 1e-6);
    EXPECT_EQ(report.dof, 3);
}

TEST_P(NoiseTest, OfARangeGrowsWithTheRange) {
    SensorParams sensor;
    sensor.sigma_range_m = 0.3;
    sensor.sigma_range_per_m = 0.1;
    const SightingReport report = report_of(GetParam(), sensor, 0, {kNan, kNan, 6});
    EXPECT_NEAR(report.sigma[2], std::sqrt(0.09 + 0.01 * 40), 1e-6) << "sqrt(40) m away";
    EXPECT_EQ(report_of(GetParam(), sensor, 0, {0.3, kNan, kNan}).sigma[0],
              report_of(GetParam(), {}, 0, {0.3, kNan, kNan}).sigma[0]);
}

TEST_P(NoiseTest, OfTheSurveyEntersBearingAndRange) {
    SensorParams sensor;
    sensor.sigma_bearing_rad = 0.03;
    sensor.sigma_range_m = 0.4;
    const SightingReport report = report_of(GetParam(), sensor, 0.3, {0.3, kNan, 6});
    EXPECT_NEAR(report.sigma[0], std::hypot(0.03, 0.3 / std::sqrt(40)), 1e-6);
    EXPECT_NEAR(report.sigma[2], std::hypot(0.4, 0.3), 1e-6);
}

TEST_P(NoiseTest, OfTheSightingItselfComesFirst) {
    Params params = plain_params();
    params.initial.sigma_position_m = params.initial.sigma_heading_rad = 0;
    Robot robot(GetParam(), params, kGroundMarker);
    robot.add(encoders_at(0, 0, 0));
    Sample seen = sighting_at(1, 1, {0.3, 0.01, 6});
    seen.payload.sighting.sigma[0] = 0.25;
    seen.payload.sighting.sigma[2] = 0.75;
    robot.add(seen);
    robot.add(encoders_at(kPeriod, 0, 0));
    const SightingReport& report = robot.tally.reports.at(0);
    EXPECT_NEAR(report.sigma[0], 0.25, 1e-6);
    EXPECT_NEAR(report.sigma[1], params.sensors[0].sigma_elevation_rad, 1e-6) << "as configured";
    EXPECT_NEAR(report.sigma[2], 0.75, 1e-6);
}

TEST_P(NoiseTest, ARangeIsScaledAndOffset) {
    SensorParams sensor;
    sensor.range_scale = 1.07;
    sensor.range_offset_m = 0.12;
    const double reported = 1.07 * std::sqrt(40) + 0.12;
    const SightingReport report = report_of(GetParam(), sensor, 0, {kNan, kNan, reported + 0.2});
    EXPECT_NEAR(report.innovation[2], 0.2, 1e-5);
}

}  // namespace
}  // namespace pilotage::test
