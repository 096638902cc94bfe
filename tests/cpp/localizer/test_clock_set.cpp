// The clock that dates motion is set under way: the pose goes on, only its time is another.

#include "support/journeys.hpp"
#include "support/localizers.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_LOCALIZER_SUITE(ClockSetTest);

constexpr std::int64_t kShifts[] = {3600 * kSecond, -3600 * kSecond, 5 * kSecond, -kSecond, 1};

std::vector<Sample> shifted(std::vector<Sample> samples, std::int64_t by) {
    for (Sample& sample : samples) sample.utime += by;
    return samples;
}

TEST_P(ClockSetTest, TheDriveGoesOnAsIfNothingHadHappened) {
    for (const std::int64_t shift : kShifts) {
        SCOPED_TRACE(shift);
        Params params = gyro_params();
        params.motion.heading = HeadingSource::wheels;  // the gyro misses a step
        Robot robot(GetParam(), params, kAroundOrigin), plain(GetParam(), params, kAroundOrigin);
        Journey journey(kAroundOrigin), same(kAroundOrigin);
        robot.add(journey.go(3, 0.4, 0.2));
        plain.add(same.go(3, 0.4, 0.2));
        robot.set_time(journey.utime + shift);
        EXPECT_EQ(robot.estimate().utime, journey.utime + shift);
        EXPECT_EQ(robot.estimate().status, Status::ok) << "it agreed just now";
        robot.add(shifted(journey.go(5, 0.4, 0.2), shift));
        plain.add(same.go(5, 0.4, 0.2));
        EXPECT_EQ(robot.estimate().utime, plain.estimate().utime + shift);
        EXPECT_EQ(robot.estimate().status, Status::ok);
        EXPECT_TRUE(close(robot.state(), plain.state(), 1e-6 + GetParam().tolerance));
        EXPECT_TRUE(close(robot.covariance(), plain.covariance(), 1e-6 + GetParam().tolerance));
        EXPECT_EQ(robot.estimate().resets, 0);
        expect_sums_hold(robot);
    }
}

/// What the old clock dated says nothing of the new time: neither a turn nor a gap.
TEST_P(ClockSetTest, TheGyroStartsAnew) {
    for (const std::int64_t shift : kShifts) {
        SCOPED_TRACE(shift);
        Robot robot(GetParam(), gyro_params(), kAroundOrigin);
        Journey journey(kAroundOrigin);
        journey.camera = false;
        robot.add(journey.go(3, 0.4, 0.5));
        robot.set_time(journey.utime + shift);
        robot.add(shifted(journey.go(3, 0.4, 0.5), shift));
        EXPECT_NEAR(wrap(robot.pose()[kHeading] - journey.truth[kHeading]), 0, 4e-3);
        EXPECT_TRUE(same_pose(robot.pose(), journey.truth, 0.02));
    }
}

TEST_P(ClockSetTest, WhatWaitsIsRejectedAndWhatIsOldIsLate) {
    Robot robot(GetParam(), gyro_params(), kAroundOrigin);
    Journey journey(kAroundOrigin);
    robot.add(journey.go(3));
    const Sample waiting = sighting_at(journey.utime + 1, 1, {0.3, kNan, kNan}, 9);
    robot.add(waiting);
    EXPECT_EQ(robot.tally.of(waiting), Verdict::pending);
    robot.set_time(journey.utime + 100 * kSecond);
    EXPECT_EQ(robot.tally.of(waiting), Verdict::no_motion);
    const Sample old = sighting_at(journey.utime, 1, {0.3, kNan, kNan}, 10);
    robot.add(old);
    EXPECT_EQ(robot.tally.of(old), Verdict::late);
    const Sample just = sighting_at(journey.utime + 100 * kSecond, 1, {0.3, kNan, kNan}, 11);
    robot.add(just);
    EXPECT_EQ(robot.tally.of(just), Verdict::late) << "what is older can no longer change";
    expect_sums_hold(robot);
}

TEST_P(ClockSetTest, SetBackTheSameStampsComeAgain) {
    Robot robot(GetParam(), gyro_params(), kAroundOrigin);
    Journey journey(kAroundOrigin);
    robot.add(journey.go(3, 0.2, 0));
    robot.set_time(journey.utime - 2 * kSecond);
    robot.add(shifted(journey.go(1, 0.2, 0), -2 * kSecond));
    EXPECT_EQ(robot.tally.count(Verdict::late), 0);
    EXPECT_TRUE(same_pose(robot.pose(), journey.truth, 0.1));
    EXPECT_EQ(robot.estimate().utime, journey.utime - 2 * kSecond);
}

TEST_P(ClockSetTest, BeforeAnyMotionNothingBreaks) {
    Robot robot(GetParam(), gyro_params(), kAroundOrigin);
    robot.set_time(5 * kSecond);
    Journey journey(kAroundOrigin);
    journey.utime = 10 * kSecond;
    robot.add(journey.go(2, 0.3, 0));
    EXPECT_TRUE(same_pose(robot.pose(), journey.truth, 0.15));
    EXPECT_EQ(robot.estimate().status, Status::ok);
}

}  // namespace
}  // namespace pilotage::test
