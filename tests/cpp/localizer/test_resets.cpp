// A pose given from outside: as the start, and under way.

#include "support/localizers.hpp"
#include "support/robots.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_LOCALIZER_SUITE(ResetTest);

const MarkerMap kOneMarker({{1, 6, 2, 0.4, 0}});

Params params_without_start() {
    Params params = plain_params();
    params.initial = {};
    params.distance_scale.initial = 1.5;
    params.rotation_scale.sigma = 0.1;
    return params;
}

TEST_P(ResetTest, IsTheStartWhereNoneIsConfigured) {
    Robot robot(GetParam(), params_without_start(), kOneMarker);
    EXPECT_FALSE(robot.has_pose());
    const Sample start = reset_at(5, {1, 2, 0.5}, {0.3, 0.4, 0.1});
    EXPECT_FALSE(robot.add(start));
    EXPECT_TRUE(robot.has_pose());
    EXPECT_FALSE(robot.started());
    EXPECT_EQ(robot.tally.of(start), Verdict::fused);
    EXPECT_TRUE(robot.add(encoders_at(kSecond, 0, 0)));
    EXPECT_TRUE(robot.started());
    const Estimate e = robot.estimate();
    EXPECT_TRUE(same_pose(e.pose, Pose<double>(1, 2, 0.5), 1e-6));
    EXPECT_TRUE(
        close(e.covariance, Pose<double>(0.09, 0.16, 0.01).asDiagonal().toDenseMatrix(), 1e-7));
    EXPECT_EQ(e.resets, 0) << "a start is no jump";
    EXPECT_EQ(e.status, Status::initializing);
}

TEST_P(ResetTest, StartsWithTheConfiguredCalibration) {
    Robot robot(GetParam(), params_without_start(), kOneMarker);
    robot.add(reset_at(0, {0, 0, 0}, {0.1, 0.1, 0.1}));
    robot.add(encoders_at(0, 0, 0));
    robot.add(encoders_at(kSecond, 1000, 1000));
    EXPECT_NEAR(robot.pose()[kX], 1.5, 1e-6);
    if (GetParam().states == kCalibratedStates) {
        EXPECT_NEAR(robot.state()[kDistanceScale], 1.5, 1e-7);
        EXPECT_NEAR(robot.covariance()(kRotationScale, kRotationScale), 0.01, 1e-9);
    }
}

TEST_P(ResetTest, WrapsTheHeading) {
    Robot robot(GetParam(), params_without_start(), kOneMarker);
    robot.add(reset_at(0, {0, 0, 7}, {0.1, 0.1, 0.1}));
    robot.add(encoders_at(0, 0, 0));
    EXPECT_NEAR(robot.pose()[kHeading], 7 - 2 * kPi<double>, 1e-6);
    robot.add(reset_at(1, {0, 0, -3 * kPi<double>}, {0.1, 0.1, 0.1}));
    robot.add(encoders_at(kPeriod, 0, 0));
    EXPECT_LE(std::abs(robot.pose()[kHeading]), kPi<double> + 1e-6);
    EXPECT_NEAR(std::abs(robot.pose()[kHeading]), kPi<double>, 1e-5);
}

