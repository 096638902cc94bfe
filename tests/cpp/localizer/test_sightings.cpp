// Sightings through the localizer: fused at their own time, with the noise that is configured.

#include "support/localizers.hpp"
#include "support/random.hpp"
#include "support/robots.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_LOCALIZER_SUITE(SightingTest);

const MarkerMap kThreeMarkers({{1, 6, 2, 0.4, 0}, {2, -3, 5, 0, 0}, {3, 4, -4, 0, 0}});

/// A camera off the middle, and every kind of noise.
Params camera_params() {
    Params params = plain_params();
    params.initial.sigma_position_m = 0.2;
    params.motion.max_gap_s = 1;
    SensorParams& camera = params.sensors[0];
    camera.x_m = 0.3;
    camera.y_m = -0.1;
    camera.z_m = 0.9;
    camera.yaw_rad = 0.2;
    camera.fusion = Fusion::plain;
    return params;
}

/// The same two half steps and one update by hand, with the filter and the models alone.
template <typename Scalar, int N>
void expect_hand_made(const LocalizerKind& kind, std::int64_t seen_at) {
    const Params params = camera_params();
    const SensorParams& camera = params.sensors[0];
    auto u = from_wheels(Scalar(0.2), Scalar(0.3), Scalar(1), Scalar(0.5), params.noise);
    u.process_noise = pose_process_noise(u, params.noise);
    const auto fraction = Scalar(static_cast<double>(seen_at) / kSecond);
    const Vector<double, 3> z(0.1, -0.12, 6.2);

    const Pose<Scalar> variances(Scalar(0.04), Scalar(0.04),
                                 Scalar(std::pow(params.initial.sigma_heading_rad, 2)));
    auto filter = start_filter<Scalar, N>({0, 0, 0}, variances.asDiagonal(), params);
    dead_reckon(filter, u.part(fraction), params);
    using Model = MarkerSighting<Scalar, Bearing<Scalar>, Elevation<Scalar>, Range<Scalar>>;
    const Mounted<Model, Scalar> model{
        Model{{Scalar(6), Scalar(2), Scalar(0.4 - 0.9)}},
        {Scalar(camera.x_m), Scalar(camera.y_m), Scalar(camera.yaw_rad)}};
    const Pose<Scalar> sigma(Scalar(camera.sigma_bearing_rad), Scalar(camera.sigma_elevation_rad),
                             Scalar(camera.sigma_range_m));
    const Matrix<Scalar, 3> r = sigma.cwiseAbs2().asDiagonal();
    const auto update =
        filter.update(model, Vector<Scalar, 3>(z.template cast<Scalar>()), r, Policy{});
    ASSERT_TRUE(update.accepted());
    dead_reckon(filter, u.part(1 - fraction), params);

    Robot robot(kind, params, kThreeMarkers);
    robot.add(encoders_at(0, 0, 0));
    robot.add(sighting_at(seen_at, 1, z));
    robot.add(encoders_at(kSecond, 200, 300));
    const double tolerance = kind.is_double ? 1e-12 : 1e-5;
    EXPECT_TRUE(close(robot.state(), filter.state(), tolerance));
    EXPECT_TRUE(close(robot.covariance(), filter.covariance(), tolerance));
    ASSERT_EQ(robot.tally.reports.size(), 1U);
    const SightingReport& report = robot.tally.reports[0];
    EXPECT_EQ(report.verdict, Verdict::fused);
    EXPECT_NEAR(report.nis, double(update.nis), 1e-3 * double(update.nis));
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(report.innovation[i], double(update.innovation[i]), tolerance * 10);
        EXPECT_NEAR(report.sigma[i], std::sqrt(double(update.s(i, i))), tolerance * 10);
    }
}

