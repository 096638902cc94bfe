// Time policies through the engine, and stamps that no clock would give.

#include <cmath>
#include <limits>

#include "support/engines.hpp"

namespace pilotage::test {
namespace {

/// A camera whose frames show marker 1 from a robot that drives along x at 1 m/s.
std::int64_t fused_at(const std::string& camera, std::int64_t utime, std::int64_t received) {
    Bench bench("", R"(
motion: {heading: wheels}
initial: {x_m: 0, y_m: 0, heading_rad: 0}
map: [{id: 1, x: 6, y: 2}]
sensors:
  camera: )" + camera + "\n");
    for (int i = 0; i <= 100; ++i) bench.send("ENCODERS", encoders(i * 20'000, 20 * i, 20 * i, i));
    bench.send("MARKERS", frame(utime, "camera", {seen(1, 0.3)}), received);
    EXPECT_EQ(bench.reports.size(), 1U);
    const marker_report_t& report = bench.reports.at(0);
    EXPECT_TRUE(report.accepted) << report.reason;
    const double x = static_cast<double>(report.utime) * 1e-6;
    EXPECT_NEAR(report.innovation[0], 0.3 - std::atan2(2, 6 - x), 1e-9) << "not where it was then";
    return report.utime;
}

TEST(EngineTimeTest, ASightingIsFusedAtTheTimeThatItsPolicySays) {
    EXPECT_EQ(fused_at("{}", 1'200'000, 1'900'000), 1'200'000);
    EXPECT_EQ(fused_at("{time: receive}", 77, 1'900'000), 1'900'000);
    EXPECT_EQ(fused_at("{time: mapped}", 77, 1'900'000), 1'900'000);
}

TEST(EngineTimeTest, ALatencyOfEitherSignMovesIt) {
    EXPECT_EQ(fused_at("{latency_s: 0.065}", 1'200'000, 0), 1'135'000);
    EXPECT_EQ(fused_at("{latency_s: -0.2}", 1'200'000, 0), 1'400'000);
    EXPECT_EQ(fused_at("{time: receive, latency_s: 0.5}", 0, 1'900'000), 1'400'000);
    EXPECT_EQ(fused_at("{time: mapped, latency_s: -0.05}", 0, 1'900'000), 1'950'000);
}

TEST(EngineTimeTest, AMappedClockMayBeAYearOff) {
    constexpr std::int64_t off = -31'536'000'000'000;
    Bench bench("encoders: {time: mapped}\n");
    for (int i = 0; i <= 200; ++i) {
        const std::int64_t delay = 1'000 + (i * 7'919) % 30'000;
        bench.send("ENCODERS", encoders(off + i * 20'000, 10 * i, 10 * i, i), i * 20'000 + delay);
    }
    EXPECT_NEAR(bench.poses.back().x, 2, 1e-9);
    EXPECT_NEAR(static_cast<double>(bench.poses.back().utime), 4e6 + 1000, 300);
    EXPECT_NEAR(static_cast<double>(bench.input("ENCODERS").clock_offset_us),
                static_cast<double>(-off) + 1000, 300);
}

TEST(EngineTimeTest, AStampOfNoClockIsCountedAndOverflowsNothing) {
    constexpr std::int64_t low = std::numeric_limits<std::int64_t>::min();
    constexpr std::int64_t high = std::numeric_limits<std::int64_t>::max();
    const std::int64_t times[] = {low, low + 1,  low / 2,  low / 4,  low / 8 - 1,      -1,
                                  0,   high / 8, high / 4, high / 2, high - 1'000'000, high - 1,
                                  high};
    for (const std::string policy : {"utime", "receive", "mapped"})
        for (const std::string latency : {"0", "1000000", "-1000000"}) {
            const std::string input = ": {time: " + policy + ", latency_s: " + latency + "}\n";
            Bench bench("gyro" + input + "pose_reset" + input + "encoders" + input);
            int sent = 0;
            for (const std::int64_t utime : times)
                for (const std::int64_t received : times) {
                    bench.send("ENCODERS", encoders(utime, sent, sent, sent), received);
                    bench.send("GYRO", gyro(utime, 0.1, sent), received);
                    bench.send("MARKERS", frame(utime, "camera", {seen(1, 0.3)}, sent), received);
                    bench.send("POSE_RESET", reset(utime, 0, 0, 0), received);
                    bench.engine().tick(received, received);
                    ++sent;
                }
            for (const char* channel : {"ENCODERS", "GYRO", "MARKERS", "POSE_RESET"})
                EXPECT_EQ(bench.input(channel).received, sent) << channel;
        }
}

}  // namespace
}  // namespace pilotage::test
