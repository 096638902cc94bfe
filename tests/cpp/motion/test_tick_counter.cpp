// Wheel travel from absolute counts: signs, wraps at 16 and 32 bits, counters
// that start again, garbage.

#include <gtest/gtest.h>

#include <limits>

#include "pilotage/motion/odometer.hpp"

namespace pilotage::test {
namespace {

constexpr double kDt_s = 0.02;  // s

struct Travelled {
    TickFault fault;
    double left_m, right_m;
};

/// From the first counts to the second, at 1 mm a tick.
Travelled travel(const EncoderTicks& from, const EncoderTicks& to, double dt_s = kDt_s,
                 const WheelParams& wheels = {}) {
    TickCounter counter;
    counter.start(from);
    Travelled result{TickFault::none, -99, -99};
    result.fault = counter.advance(to, dt_s, wheels, result.left_m, result.right_m);
    return result;
}

void expect_travel(const Travelled& actual, TickFault fault, double left_m, double right_m) {
    EXPECT_EQ(int(actual.fault), int(fault));
    EXPECT_NEAR(actual.left_m, left_m, 1e-12);
    EXPECT_NEAR(actual.right_m, right_m, 1e-12);
}

TEST(TickCounterTest, GivesTheDifferenceTimesTheTicksOfAMetre) {
    expect_travel(travel({1000, 1000}, {1010, 992}), TickFault::none, 0.010, -0.008);
    expect_travel(travel({-5, 5}, {5, -5}), TickFault::none, 0.010, -0.010);
}

TEST(TickCounterTest, HasAScaleAndASignForEachWheel) {
    WheelParams wheels;
    wheels.left_m_per_tick = -0.002;
    wheels.right_m_per_tick = 0.0005;
    expect_travel(travel({0, 0}, {-10, 10}, kDt_s, wheels), TickFault::none, 0.020, 0.005);
}

TEST(TickCounterTest, CountsOnFromTheLastCounts) {
    TickCounter counter;
    counter.start({100, 200});
    double left = 0, right = 0, left_sum = 0, right_sum = 0;
    for (int i = 1; i <= 1000; ++i) {
        EXPECT_EQ(counter.advance({100 + 7 * i, 200 - 3 * i}, kDt_s, {}, left, right),
                  TickFault::none);
        left_sum += left;
        right_sum += right;
    }
    EXPECT_NEAR(left_sum, 7.0, 1e-9);
    EXPECT_NEAR(right_sum, -3.0, 1e-9);
}

TEST(TickCounterTest, SeesThroughAWrapAt32Bits) {
    constexpr std::int64_t top = std::numeric_limits<std::int32_t>::max();
    expect_travel(travel({top - 3, 0}, {-top - 1 + 4, 9}), TickFault::wrapped, 0.008, 0.009);
    expect_travel(travel({-top - 1, 0}, {top, 0}), TickFault::wrapped, -0.001, 0);
    constexpr std::int64_t full = std::int64_t{1} << 32;
    expect_travel(travel({full - 2, 3}, {3, full - 7}), TickFault::wrapped, 0.005, -0.010);
}

TEST(TickCounterTest, SeesThroughAWrapAt16Bits) {
    expect_travel(travel({32767, -32768}, {-32768, 32767}), TickFault::wrapped, 0.001, -0.001);
    expect_travel(travel({65530, 10}, {4, 20}), TickFault::wrapped, 0.010, 0.010);
}

TEST(TickCounterTest, TellsAResetFromAWrap) {
    for (const std::int64_t before : {12'345, -20'000, 40'000, 123'456, 70'000'000}) {
        expect_travel(travel({before, before}, {0, 0}), TickFault::reset, 0, 0);
        expect_travel(travel({before, before}, {0, before}), TickFault::reset, 0, 0);
        expect_travel(travel({before, before}, {before, 3}), TickFault::reset, 0, 0);
    }
}

TEST(TickCounterTest, CountsOnAfterAReset) {
    TickCounter counter;
    counter.start({50'000, 50'000});
    double left = 0, right = 0;
    EXPECT_EQ(counter.advance({0, 0}, kDt_s, {}, left, right), TickFault::reset);
    EXPECT_EQ(counter.advance({5, 6}, kDt_s, {}, left, right), TickFault::none);
    EXPECT_NEAR(left, 0.005, 1e-12);
    EXPECT_NEAR(right, 0.006, 1e-12);
}

TEST(TickCounterTest, AllowsMoreTravelAfterALongerTime) {
    expect_travel(travel({0, 0}, {30'000, 30'000}, 0.02), TickFault::reset, 0, 0);
    expect_travel(travel({0, 0}, {30'000, 30'000}, 3.0), TickFault::none, 30, 30);
}

TEST(TickCounterTest, AllowsThePeriodOfAStampThatRepeats) {
    expect_travel(travel({0, 0}, {200, 180}, 0), TickFault::none, 0.2, 0.18);
}

TEST(TickCounterTest, SurvivesAnyTwoNumbers) {
    constexpr std::int64_t low = std::numeric_limits<std::int64_t>::min();
    constexpr std::int64_t high = std::numeric_limits<std::int64_t>::max();
    for (const std::int64_t from : {low, low + 1, std::int64_t{0}, high - 1, high})
        for (const std::int64_t to : {low, std::int64_t{-1}, std::int64_t{0}, high}) {
            const Travelled result = travel({from, to}, {to, from});
            EXPECT_LE(std::abs(result.left_m), 10.0) << from << " to " << to;
            EXPECT_LE(std::abs(result.right_m), 10.0) << from << " to " << to;
        }
}

}  // namespace
}  // namespace pilotage::test