TEST_P(SightingTest, BetweenTwoMotionSamplesIsFusedAtItsOwnTime) {
    for (const std::int64_t t : {1, 250'000, 500'000, 999'999}) {
        SCOPED_TRACE(t);
        const LocalizerKind kind = GetParam();
        if (kind.is_double)
            kind.states == 3 ? expect_hand_made<double, 3>(kind, t)
                             : expect_hand_made<double, 6>(kind, t);
        else
            kind.states == 3 ? expect_hand_made<float, 3>(kind, t)
                             : expect_hand_made<float, 6>(kind, t);
    }
}

/// Errors of the start vanish where every component is seen without noise; truth stays truth.
TEST_P(SightingTest, WithoutNoiseKeepTheTruth) {
    const Params params = camera_params();
    Robot robot(GetParam(), params, kThreeMarkers);
    std::vector<Sample> samples = drive(1500, 9, 11);
    for (int i = 1; i < 290; ++i) {
        const std::int64_t t = i * 100'003;
        const Pose<double> at = after_arc({0, 0, 0}, 0.5e-6 * double(t), 0.2e-6 * double(t));
        const Marker& marker = kThreeMarkers.markers()[static_cast<std::size_t>(i) % 3];
        samples.push_back(sighting_at(
            t, marker.id, only(view(at, marker, params.sensors[0]), i % 2, i % 3, i % 5)));
    }
    std::sort(samples.begin(), samples.end(), InOrder{});
    for (const Sample& sample : samples) {
        if (!robot.add(sample)) continue;
        const double t = double(sample.utime) * 1e-6;
        ASSERT_TRUE(
            same_pose(robot.pose(), after_arc({0, 0, 0}, 0.5 * t, 0.2 * t), GetParam().tolerance))
            << "after " << t << " s";
    }
    EXPECT_LT(robot.estimate().covariance(0, 0), 0.01);
    expect_sums_hold(robot);
}

TEST_P(SightingTest, AtAMotionSamplesStampSeesThePoseAtItsEnd) {
    Params params = camera_params();
    params.initial.sigma_position_m = params.initial.sigma_heading_rad = 0;
    params.noise = {};
    Robot robot(GetParam(), params, kThreeMarkers);
    robot.add(encoders_at(0, 0, 0));
    const Pose<double> end(1, 0, 0);
    robot.add(sighting_at(kSecond, 1, view(end, kThreeMarkers.markers()[0], params.sensors[0])));
    robot.add(encoders_at(kSecond, 1000, 1000));
    EXPECT_TRUE(robot.tally.reports.empty())
        << "it comes after that sample, and waits for the next";
    robot.add(encoders_at(2 * kSecond, 1000, 1000));
    ASSERT_EQ(robot.tally.reports.size(), 1U);
    for (const double innovation : robot.tally.reports[0].innovation)
        EXPECT_NEAR(innovation, 0, 1e-6);
}

TEST_P(SightingTest, WaitsForTheMotionAfterIt) {
    Robot robot(GetParam(), camera_params(), kThreeMarkers);
    const Sample seen = sighting_at(30'000, 1, {0.1, kNan, kNan});
    robot.add(encoders_at(0, 0, 0));
    EXPECT_FALSE(robot.add(seen));
    robot.add(encoders_at(20'000, 10, 10));
    EXPECT_EQ(robot.tally.of(seen), Verdict::pending);
    robot.add(encoders_at(40'000, 20, 20));
    EXPECT_EQ(robot.tally.of(seen), Verdict::fused);
    EXPECT_EQ(robot.tally.reports.size(), 1U) << "nothing is said of it while it waits";
}

TEST_P(SightingTest, ThatWaitsInVainIsToldSoAtTheEnd) {
    Robot robot(GetParam(), camera_params(), kThreeMarkers);
    robot.add(encoders_at(0, 0, 0));
    const Sample seen = sighting_at(30'000, 1, {0.1, kNan, kNan});
    robot.add(seen);
    robot.finish();
    EXPECT_EQ(robot.tally.of(seen), Verdict::no_motion);
    ASSERT_EQ(robot.tally.reports.size(), 1U);
    EXPECT_EQ(robot.tally.reports[0].verdict, Verdict::no_motion);
    robot.finish();
    EXPECT_EQ(robot.tally.reports.size(), 1U) << "and told once";
    expect_sums_hold(robot);
}

TEST_P(SightingTest, OfSeveralSensorsEachUseTheirOwnMounting) {
    Params params = camera_params();
    params.sensor_count = 2;
    params.sensors[1] = params.sensors[0];
    params.sensors[1].yaw_rad = 3;
    Robot robot(GetParam(), params, kThreeMarkers);
    robot.add(encoders_at(0, 0, 0));
    for (int source = 0; source < 2; ++source) {
        const auto s = static_cast<std::size_t>(source);
        Sample seen =
            sighting_at(10'000, 2, view({0, 0, 0}, kThreeMarkers.markers()[1], params.sensors[s]));
        seen.source = static_cast<std::uint8_t>(source);
        robot.add(seen);
    }
    robot.add(encoders_at(20'000, 0, 0));
    ASSERT_EQ(robot.tally.reports.size(), 2U);
    for (const SightingReport& report : robot.tally.reports) {
        EXPECT_EQ(report.verdict, Verdict::fused);
        EXPECT_NEAR(report.innovation[0], 0, 1e-5) << "sensor " << int(report.sensor);
        EXPECT_NEAR(report.innovation[2], 0, 1e-5) << "sensor " << int(report.sensor);
    }
}

}  // namespace
}  // namespace pilotage::test