TEST_P(ResetTest, UnderWayTakesEffectAtItsOwnTimeAndIsCounted) {
    Params params = plain_params();
    params.noise.wheel_m_per_sqrt_m = params.noise.position_m_per_sqrt_m = 0;
    params.motion.max_gap_s = 1;
    Robot robot(GetParam(), params, kOneMarker);
    robot.add(encoders_at(0, 0, 0));
    const Sample to = reset_at(750'000, {10, 20, kPi<double> / 2}, {0.5, 0.6, 0});
    robot.add(to);
    EXPECT_EQ(robot.tally.of(to), Verdict::pending);
    robot.add(encoders_at(kSecond, 1000, 1000));
    EXPECT_EQ(robot.tally.of(to), Verdict::fused);
    const Estimate e = robot.estimate();
    EXPECT_TRUE(same_pose(e.pose, Pose<double>(10, 20.25, kPi<double> / 2), 1e-5));
    EXPECT_TRUE(
        close(e.covariance, Pose<double>(0.25, 0.36, 0).asDiagonal().toDenseMatrix(), 1e-6));
    EXPECT_EQ(e.resets, 1);
}

TEST_P(ResetTest, KeepsTheCalibrationButNotWhatTiedItToThePose) {
    if (GetParam().states == kPoseStates) return;
    Params params = plain_params();
    params.distance_scale.sigma = 0.1;
    Robot robot(GetParam(), params, kOneMarker);
    robot.add(drive(100, 10, 10));
    EXPECT_GT(std::abs(robot.covariance()(kX, kDistanceScale)), 1e-3);
    robot.add(reset_at(100 * kPeriod + 1, {0, 0, 0}, {0.1, 0.1, 0.1}));
    robot.add(encoders_at(101 * kPeriod, 1000, 1000));
    EXPECT_NEAR(robot.covariance()(kX, kDistanceScale), 0, 1e-9);
    EXPECT_NEAR(robot.covariance()(kDistanceScale, kDistanceScale), 0.01, 1e-6);
}

TEST_P(ResetTest, UnderWayAsksForANewConfirmation) {
    Robot robot(GetParam(), plain_params(), kOneMarker);
    robot.add(encoders_at(0, 0, 0));
    for (int i = 1; i <= Agreement::kConfirming; ++i)
        robot.add(sighting_at(i, 1, view({0, 0, 0}, kOneMarker.markers()[0])));
    robot.add(encoders_at(kPeriod, 0, 0));
    EXPECT_EQ(robot.estimate().status, Status::ok);
    robot.add(reset_at(kPeriod + 1, {1, 0, 0}, {0.1, 0.1, 0.1}));
    robot.add(encoders_at(2 * kPeriod, 0, 0));
    EXPECT_EQ(robot.estimate().status, Status::initializing);
    for (int i = 1; i <= Agreement::kConfirming; ++i)
        robot.add(sighting_at(2 * kPeriod + i, 1, view({1, 0, 0}, kOneMarker.markers()[0])));
    robot.add(encoders_at(3 * kPeriod, 0, 0));
    EXPECT_EQ(robot.estimate().status, Status::ok);
}

TEST_P(ResetTest, NeedsFinitePlausibleNumbersAndACovariance) {
    const Sample good = reset_at(kPeriod + 1, {1, 2, 3}, {0.1, 0.1, 0.1});
    const auto with = [&](auto change) {
        Sample sample = good;
        change(sample.payload.reset);
        return sample;
    };
    struct Case {
        Sample sample;
        Verdict verdict;
    };
    std::vector<Case> cases;
    for (const double bad : {kNan, kInf, -kInf}) {
        for (int i = 0; i < 3; ++i)
            cases.push_back({with([&](PoseReset& r) { r.pose[i] = bad; }), Verdict::bad_value});
        for (int i = 0; i < 6; ++i)
            cases.push_back(
                {with([&](PoseReset& r) { r.covariance[i] = bad; }), Verdict::bad_value});
    }
    for (const int diagonal : {0, 2, 5})
        cases.push_back(
            {with([&](PoseReset& r) { r.covariance[diagonal] = -1e-6; }), Verdict::bad_value});
    for (const int beside : {1, 3, 4})
        cases.push_back(
            {with([&](PoseReset& r) { r.covariance[beside] = 0.011; }), Verdict::bad_value});
    cases.push_back({with([](PoseReset& r) {
                         for (const int zero : {0, 2, 5}) r.covariance[zero] = 0;
                         r.covariance[4] = -1e7;
                     }),
                     Verdict::bad_value});
    for (const double huge : {1.1e7, 1e154, 1e308})
        for (int i = 0; i < 3; ++i)
            cases.push_back({with([&](PoseReset& r) { r.pose[i] = -huge; }), Verdict::implausible});
    for (const double huge : {1.1e9, 1e154, 1e308})
        for (const int diagonal : {0, 2, 5})
            cases.push_back(
                {with([&](PoseReset& r) { r.covariance[diagonal] = huge; }), Verdict::implausible});
    for (const Case& c : cases) {
        Robot robot(GetParam(), plain_params(), kOneMarker);
        robot.add(drive(1, 0, 0));
        robot.add(c.sample);
        robot.add(encoders_at(2 * kPeriod, 0, 0));
        EXPECT_EQ(robot.tally.of(c.sample), c.verdict) << name(robot.tally.of(c.sample));
        EXPECT_TRUE(same_pose(robot.pose(), Pose<double>(0, 0, 0), 1e-7));
        EXPECT_EQ(robot.estimate().resets, 0);
    }
}

/// As far and as unsure as a reset may be, the drive after it stays finite.
TEST_P(ResetTest, AtItsLimitsLeavesAFiniteFilter) {
    Robot robot(GetParam(), plain_params(), kOneMarker);
    robot.add(drive(1, 0, 0));
    const Sample far = reset_at(kPeriod + 1, {1e7, -1e7, 1e7}, {3e4, 3e4, 10});
    robot.add(far);
    for (int i = 2; i < 500; ++i) {
        robot.add(sighting_at(i * kPeriod - 1, 1, {0.1, 0.1, 5}));
        robot.add(encoders_at(i * kPeriod, 100 * i, 150 * i));
        ASSERT_TRUE(robot.state().allFinite() && robot.covariance().allFinite()) << "step " << i;
        if (!GetParam().is_double) continue;  // 1e9 m^2 leave rounding of 100 m^2
        ASSERT_GE(robot.covariance().diagonal().minCoeff(), 0) << "step " << i;
    }
    EXPECT_EQ(robot.tally.of(far), Verdict::fused);
}

}  // namespace
}  // namespace pilotage::test
