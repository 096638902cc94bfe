// What cannot be used is refused with its reason, changes nothing, and is counted.

#include "support/localizers.hpp"
#include "support/robots.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_LOCALIZER_SUITE(RefusalTest);

const MarkerMap kFarAndTooNear({{1, 6, 2, 0.4, 0}, {2, 0.02, 0, 0, 0}});

/// A robot under way, and a sample that it must not take.
void expect_refused(const LocalizerKind& kind, const Sample& sample, Verdict reason,
                    Params params = plain_params()) {
    Robot robot(kind, params, kFarAndTooNear), untouched(kind, params, kFarAndTooNear);
    for (Robot* r : {&robot, &untouched}) r->add(drive(3, 10, 10));
    EXPECT_FALSE(robot.add(sample));
    for (Robot* r : {&robot, &untouched}) r->add(encoders_at(4 * kPeriod, 40, 40));
    EXPECT_EQ(robot.tally.of(sample), reason) << name(robot.tally.of(sample));
    // Rounding and no more: a sighting cuts the step in which it is judged in two.
    EXPECT_TRUE(close(robot.state(), untouched.state(), kind.is_double ? 1e-12 : 1e-6));
    EXPECT_TRUE(close(robot.covariance(), untouched.covariance(), kind.is_double ? 1e-12 : 1e-6));
    EXPECT_EQ(robot.tally.reports.size(), sample.stream == Stream::sighting ? 1U : 0U);
    if (!robot.tally.reports.empty()) {
        EXPECT_EQ(robot.tally.reports[0].verdict, reason);
        EXPECT_EQ(robot.tally.reports[0].weight, 0);
    }
    expect_sums_hold(robot);
}

constexpr std::int64_t kNow = 3 * kPeriod + 1;

Sample sighting_with(int component, double value, double sigma) {
    Sample sample = sighting_at(kNow, 1, {0.3, 0.1, 6});
    sample.payload.sighting.value[component] = value;
    sample.payload.sighting.sigma[component] = sigma;
    return sample;
}

TEST_P(RefusalTest, OfASensorThatThereIsNot) {
    Sample stranger = sighting_with(0, 0.3, kNan);
    for (const std::uint8_t source : {std::uint8_t{1}, std::uint8_t{255}}) {
        stranger.source = source;
        expect_refused(GetParam(), stranger, Verdict::bad_value);
    }
}

TEST_P(RefusalTest, AnInfiniteValueIsBad) {
    for (int i = 0; i < 3; ++i)
        for (const double bad : {kInf, -kInf})
            expect_refused(GetParam(), sighting_with(i, bad, kNan), Verdict::bad_value);
}

TEST_P(RefusalTest, ARangeBeyondAnyMapIsImplausible) {
    for (const double far : {1.1e7, 1e28, -1e300})
        expect_refused(GetParam(), sighting_with(2, far, kNan), Verdict::implausible);
}

TEST_P(RefusalTest, ASigmaMustBePositiveAndFinite) {
    for (int i = 0; i < 3; ++i)
        for (const double bad : {0.0, -0.01, kInf, -kInf})
            expect_refused(GetParam(), sighting_with(i, 0.5, bad), Verdict::bad_value);
}

TEST_P(RefusalTest, ASigmaOfWhatWasNotMeasuredDoesNotMatter) {
    for (const double sigma : {0.0, -1.0, kInf}) {
        Robot robot(GetParam(), plain_params(), kFarAndTooNear);
        robot.add(drive(3, 10, 10));
        const Sample seen = sighting_with(2, kNan, sigma);
        robot.add(seen);
        robot.add(encoders_at(4 * kPeriod, 40, 40));
        EXPECT_EQ(robot.tally.of(seen), Verdict::fused);
    }
}

TEST_P(RefusalTest, ASightingOfNothingIsBad) {
    expect_refused(GetParam(), sighting_at(kNow, 1, {kNan, kNan, kNan}), Verdict::bad_value);
}

TEST_P(RefusalTest, AMarkerThatTheMapDoesNotNameIsUnknown) {
    for (const std::int32_t id : {-2, 0, 3, 2147483647})
        expect_refused(GetParam(), sighting_at(kNow, id, {0.1, kNan, kNan}),
                       Verdict::unknown_marker);
    expect_refused(GetParam(), sighting_at(kNow, kUnknownId, {0.1, kNan, kNan}), Verdict::no_match);
}

TEST_P(RefusalTest, AMarkerUnderTheSensorIsTooClose) {
    expect_refused(GetParam(), sighting_at(kNow, 2, {0.1, kNan, kNan}), Verdict::too_close);
    Robot robot(GetParam(), plain_params(), kFarAndTooNear);
    robot.add(drive(3, 10, 10));
    robot.add(sighting_at(kNow, 2, {0.1, kNan, kNan}));
    robot.add(encoders_at(4 * kPeriod, 40, 40));
    EXPECT_EQ(robot.tally.reports.at(0).limit, plain_params().sensors[0].min_distance_m);
}

