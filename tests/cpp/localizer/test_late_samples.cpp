// The history's window and capacity: what is too late is refused and counted, what is dropped stays
// fused.

#include "support/localizers.hpp"
#include "support/robots.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_LOCALIZER_SUITE(LateSampleTest);

const MarkerMap kTwoMarkers({{1, 6, 2, 0.4, 0}, {2, -3, 5, 0, 0}});

TEST_P(LateSampleTest, OlderThanTheWindowIsRefusedWithItsAgeAndTheLimit) {
    Robot robot(GetParam(), plain_params(), kTwoMarkers);
    robot.add(drive(500, 10, 10));  // up to 10 s
    const Eigen::VectorXd before = robot.state();
    robot.add(sighting_at(8 * kSecond - 1, 1, {0.1, kNan, kNan}));
    robot.add(encoders_at(7 * kSecond, 77, 77));
    robot.add(gyro_at(6 * kSecond, 0.1));
    robot.add(reset_at(5 * kSecond, {0, 0, 0}, {1, 1, 1}));
    EXPECT_EQ(robot.tally.count(Verdict::late), 4);
    EXPECT_TRUE(close(robot.state(), before, 0));
    ASSERT_EQ(robot.tally.reports.size(), 1U);
    const SightingReport& report = robot.tally.reports[0];
    EXPECT_EQ(report.verdict, Verdict::late);
    EXPECT_NEAR(report.value, 2.000001, 1e-9);
    EXPECT_EQ(report.limit, 2);
    EXPECT_STREQ(unit(report.verdict), "s");
    expect_sums_hold(robot);
}

TEST_P(LateSampleTest, WithinTheWindowIsFusedAtItsOwnTime) {
    const Sample seen = sighting_at(8 * kSecond + 1, 1, {0.1, -0.1, 3});
    std::vector<Sample> samples = drive(500, 10, 10);
    Robot late(GetParam(), plain_params(), kTwoMarkers);
    late.add(samples);
    late.add(seen);
    EXPECT_EQ(late.tally.of(seen), Verdict::fused);
    samples.push_back(seen);
    std::sort(samples.begin(), samples.end(), InOrder{});
    Robot in_order(GetParam(), plain_params(), kTwoMarkers);
    in_order.add(samples);
    EXPECT_TRUE(close(late.state(), in_order.state(), GetParam().is_double ? 1e-12 : 1e-5));
    EXPECT_TRUE(close(late.covariance(), in_order.covariance(), 1e-6));
}

