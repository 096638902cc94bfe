// Odometry that never jumps, whatever the pose does; and every jump of the pose, told once.

#include "engine/pose_output.hpp"

#include <algorithm>

#include "support/engines.hpp"
#include "support/journeys.hpp"

namespace pilotage::test {
namespace {

Pose<double> pose_of(const odometry_t& o) {
    return {o.x, o.y, o.heading};
}

/// Each odometry pose is the one before and the arc that its own speed and turn rate drive.
void expect_smooth(const Bench& bench, double tolerance = 1e-9) {
    for (std::size_t i = 1; i < bench.odometry.size(); ++i) {
        const odometry_t &before = bench.odometry[i - 1], &now = bench.odometry[i];
        const double dt = static_cast<double>(now.utime - before.utime) * 1e-6;
        ASSERT_TRUE(same_pose(pose_of(now), after_arc(pose_of(before), now.v * dt, now.omega * dt),
                              tolerance))
            << "at " << now.utime;
    }
}

TEST(PoseOutputTest, OdometryIsTheArcThatWasDriven) {
    Bench bench("", kGyroRobot);
    Journey journey(kAroundOrigin);
    bench.run(journey.go(3, 0.5, 0.3));
    bench.run(journey.go(3, -0.2, -0.8));
    bench.run(journey.go(2));
    bench.run(journey.go(3, 0.5, 0.3));
    ASSERT_EQ(bench.odometry.size(), 11U * 50 + 1);
    EXPECT_TRUE(same_pose(pose_of(bench.odometry.front()), Pose<double>(0, 0, 0), 0))
        << "it begins at the first motion sample";
    expect_smooth(bench);
    EXPECT_TRUE(same_pose(pose_of(bench.odometry.back()), journey.truth, 0.01));
}

TEST(PoseOutputTest, NeitherCorrectionsNorResetsNorLateSamplesMoveTheOdometry) {
    Bench bench("", kGyroRobot);
    Journey journey(kAroundOrigin);
    bench.run(journey.go(5, 0.4, 0.2));
    std::vector<Sample> samples = journey.go(3, 0.4, 0.2);
    // Sightings come 0.7 s late, each tenth gyro sample 0.1 s.
    std::vector<std::pair<std::int64_t, Sample>> arrivals;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const bool seen = samples[i].stream == Stream::sighting;
        const bool late_turn = samples[i].stream == Stream::gyro && i % 10 == 0;
        arrivals.emplace_back(samples[i].utime + (seen        ? 700'000
                                                  : late_turn ? 100'000
                                                              : 0),
                              samples[i]);
    }
    std::stable_sort(arrivals.begin(), arrivals.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    samples.clear();
    for (const auto& arrival : arrivals) samples.push_back(arrival.second);
    bench.run(samples);
    journey.truth[kX] += 20;  // and then the sightings contradict it
    bench.run(journey.go(10, 0.4, 0.2));
    bench.run({reset_at(journey.utime + 1, {3, 3, 3}, {0.1, 0.1, 0.1})});
    bench.run(journey.go(2, 0.4, 0.2));
    expect_smooth(bench);
    EXPECT_FALSE(bench.jumps.empty());
    double farthest = 0;
    for (std::size_t i = 1; i < bench.odometry.size(); ++i)
        farthest = std::max(farthest, std::hypot(bench.odometry[i].x - bench.odometry[i - 1].x,
                                                 bench.odometry[i].y - bench.odometry[i - 1].y));
    EXPECT_LT(farthest, 0.02) << "0.4 m/s for 20 ms";
    EXPECT_EQ(bench.odometry.size(), bench.poses.size());
}

TEST(PoseOutputTest, ACounterResetIsNoMotion) {
    Bench bench("", kGyroRobot);
    Journey journey(kAroundOrigin);
    journey.camera = false;
    bench.run(journey.go(30, 0.9, 0));
    journey.reset_ticks();
    bench.run(journey.go(1, 0.9, 0));
    for (std::size_t i = 1; i < bench.odometry.size(); ++i)
        ASSERT_LT(std::hypot(bench.odometry[i].x - bench.odometry[i - 1].x,
                             bench.odometry[i].y - bench.odometry[i - 1].y),
                  0.03);
    EXPECT_NEAR(bench.odometry.back().x, 31 * 0.9, 0.05);
}

Estimate estimate_at(std::int64_t utime, const Pose<double>& pose, double distance = 0,
                     double turn = 0) {
    Estimate e;
    e.utime = utime;
    e.pose = pose;
    e.driven = {distance, turn};
    return e;
}

TEST(PoseOutputTest, OnlyWhatTheRobotDidNotDriveIsAJump) {
    PoseOutput output(0, 0.3, 0.15);
    EXPECT_FALSE(output.follow(estimate_at(0, {5, 5, 1}))) << "the first pose comes from nowhere";
    EXPECT_FALSE(output.follow(estimate_at(1, after_arc({5, 5, 1}, 2, 1), 2, 1))) << "driven";
    EXPECT_FALSE(output.follow(estimate_at(2, after_arc({5, 5, 1}, 2, 1))));
    EXPECT_EQ(output.resets(), 0);
    const std::optional<Jump> back = output.follow(estimate_at(3, {5, 5, 1}));
    ASSERT_TRUE(back);
    EXPECT_STREQ(back->cause, "correction");
    EXPECT_TRUE(same_pose(back->before, after_arc({5, 5, 1}, 2, 1), 1e-12));
    EXPECT_TRUE(same_pose(back->after, Pose<double>(5, 5, 1), 0));
    EXPECT_FALSE(output.follow(estimate_at(4, {5, 5, 1}))) << "told once";
    EXPECT_EQ(output.resets(), 1);
    EXPECT_TRUE(same_pose(output.odometry(), after_arc({0, 0, 0}, 2, 1), 1e-12));
}

TEST(PoseOutputTest, AJumpIsBeyondTheLimitInPositionOrHeading) {
    for (const double size : {0.99, 1.01}) {
        const Pose<double> starts[] = {{0, 0, 0}, {0, 0, 3.1}};
        for (const Pose<double>& start : starts)
            for (const Pose<double>& off :
                 {Pose<double>(0.3, 0, 0), Pose<double>(0, -0.3, 0), Pose<double>(0.18, 0.24, 0),
                  Pose<double>(0, 0, 0.15), Pose<double>(0, 0, -0.15)}) {
                PoseOutput output(0, 0.3, 0.15);
                (void)output.follow(estimate_at(0, start));
                Pose<double> to = start + size * off;
                to[kHeading] = wrap(to[kHeading]);
                EXPECT_EQ(output.follow(estimate_at(1, to)).has_value(), size > 1)
                    << to.transpose();
            }
    }
}

TEST(PoseOutputTest, AResetIsToldAsOneHoweverSmall) {
    PoseOutput output(0, 0.3, 0.15);
    (void)output.follow(estimate_at(0, {0, 0, 0}));
    Estimate e = estimate_at(1, {0.01, 0, 0});
    e.resets = 1;
    const std::optional<Jump> reset = output.follow(e);
    ASSERT_TRUE(reset);
    EXPECT_STREQ(reset->cause, "reset");
    EXPECT_EQ(output.resets(), 1);
    e.utime = 0;  // the clock goes back
    const std::optional<Jump> clock = output.follow(e);
    ASSERT_TRUE(clock);
    EXPECT_STREQ(clock->cause, "clock");
    EXPECT_EQ(output.resets(), 2);
}

/// A correction that creeps in small steps is no jump.
TEST(PoseOutputTest, ASlowCorrectionIsNone) {
    PoseOutput output(0, 0.3, 0.15);
    (void)output.follow(estimate_at(0, {0, 0, 0}));
    for (int i = 1; i <= 100; ++i) EXPECT_FALSE(output.follow(estimate_at(i, {0.29 * i, 0, 0})));
}

}  // namespace
}  // namespace pilotage::test
