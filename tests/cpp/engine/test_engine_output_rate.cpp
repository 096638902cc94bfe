// Poses at a rate of their own: stamps go on by the period, whatever the motion's rate.

#include <set>

#include "support/engines.hpp"
#include "support/journeys.hpp"

namespace pilotage::test {
namespace {

/// An engine in the map of the journeys, with so many poses a second.
Bench paced(const std::string& rate) {
    return Bench("output: {rate_hz: " + rate + "}\n", kGyroRobot);
}

void expect_steady(const Bench& bench, std::int64_t period) {
    for (std::size_t i = 1; i < bench.poses.size(); ++i)
        ASSERT_EQ(bench.poses[i].utime - bench.poses[i - 1].utime, period) << "pose " << i;
}

/// Ticks as often as the engine asks for, between the samples.
void run_with_ticks(Bench& bench, const std::vector<Sample>& samples, std::int64_t& tick_at) {
    for (const Sample& sample : samples) {
        for (; tick_at <= sample.utime; tick_at += bench.engine().tick_period())
            bench.engine().tick(tick_at, 0);
        bench.run({sample});
    }
}

TEST(EngineOutputRateTest, StampsGoOnByThePeriodWhateverTheMotionsRate) {
    for (const int rate : {1, 10, 20, 100, 200}) {
        SCOPED_TRACE(rate);
        Bench bench = paced(std::to_string(rate));
        Journey journey(kAroundOrigin);
        journey.camera = false;
        std::int64_t tick_at = 0;
        run_with_ticks(bench, journey.go(10, 0.5, 0.2), tick_at);
        EXPECT_NEAR(static_cast<double>(bench.poses.size()), 10.0 * rate, 2 + 0.03 * rate);
        expect_steady(bench, 1'000'000 / rate);
        EXPECT_EQ(bench.odometry.size(), 501U) << "the odometry keeps the motion's rate";
    }
}

TEST(EngineOutputRateTest, PosesAreThoseOfTheMotionOnItsStampsAndPredictedBetween) {
    Bench bench = paced("100"), plain = paced("0");
    Journey journey(kAroundOrigin), same(kAroundOrigin);
    journey.camera = same.camera = false;
    std::int64_t tick_at = 0;
    run_with_ticks(bench, journey.go(4, 0.5, 0.2), tick_at);
    plain.run(same.go(4, 0.5, 0.2));
    ASSERT_GT(bench.poses.size(), 390U);
    int compared = 0;
    for (const pose_t& p : bench.poses)
        for (const pose_t& q : plain.poses) {
            if (p.utime != q.utime && p.utime != q.utime + 10'000) continue;
            const double ahead = static_cast<double>(p.utime - q.utime) * 1e-6;
            const Pose<double> expected =
                after_arc({q.x, q.y, q.heading}, q.v * ahead, q.omega * ahead);
            EXPECT_TRUE(same_pose(Pose<double>(p.x, p.y, p.heading), expected, 0.013))
                << "at " << p.utime;
            EXPECT_GE(p.covariance[0], ahead > 0 ? q.covariance[0] - 1e-12 : 0.01);
            ++compared;
        }
    EXPECT_GT(compared, 390);
}

TEST(EngineOutputRateTest, GoesOnThroughASilenceOfTheMotionAndSaysSo) {
    Bench bench = paced("20");
    Journey journey(kAroundOrigin);
    std::int64_t tick_at = 0;
    run_with_ticks(bench, journey.go(5, 0.3, 0.1), tick_at);
    ASSERT_EQ(bench.poses.back().status, status_t::OK);
    for (const std::int64_t end = tick_at + 20'000'000; tick_at < end;
         tick_at += bench.engine().tick_period())
        bench.engine().tick(tick_at, 0);
    expect_steady(bench, 50'000);
    EXPECT_NEAR(static_cast<double>(bench.poses.back().utime), 25e6, 0.1e6);
    std::set<int> seen;
    for (const pose_t& pose : bench.poses) seen.insert(pose.status);
    EXPECT_TRUE(seen.count(status_t::DEAD_RECKONING)) << "on the way to";
    EXPECT_EQ(bench.poses.back().status, status_t::LOST);
    EXPECT_EQ(bench.poses.back().v, 0);
    for (std::size_t i = 1; i < bench.statuses.size(); ++i)
        EXPECT_EQ(bench.statuses[i].utime - bench.statuses[i - 1].utime, 1'000'000);
}

TEST(EngineOutputRateTest, NothingIsPublishedBeforeTheStart) {
    Bench bench = paced("20");
    for (int i = 0; i < 100; ++i) bench.engine().tick(i * 50'000, 0);
    EXPECT_TRUE(bench.poses.empty());
}

TEST(EngineOutputRateTest, MayBeLessThanOneASecond) {
    Bench bench = paced("0.4");
    Journey journey(kAroundOrigin);
    bench.run(journey.go(60, 0.1, 0.2));
    EXPECT_EQ(bench.poses.size(), 25U);
    expect_steady(bench, 2'500'000);
}

/// A recording may hold no ticks, or those of another rate.
TEST(EngineOutputRateTest, NeedsNoTicksInBetween) {
    Bench bench = paced("200");
    Journey journey(kAroundOrigin);
    bench.run(journey.go(10, 0.5, 0.2));  // ticks once a second
    expect_steady(bench, 5'000);
    EXPECT_NEAR(static_cast<double>(bench.poses.size()), 2000, 10);
}

/// Messages that are on their way for a while, each for another, do not disturb the pace.
TEST(EngineOutputRateTest, DelaysDoNotDisturbThePace) {
    Bench bench = paced("50");
    Journey journey(kAroundOrigin);
    journey.camera = false;
    for (int i = 0; i < 500; ++i)
        for (const Sample& s : journey.go(0.02, 0.3, 0.1)) {
            const std::int64_t received = s.utime + (i * 7919) % 15'000;
            if (s.stream == Stream::motion)
                bench.send("ENCODERS",
                           encoders(s.utime, s.payload.ticks.left, s.payload.ticks.right, s.seq),
                           received);
            else
                bench.send("GYRO", gyro(s.utime, s.payload.gyro.rate_rad_s, s.seq), received);
        }
    expect_steady(bench, 20'000);
    EXPECT_NEAR(static_cast<double>(bench.poses.size()), 500, 3);
}

/// One jump of the clock is one pose, not a million.
TEST(EngineOutputRateTest, AClockThatIsSetCostsNothing) {
    Bench bench = paced("100");
    Journey journey(kAroundOrigin);
    std::int64_t tick_at = 0;
    run_with_ticks(bench, journey.go(2, 0.3, 0.1), tick_at);
    const std::size_t before = bench.poses.size();
    bench.engine().tick(tick_at + 1'000'000'000'000'000, 0);
    bench.engine().tick(tick_at - 1'000'000'000'000'000, 0);
    bench.engine().tick(tick_at, 0);
    EXPECT_LE(bench.poses.size(), before + 3);
}

TEST(EngineOutputRateTest, AsksForTicksOfItsRateAndTellsItsStatusOnceASecond) {
    EXPECT_EQ(Bench().engine().tick_period(), 1'000'000);
    EXPECT_EQ(Bench("output: {rate_hz: 0.5}\n").engine().tick_period(), 1'000'000);
    EXPECT_EQ(Bench("output: {rate_hz: 50}\n").engine().tick_period(), 20'000);
    Bench bench = paced("50");
    for (int i = 0; i < 500; ++i) bench.engine().tick(1'000'000'000 + i * 20'000, 0);
    EXPECT_EQ(bench.statuses.size(), 10U);
}

}  // namespace
}  // namespace pilotage::test