TEST_P(LateSampleTest, BringsNewRevisionsOfTheReportsAfterIt) {
    Robot robot(GetParam(), plain_params(), kTwoMarkers);
    robot.add(encoders_at(0, 0, 0));
    robot.add(sighting_at(30'000, 1, {0.3, kNan, kNan}));
    robot.add(drive(5, 10, 10));
    robot.add(sighting_at(10'000, 2, {2, kNan, kNan}));
    ASSERT_EQ(robot.tally.reports.size(), 3U);
    EXPECT_EQ(robot.tally.reports[0].revision, 0);
    EXPECT_EQ(robot.tally.reports[1].utime, 10'000);
    EXPECT_EQ(robot.tally.reports[1].revision, 0);
    EXPECT_EQ(robot.tally.reports[2].utime, 30'000);
    EXPECT_EQ(robot.tally.reports[2].revision, 1);
    EXPECT_NE(robot.tally.reports[2].innovation[0], robot.tally.reports[0].innovation[0]);
}

/// What is wrong with some is said of each.
TEST_P(LateSampleTest, AFrameOfManyIsComputedOnce) {
    std::vector<Sample> samples = drive(100, 10, 10);
    Robot late(GetParam(), plain_params(), kTwoMarkers),
        in_order(GetParam(), plain_params(), kTwoMarkers);
    late.add(samples);
    std::vector<Sample> frame;
    for (std::uint16_t i = 0; i < 16; ++i)
        frame.push_back(
            sighting_at(kSecond, 1 + i % 2, view({0.5, 0, 0}, kTwoMarkers.markers()[i % 2]), i));
    std::vector<Sample> message = frame;
    message.push_back(frame[3]);
    message.push_back(sighting_at(kSecond, 1, {kInf, kNan, kNan}, 17));
    EXPECT_FALSE(late.add_together(message)) << "motion is no newer";
    EXPECT_EQ(late.tally.reports.size(), 18U) << "each was judged once";
    for (const SightingReport& report : late.tally.reports) EXPECT_EQ(report.revision, 0);
    EXPECT_EQ(late.tally.count(Verdict::duplicate), 1);
    EXPECT_EQ(late.tally.count(Verdict::bad_value), 1);
    expect_sums_hold(late);
    samples.insert(samples.end(), frame.begin(), frame.end());
    std::sort(samples.begin(), samples.end(), InOrder{});
    in_order.add(samples);
    EXPECT_EQ(late.state(), in_order.state());
    EXPECT_EQ(late.covariance(), in_order.covariance());
}

/// A history that cannot hold it forgets what it has computed, not what it was about to.
TEST_P(LateSampleTest, AMessageOfMotionAndMoreThanThereIsRoomForIsAsIfOneByOne) {
    Params params = plain_params();
    params.history.capacity = 16;
    std::vector<Sample> samples = drive(60, 9, 11);
    for (int i = 1; i < 40; ++i)
        samples.push_back(
            sighting_at(i * 30'000 + 1, 1, view({0.5, 0, 0.1}, kTwoMarkers.markers()[0])));
    std::sort(samples.begin(), samples.end(), InOrder{});
    Robot together(GetParam(), params, kTwoMarkers), singly(GetParam(), params, kTwoMarkers);
    EXPECT_TRUE(together.add_together(samples));
    singly.add(samples);
    EXPECT_EQ(together.state(), singly.state());
    EXPECT_EQ(together.tally.verdicts().size(), singly.tally.verdicts().size());
    for (const auto& [sample, verdict] : singly.tally.verdicts())
        EXPECT_EQ(together.tally.of(sample), verdict);
}

TEST_P(LateSampleTest, MayTurnAVerdictRound) {
    Params params = plain_params();
    params.initial.sigma_position_m = 3;
    params.sensors[0].fusion = Fusion::gate;
    Robot robot(GetParam(), params, kTwoMarkers);
    const Pose<double> truth(2, -2, 0);
    robot.add(encoders_at(0, 0, 0));
    const Sample wrong = sighting_at(30'000, 1, view({-2, 3, 1}, kTwoMarkers.markers()[0]));
    const Sample first = sighting_at(10'000, 2, view(truth, kTwoMarkers.markers()[1]));
    robot.add(wrong);
    robot.add(drive(5, 0, 0));
    const Verdict alone = robot.tally.of(wrong);
    robot.add(first);
    EXPECT_EQ(robot.tally.of(first), Verdict::fused);
    EXPECT_EQ(robot.tally.of(wrong), Verdict::gate) << "was " << name(alone) << " alone";
    expect_sums_hold(robot);
}

TEST_P(LateSampleTest, AWindowOfZeroTakesSamplesInOrder) {
    Params params = plain_params();
    params.history.window_s = 0;
    Robot robot(GetParam(), params, kTwoMarkers);
    robot.add(drive(100, 10, 10));
    EXPECT_TRUE(same_pose(robot.pose(), Pose<double>(1, 0, 0), 1e-4));
    robot.add(encoders_at(99 * kPeriod + 1, 990, 990));
    EXPECT_EQ(robot.tally.count(Verdict::late), 1);
    robot.add(sighting_at(100 * kPeriod + 1, 1, view({1, 0, 0}, kTwoMarkers.markers()[0])));
    robot.add(encoders_at(101 * kPeriod, 1000, 1000));
    EXPECT_EQ(robot.tally.reports.back().verdict, Verdict::fused);
}

std::vector<Sample> drive_with_sightings() {
    std::vector<Sample> samples = drive(200, 9, 11);
    for (int i = 0; i < 400; ++i) samples.push_back(gyro_at(i * 10'000 + 1, 0.2));
    for (int i = 1; i < 130; ++i) {
        const double t = i * 0.03;
        const Pose<double> at = after_arc({0.05, 0, 0}, 0.5 * t, 0.2 * t);
        samples.push_back(sighting_at(i * 30'000, 1, view(at, kTwoMarkers.markers()[0])));
    }
    std::sort(samples.begin(), samples.end(), InOrder{});
    return samples;
}

/// A history shorter than the window: samples in order lose nothing, whatever is dropped.
TEST_P(LateSampleTest, ACapacitySmallerThanTheWindowChangesNothingInOrder) {
    for (const HeadingSource heading : {HeadingSource::wheels, HeadingSource::gyro}) {
        Params params = plain_params();
        params.motion.heading = heading;
        Robot large(GetParam(), params, kTwoMarkers);
        large.add(drive_with_sightings());
        for (const int capacity : {8, 9, 10, 13, 50}) {
            SCOPED_TRACE(capacity);
            params.history.capacity = capacity;
            Robot small(GetParam(), params, kTwoMarkers);
            small.add(drive_with_sightings());
            EXPECT_TRUE(close(small.state(), large.state(), 0));
            EXPECT_TRUE(close(small.covariance(), large.covariance(), 0));
            EXPECT_EQ(small.tally.rejected(), 0);
            expect_sums_hold(small);
        }
    }
}

/// What was fused in a dropped step stays fused, also when the step after it is computed again.
TEST_P(LateSampleTest, AfterADroppedStepDoesNotUndoIt) {
    Params params = plain_params();
    params.motion.heading = HeadingSource::gyro;
    for (int capacity = 8; capacity < 20; ++capacity) {
        SCOPED_TRACE(capacity);
        params.history.capacity = capacity;
        const std::vector<Sample> samples = drive_with_sightings();
        Robot small(GetParam(), params, kTwoMarkers);
        params.history.capacity = 2048;
        Robot large(GetParam(), params, kTwoMarkers);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            // Every tenth sample three places late.
            const std::size_t from = i % 10 < 6 ? i : i % 10 == 9 ? i - 3 : i + 1;
            if (from >= samples.size()) break;
            small.add(samples[from]);
            if (small.tally.of(samples[from]) != Verdict::late) large.add(samples[from]);
        }
        EXPECT_TRUE(close(small.state(), large.state(), GetParam().is_double ? 1e-12 : 1e-5));
        EXPECT_LE(small.tally.count(Verdict::late), 3);
        expect_sums_hold(small);
    }
}

TEST_P(LateSampleTest, AFullHistoryOfWaitingSightingsSaysNoToTheOldest) {
    Params params = plain_params();
    params.history.capacity = 16;
    Robot robot(GetParam(), params, kTwoMarkers);
    robot.add(encoders_at(0, 0, 0));
    for (int i = 1; i <= 100; ++i) robot.add(sighting_at(i * 1000, 1, {0.1, kNan, kNan}));
    EXPECT_EQ(robot.tally.count(Verdict::no_motion), 100 - 16);
    robot.add(encoders_at(101'000, 50, 50));
    EXPECT_EQ(robot.tally.count(Verdict::fused), 15 + 2);
    EXPECT_NEAR(robot.pose()[kX], 0.05, 0.2);
    expect_sums_hold(robot);
}

}  // namespace
}  // namespace pilotage::test
