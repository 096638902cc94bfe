// The gyro's turn between motion samples: nothing lost, nothing twice, whatever
// the two rates.

#include <gtest/gtest.h>

#include "pilotage/motion/odometer.hpp"
#include "support/random.hpp"

namespace pilotage::test {
namespace {

constexpr double kMaxGap = 0.5;  // s

TEST(GyroIntegralTest, GivesNoTurnBeforeTheGyroHasSpoken) {
    GyroIntegral gyro;
    EXPECT_FALSE(gyro.take(0, kMaxGap));
    EXPECT_FALSE(gyro.take(20'000, kMaxGap));
}

TEST(GyroIntegralTest, GivesRateTimesTimeAtEqualStamps) {
    GyroIntegral gyro;
    gyro.add(1'000'000, 0.3, kMaxGap);
    (void)gyro.take(1'000'000, kMaxGap);
    gyro.add(1'020'000, 0.5, kMaxGap);
    EXPECT_NEAR(gyro.take(1'020'000, kMaxGap).value(), 0.5 * 0.02, 1e-15);
}

TEST(GyroIntegralTest, HoldsTheLastRateUpToTheMotionSampleAndMakesItGood) {
    GyroIntegral gyro;
    gyro.add(0, 1.0, kMaxGap);
    (void)gyro.take(0, kMaxGap);
    EXPECT_NEAR(gyro.take(30'000, kMaxGap).value(), 0.03, 1e-15) << "1 rad/s held for 30 ms";
    gyro.add(50'000, 2.0, kMaxGap);  // the mean of the 50 ms since was 2 rad/s
    EXPECT_NEAR(gyro.take(60'000, kMaxGap).value(), 0.1 - 0.03 + 0.02, 1e-15);
}

TEST(GyroIntegralTest, GivesNoTurnForAnIntervalOfWhichItMissedAPart) {
    GyroIntegral gyro;
    (void)gyro.take(0, kMaxGap);
    gyro.add(10'000, 1.0, kMaxGap);
    EXPECT_FALSE(gyro.take(20'000, kMaxGap)) << "the first 10 ms are not known";
    EXPECT_NEAR(gyro.take(40'000, kMaxGap).value(), 0.02, 1e-15) << "from then on they are";
}

TEST(GyroIntegralTest, HoldsARateNoLongerThanTheGap) {
    GyroIntegral gyro;
    gyro.add(0, 1.0, kMaxGap);
    (void)gyro.take(0, kMaxGap);
    EXPECT_NEAR(gyro.take(500'000, kMaxGap).value(), 0.5, 1e-15);
    EXPECT_FALSE(gyro.take(520'000, kMaxGap));
    gyro.add(2'000'000, 1.0, kMaxGap);
    EXPECT_FALSE(gyro.take(2'010'000, kMaxGap)) << "silent for a part of this interval";
    EXPECT_NEAR(gyro.take(2'030'000, kMaxGap).value(), 0.02, 1e-15)
        << "what came before the gap is not made good after it";
}

TEST(GyroIntegralTest, KnowsAGapThatEndsBetweenTwoMotionSamples) {
    GyroIntegral gyro;
    gyro.add(0, 1.0, kMaxGap);
    (void)gyro.take(400'000, kMaxGap);
    gyro.add(600'000, 1.0, kMaxGap);
    gyro.add(610'000, 1.0, kMaxGap);
    EXPECT_FALSE(gyro.take(620'000, kMaxGap));
}

TEST(GyroIntegralTest, TakesTheLastOfTwoRatesOfOneStamp) {
    GyroIntegral gyro;
    gyro.add(0, 1.0, kMaxGap);
    gyro.add(0, 3.0, kMaxGap);
    (void)gyro.take(0, kMaxGap);
    EXPECT_NEAR(gyro.take(10'000, kMaxGap).value(), 0.03, 1e-15);
    EXPECT_NEAR(gyro.take(10'000, kMaxGap).value(), 0, 1e-15) << "no time, no turn";
}

/// The turns taken add up to the integral of the rates, the last one held to
/// the end.
TEST(GyroIntegralTest, SumsToTheIntegralForAnyInterleavingWithMotion) {
    for (unsigned seed = 0; seed < 200; ++seed) {
        Draw draw(seed);
        GyroIntegral gyro;
        const double gyro_period = draw.log_uniform(1e3, 2e5);
        const double motion_period = draw.log_uniform(1e3, 2e5);
        double integral = 0, taken = 0, rate = draw.uniform(-1, 1);
        std::int64_t gyro_time = 0, motion_time = 0;
        gyro.add(0, rate, kMaxGap);
        (void)gyro.take(0, kMaxGap);
        for (int i = 0; i < 400; ++i) {
            // Jitter of up to half a period, and now and then both at one moment.
            const auto next_gyro =
                gyro_time + std::llround(gyro_period * draw.uniform(0.5, 1.5)) + 1;
            auto next_motion =
                motion_time + std::llround(motion_period * draw.uniform(0.5, 1.5)) + 1;
            if (i % 7 == 0 && next_gyro > motion_time) next_motion = next_gyro;
            if (next_gyro <= next_motion) {
                rate = draw.uniform(-1, 1);
                gyro.add(next_gyro, rate, kMaxGap);
                integral += rate * static_cast<double>(next_gyro - gyro_time) * 1e-6;
                gyro_time = next_gyro;
                continue;
            }
            const auto turn = gyro.take(next_motion, kMaxGap);
            motion_time = next_motion;
            ASSERT_TRUE(turn) << "seed " << seed;
            taken += *turn;
            const double held = rate * static_cast<double>(motion_time - gyro_time) * 1e-6;
            ASSERT_NEAR(taken, integral + held, 1e-12) << "seed " << seed << ", step " << i;
        }
    }
}

}  // namespace
}  // namespace pilotage::test