TEST_P(RefusalTest, AnInnovationAboveTheGateIsRejectedWithBoth) {
    Params params = plain_params();
    params.sensors[0].fusion = Fusion::gate;
    expect_refused(GetParam(), sighting_at(kNow, 1, {3, kNan, kNan}), Verdict::gate, params);
    Robot robot(GetParam(), params, kFarAndTooNear);
    robot.add(drive(3, 10, 10));
    robot.add(sighting_at(kNow, 1, {3, kNan, kNan}));
    robot.add(encoders_at(4 * kPeriod, 40, 40));
    const SightingReport& report = robot.tally.reports.at(0);
    EXPECT_EQ(report.value, report.nis);
    EXPECT_NEAR(report.limit, 10.8276, 1e-3) << "chi-square of 1 dof at 0.999";
    EXPECT_NEAR(report.innovation[0], 3 - std::atan2(2, 6 - 0.03), 1e-3);
    EXPECT_GT(report.sigma[0], 0);
    EXPECT_TRUE(std::isnan(report.innovation[1]) && std::isnan(report.sigma[2]));
}

TEST_P(RefusalTest, AnUpdateThatWouldNotBeFiniteIsNumeric) {
    Params certain = plain_params();  // with P = 0 and a sigma whose square is zero S is zero
    certain.initial.sigma_position_m = certain.initial.sigma_heading_rad = 0;
    certain.noise.wheel_m_per_sqrt_m = certain.noise.position_m_per_sqrt_m = 0;
    expect_refused(GetParam(), sighting_with(0, 0.3, 1e-200), Verdict::numeric, certain);
}

TEST_P(RefusalTest, ARateOrSpeedMustBeFiniteAndThatOfARobot) {
    for (const double bad : {kNan, kInf, -kInf})
        expect_refused(GetParam(), gyro_at(kNow, bad), Verdict::bad_value);
    for (const double rate : {101.0, -1e9, 1e308})
        expect_refused(GetParam(), gyro_at(kNow, rate), Verdict::implausible);
}

TEST_P(RefusalTest, AVelocityMessageMustBeFiniteAndThatOfARobot) {
    Params params = plain_params();
    params.motion.source = MotionSource::velocity;
    Robot robot(GetParam(), params, kFarAndTooNear);
    robot.add(velocity_at(0, 1, 0.1));
    const double bad[][2] = {{kNan, 0}, {0, kNan}, {kInf, 0}, {0, -kInf}};
    const double fast[][2] = {{10.01, 0}, {-1e300, 0}, {0, 100.1}, {0, -1e300}};
    int i = 0;
    for (const auto& [v, omega] : bad) EXPECT_FALSE(robot.add(velocity_at(++i, v, omega)));
    for (const auto& [v, omega] : fast) EXPECT_FALSE(robot.add(velocity_at(++i, v, omega)));
    EXPECT_EQ(robot.tally.count(Verdict::bad_value), 4);
    EXPECT_EQ(robot.tally.count(Verdict::implausible), 4);
    robot.add(velocity_at(kPeriod, 1, 0));
    EXPECT_NEAR(robot.pose()[kX], 0.02, 1e-6) << "the next good one covers the time";
}

TEST_P(RefusalTest, AStampAtTheEndOfTimeIsBad) {
    constexpr std::int64_t low = std::numeric_limits<std::int64_t>::min();
    constexpr std::int64_t high = std::numeric_limits<std::int64_t>::max();
    for (const std::int64_t utime : {low, low + 1, high - 1, high, (high >> 3) + 2}) {
        expect_refused(GetParam(), encoders_at(utime, 1, 1), Verdict::bad_value);
        expect_refused(GetParam(), gyro_at(utime, 0.1), Verdict::bad_value);
        expect_refused(GetParam(), sighting_at(utime, 1, {0.1, 0.1, 6}), Verdict::bad_value);
        expect_refused(GetParam(), reset_at(utime, {0, 0, 0}, {1, 1, 1}), Verdict::bad_value);
    }
}

TEST_P(RefusalTest, WithoutAPoseNoSightingIsFused) {
    Params params = plain_params();
    params.initial.heading_rad = kNan;
    Robot robot(GetParam(), params, kFarAndTooNear);
    EXPECT_FALSE(robot.has_pose());
    robot.add(drive(3, 10, 10));
    const Sample seen = sighting_at(kNow, 1, {0.1, kNan, kNan});
    robot.add(seen);
    robot.add(encoders_at(4 * kPeriod, 40, 40));
    EXPECT_EQ(robot.tally.of(seen), Verdict::not_initialized);
    EXPECT_EQ(robot.tally.reports.at(0).verdict, Verdict::not_initialized);
    EXPECT_FALSE(robot.has_pose());
    EXPECT_FALSE(robot.started());
    EXPECT_EQ(robot.estimate().status, Status::waiting);
    EXPECT_EQ(robot.estimate().reason, Reason::no_pose);
    expect_sums_hold(robot);
}

TEST_P(RefusalTest, ASightingOlderThanTheFirstMotionHasNoPlace) {
    Robot robot(GetParam(), plain_params(), kFarAndTooNear);
    const Sample early = sighting_at(kSecond - 1, 1, {0.1, kNan, kNan});
    robot.add(early);
    robot.add(encoders_at(kSecond, 0, 0));
    EXPECT_EQ(robot.tally.of(early), Verdict::before_motion);
    robot.add(encoders_at(kSecond - 10, 0, 0));  // but an older motion sample may still come
    EXPECT_EQ(robot.tally.of(early), Verdict::fused);
    EXPECT_EQ(robot.tally.reports.size(), 2U);
    EXPECT_EQ(robot.tally.reports[1].revision, 1);
    expect_sums_hold(robot);
}

}  // namespace
}  // namespace pilotage::test
