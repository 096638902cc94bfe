// Silence of the motion: predicted for a while, doubted after it, and carried on where ticks tell
// what was driven meanwhile.

#include "support/journeys.hpp"
#include "support/localizers.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_LOCALIZER_SUITE(GapTest);

double radius95(const Estimate& e) {
    return std::sqrt(5.9915 * std::max(e.covariance(0, 0), e.covariance(1, 1)));
}

Params velocity_params() {
    Params params = plain_params();
    params.motion.source = MotionSource::velocity;
    return params;
}

TEST_P(GapTest, APredictionGoesOnAsTheRobotDid) {
    Robot robot(GetParam(), gyro_params(), kAroundOrigin);
    Journey journey(kAroundOrigin);
    robot.add(journey.go(2, 0.5, 0.3));
    const Pose<double> at = robot.pose();
    EXPECT_EQ(robot.estimate(journey.utime).pose, at);
    EXPECT_EQ(robot.estimate(journey.utime - 100).utime, journey.utime) << "the past is no matter";
    const Estimate soon = robot.estimate(journey.utime + 300'000);
    EXPECT_EQ(soon.utime, journey.utime + 300'000);
    EXPECT_TRUE(same_pose(soon.pose, after_arc(at, 0.15, 0.09), 0.01));
    EXPECT_NEAR(soon.v_m_s, 0.5, 0.03);
    EXPECT_EQ(robot.pose(), at) << "to look ahead changes nothing";
}

TEST_P(GapTest, PastTheGapAPredictionStandsAndItsCovarianceGrows) {
    Params params = gyro_params();
    Robot robot(GetParam(), params, kAroundOrigin);
    Journey journey(kAroundOrigin);
    robot.add(journey.go(2, 0.5, 0.3));
    const auto after = [&](double seconds) {
        return robot.estimate(journey.utime + static_cast<std::int64_t>(seconds * kSecond));
    };
    const Estimate end = after(params.motion.max_gap_s), late = after(5);
    EXPECT_TRUE(same_pose(late.pose, end.pose, 1e-6)) << "nobody knows where it went";
    EXPECT_EQ(late.v_m_s, 0);
    EXPECT_EQ(late.omega_rad_s, 0);
    double before = 0;
    for (const double seconds : {0.0, 0.4, 1.0, 2.0, 4.0, 8.0, 16.0}) {
        EXPECT_GT(radius95(after(seconds)), before) << seconds << " s";
        before = radius95(after(seconds));
        // Had it gone on at its speed in any direction, it would not be farther off than that.
        EXPECT_GT(before, 0.5 * (seconds - params.motion.max_gap_s));
    }
}

TEST_P(GapTest, TheStatusFallsFromOkToDeadReckoningToLostWithItsReason) {
    Params params = gyro_params();
    params.status.lost_after_s = 4;
    params.status.lost_limit_m = 1e3;
    Robot robot(GetParam(), params, kAroundOrigin);
    Journey journey(kAroundOrigin);
    robot.add(journey.go(2));
    ASSERT_EQ(robot.estimate().status, Status::ok);
    struct Case {
        double seconds;
        Status status;
        double limit;
    };
    for (const Case& c : {Case{0.4, Status::ok, 0}, Case{0.6, Status::dead_reckoning, 0.5},
                          Case{3.9, Status::dead_reckoning, 0.5}, Case{4.1, Status::lost, 4}}) {
        SCOPED_TRACE(c.seconds);
        const Estimate e =
            robot.estimate(journey.utime + static_cast<std::int64_t>(c.seconds * kSecond));
        EXPECT_EQ(e.status, c.status);
        EXPECT_EQ(e.reason, c.status == Status::ok ? Reason::none : Reason::motion_gap);
        EXPECT_NEAR(e.value, c.status == Status::ok ? 0 : c.seconds, 2e-6);
        EXPECT_EQ(e.limit, c.limit);
    }
}

TEST_P(GapTest, TooUnsureIsLostWithItsRadius) {
    Params params = gyro_params();
    params.status.lost_after_s = 1e6;
    params.status.lost_limit_m = 3;
    Robot robot(GetParam(), params, kAroundOrigin);
    Journey journey(kAroundOrigin);
    robot.add(journey.go(2));
    const Estimate e = robot.estimate(journey.utime + 10 * kSecond);
    EXPECT_EQ(e.status, Status::lost);
    EXPECT_EQ(e.reason, Reason::unsure);
    EXPECT_NEAR(e.value, radius95(e), 0.05 * e.value);
    EXPECT_EQ(e.limit, 3);
}

/// A message or a second's messages were lost; the counters were not.
TEST_P(GapTest, TicksCarryOnAcrossAGap) {
    Robot robot(GetParam(), gyro_params(), kAroundOrigin);
    Journey journey(kAroundOrigin);
    journey.camera = false;
    robot.add(journey.go(2, 0.5, 0));
    const double sure = robot.covariance()(0, 0);
    journey.encoders = journey.gyro = false;
    EXPECT_TRUE(journey.go(3, 0.5, 0).empty());
    journey.encoders = journey.gyro = true;
    robot.add(journey.go(0.02, 0.5, 0));
    const Estimate e = robot.estimate();
    EXPECT_TRUE(same_pose(e.pose, journey.truth, 2e-3));
    EXPECT_GT(e.covariance(0, 0), sure + 0.1) << "it may have gone round a corner";
    EXPECT_EQ(robot.tally.count(Verdict::counter_reset), 0);
}

TEST_P(GapTest, AfterAGapThatTheTruthDroveCrookedItIsInsideTheCovariance) {
    for (const double omega : {0.5, -1.2}) {
        Robot robot(GetParam(), gyro_params(), kAroundOrigin);
        Journey journey(kAroundOrigin);
        journey.camera = false;
        robot.add(journey.go(2, 0.5, 0));
        journey.encoders = journey.gyro = false;
        (void)journey.go(1, 0.5, omega);
        (void)journey.go(1, 0.5, -omega);
        journey.encoders = journey.gyro = true;
        robot.add(journey.go(0.5, 0.5, 0));
        const Estimate e = robot.estimate();
        EXPECT_LT(contradiction(e.pose, e.covariance, journey.truth), kRare) << omega;
    }
}

/// Of counters that started again during the gap nothing is known but how fast the robot was.
TEST_P(GapTest, ResetCountersAcrossAGapAreDoubted) {
    Robot robot(GetParam(), gyro_params(), kAroundOrigin);
    Journey journey(kAroundOrigin);
    journey.camera = false;
    robot.add(journey.go(20, 0.9, 0));
    journey.encoders = false;
    robot.add(journey.go(1, 0.9, 0));
    journey.encoders = true;
    journey.reset_ticks();
    robot.add(journey.go(0.5, 0.9, 0));
    EXPECT_EQ(robot.tally.count(Verdict::counter_reset), 1);
    const Estimate e = robot.estimate();
    EXPECT_NEAR(journey.truth[kX] - e.pose[kX], 0.9 * 1.02, 0.05) << "what the gap swallowed";
    EXPECT_LT(contradiction(e.pose, e.covariance, journey.truth), kRare);
}

/// A speed holds no longer than the gap, and what follows is unknown.
TEST_P(GapTest, OfAVelocityCoversTheWorst) {
    Robot robot(GetParam(), velocity_params(), kAroundOrigin);
    for (int i = 0; i <= 50; ++i) robot.add(velocity_at(i * kPeriod, 0.8, 0));
    const Pose<double> before = robot.pose();
    robot.add(velocity_at(kSecond + 3 * kSecond, 0.8, 0));
    const Estimate e = robot.estimate();
    EXPECT_NEAR(e.pose[kX] - before[kX], 0.8 * 0.5, 1e-5);
    for (const double drove : {-2.4, 0.0, 2.4})
        EXPECT_LT(contradiction(e.pose, e.covariance, before + Pose<double>(drove, 0, 0)), kRare);
    robot.add(velocity_at(4 * kSecond + kPeriod, 0.8, 0));
    EXPECT_NEAR(robot.pose()[kX] - e.pose[kX], 0.8 * 0.02, 1e-5) << "and on as before";
}

/// The longest gap there is takes one step, and leaves a finite filter.
TEST_P(GapTest, OfThirtyThousandYearsIsOneStep) {
    constexpr std::int64_t far = 1'000'000'000'000 * kSecond;
    for (const MotionSource source : {MotionSource::encoders, MotionSource::velocity}) {
        Params params = gyro_params();
        params.motion.source = source;
        params.noise.position_m_per_sqrt_s = 0.01;
        Robot robot(GetParam(), params, kAroundOrigin);
        for (int i = 0; i < 50; ++i) {
            robot.add(gyro_at(i * kPeriod, 0.1));
            robot.add(source == MotionSource::encoders ? encoders_at(i * kPeriod, 10 * i, 10 * i)
                                                       : velocity_at(i * kPeriod, 0.5, 0.1));
        }
        const Estimate ahead = robot.estimate(far);
        EXPECT_TRUE(ahead.pose.allFinite() && ahead.covariance.allFinite());
        EXPECT_EQ(ahead.status, Status::initializing) << "it never was more";
        robot.add(source == MotionSource::encoders ? encoders_at(far, 500, 500)
                                                   : velocity_at(far, 0.5, 0.1));
        EXPECT_EQ(robot.estimate().utime, far);
        EXPECT_TRUE(robot.state().allFinite() && robot.covariance().allFinite());
        EXPECT_GE(robot.covariance().diagonal().minCoeff(), 0);
        EXPECT_LE(robot.tally.reports.size(), 0U);
    }
}

/// After the silence sightings tell again where the robot is.
TEST_P(GapTest, EndsWithSightings) {
    Robot robot(GetParam(), gyro_params(), kAroundOrigin);
    Journey journey(kAroundOrigin);
    robot.add(journey.go(3, 0.2, 0));
    journey.encoders = journey.gyro = journey.camera = false;
    (void)journey.go(4, 0.3, 0.3);
    journey.encoders = journey.gyro = journey.camera = true;
    for (int i = 0; i < 200; ++i) {
        robot.add(journey.go(0.1, 0.1, 0.1));
        const Estimate e = robot.estimate();
        if (e.status != Status::ok) continue;
        ASSERT_LT(contradiction(e.pose, e.covariance, journey.truth), kRare) << "step " << i;
    }
    EXPECT_EQ(robot.estimate().status, Status::ok);
    EXPECT_TRUE(same_pose(robot.pose(), journey.truth, 0.15));
}

}  // namespace
}  // namespace pilotage::test
