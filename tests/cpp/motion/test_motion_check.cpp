// Standstill, slip and lift: what wheels and gyro say of each other over windows of half a second.

#include "pilotage/motion/motion_check.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace pilotage::test {
namespace {

constexpr double kStep_s = 1.0 / 64;  // 32 of them are a window, without rounding
constexpr int kWindow = 32;
constexpr double kTurnOfATick_rad = 0.002;
constexpr RotationTolerance kTolerance{4e-6, 0, kTurnOfATick_rad};

/// So much turn a second, as wheels and gyro have it.
RotationStep step(bool ticked, double wheel_rad_s, std::optional<double> gyro_rad_s) {
    RotationStep s;
    s.dt_s = kStep_s;
    s.ticked = ticked;
    s.distance_m = ticked ? 0.5 * kStep_s : 0;
    s.wheel_turn_rad = wheel_rad_s * kStep_s;
    if (gyro_rad_s) s.gyro_turn_rad = *gyro_rad_s * kStep_s;
    return s;
}

/// \return how many windows ended
int feed(MotionCheck& check, int steps, const RotationStep& s,
         const RotationTolerance& tolerance = kTolerance) {
    int ended = 0;
    while (steps-- > 0) ended += check.add(s, tolerance) ? 1 : 0;
    return ended;
}

MotionState after_a_window(const RotationStep& s, const RotationTolerance& t = kTolerance) {
    MotionCheck check;
    EXPECT_EQ(feed(check, kWindow, s, t), 1);
    return check.state();
}

TEST(MotionCheckTest, StandsAfterAWholeWindowWithoutATick) {
    MotionCheck check;
    EXPECT_EQ(feed(check, kWindow - 1, step(false, 0, 0)), 0);
    EXPECT_EQ(check.state(), MotionState::driving) << "not yet";
    EXPECT_EQ(feed(check, 1, step(false, 0, 0)), 1);
    EXPECT_EQ(check.state(), MotionState::standing);
    EXPECT_EQ(check.window().duration_s, 0.5);
}

TEST(MotionCheckTest, DoesNotStandForATickAnywhereInTheWindow) {
    for (int at = 0; at < kWindow; ++at) {
        MotionCheck check;
        feed(check, at, step(false, 0, 0));
        feed(check, 1, step(true, 0, 0));
        feed(check, kWindow - 1 - at, step(false, 0, 0));
        EXPECT_EQ(check.state(), MotionState::driving) << "tick in step " << at;
    }
}

/// Standstill ends with the first tick, and what the gyro told since the last whole window was the
/// beginning of the motion.
TEST(MotionCheckTest, DrivesAtTheFirstTickAndReleasesTheTurnSinceTheLastWindow) {
    MotionCheck check;
    feed(check, 6 * kWindow, step(false, 0, 0.003));
    EXPECT_TRUE(check.settled());
    feed(check, 10, step(false, 0, 0.006));
    EXPECT_EQ(check.state(), MotionState::standing);
    EXPECT_EQ(check.released_rad(), 0);
    feed(check, 1, step(true, 0.1, 0.1));
    EXPECT_EQ(check.state(), MotionState::driving);
    EXPECT_NEAR(check.released_rad(), 10 * 0.006 * kStep_s, 1e-15) << "without the step itself";
    EXPECT_EQ(feed(check, kWindow - 2, step(true, 0.1, 0.1)), 0) << "a window begins at the tick";
    EXPECT_EQ(check.released_rad(), 0) << "only once";
    EXPECT_EQ(feed(check, 1, step(true, 0.1, 0.1)), 1);
    EXPECT_NEAR(check.window().gyro_turn_rad, 0.05, 1e-12);
}

/// A robot that creeps ticks now and then. Of a standstill that is too short to be told from that,
/// all that was not believed is released: all but its first window.
TEST(MotionCheckTest, ReleasesAllOfAStandstillThatMayHaveBeenACreep) {
    for (int windows = 1; windows <= 4; ++windows) {
        MotionCheck check;
        feed(check, windows * kWindow + 10, step(false, 0, 0.004));
        EXPECT_EQ(check.state(), MotionState::standing);
        EXPECT_FALSE(check.settled());
        feed(check, 1, step(true, 0.1, 0.1));
        EXPECT_NEAR(check.released_rad(), ((windows - 1) * kWindow + 10) * 0.004 * kStep_s, 1e-15);
        feed(check, 2 * kWindow, step(false, 0, 0));
        feed(check, 1, step(true, 0.1, 0.1));
        EXPECT_EQ(check.released_rad(), 0) << "only once";
    }
}

TEST(MotionCheckTest, IsLiftedWhereTheGyroTurnsWithoutATick) {
    for (const double rate : {0.2, -0.2}) {
        MotionCheck check;
        feed(check, kWindow, step(false, 0, rate));
        EXPECT_EQ(check.state(), MotionState::lifted);
        EXPECT_NEAR(check.window().disagreement_rad, -rate / 2, 1e-12) << "wheels less gyro";
        feed(check, 1, step(true, 0, rate));
        EXPECT_EQ(check.state(), MotionState::driving) << "put down again";
        EXPECT_EQ(check.released_rad(), 0) << "while lifted the gyro was believed";
    }
}

/// What was not believed of the window that turns out to be a lift: all but its last step, which is
/// judged with it.
TEST(MotionCheckTest, ReleasesTheTurnOfAWindowThatEndsAStandstillByALift) {
    MotionCheck check;
    feed(check, 2 * kWindow, step(false, 0, 0));
    feed(check, kWindow - 1, step(false, 0, 0.4));
    EXPECT_EQ(check.state(), MotionState::standing);
    feed(check, 1, step(false, 0, 0.4));
    EXPECT_EQ(check.state(), MotionState::lifted);
    EXPECT_NEAR(check.released_rad(), (kWindow - 1) * 0.4 * kStep_s, 1e-12);
}

/// A wheel that spins turns the wheels' robot more than the gyro's, also where that slowly turns
/// the other way; less, or as much the other way round, is no slip.
TEST(MotionCheckTest, SlipsWhereTheWheelsTurnMoreAndSuspectsTheGyroWhereTheyTurnLess) {
    struct Case {
        double wheels, gyro;
        bool suspect;
    };
    for (const Case& c : {Case{1, 0, false}, Case{-1, 0, false}, Case{1, 0.5, false},
                          Case{-1, -0.5, false}, Case{0.3, 0.6, true}, Case{-0.3, -0.6, true},
                          Case{0.3, -0.25, true}, Case{-0.3, 0.25, true}, Case{0, 0.3, true},
                          Case{0.9, -0.1, false}, Case{-0.9, 0.1, false}}) {
        SCOPED_TRACE(::testing::Message() << "wheels " << c.wheels << " gyro " << c.gyro);
        MotionCheck check;
        feed(check, kWindow, step(true, c.wheels, c.gyro));
        EXPECT_EQ(check.state(), MotionState::slipping);
        EXPECT_EQ(check.gyro_suspect(), c.suspect);
        EXPECT_NEAR(check.window().disagreement_rad, (c.wheels - c.gyro) / 2, 1e-12);
        EXPECT_NEAR(check.window().distance_m, 0.25, 1e-12);
        feed(check, kWindow, step(true, 0.5, 0.5));
        EXPECT_EQ(check.state(), MotionState::driving) << "and ends with a window that agrees";
        EXPECT_FALSE(check.gyro_suspect());
        EXPECT_EQ(check.window().disagreement_rad, 0);
    }
}

/// A gyro that is off by 2.5 sigmas of a window, and one that is so to one side and the other.
TEST(MotionCheckTest, SeesOverManyWindowsWhatOneHides) {
    constexpr RotationTolerance noisy{8e-4, 0, kTurnOfATick_rad};
    MotionCheck off, noise;
    for (int i = 0; i < 12; ++i) {
        feed(off, kWindow, step(true, 0, 0.1), noisy);
        feed(noise, kWindow, step(true, 0, i % 2 == 0 ? 0.1 : -0.1), noisy);
        EXPECT_EQ(off.state(), MotionState::driving);
        EXPECT_EQ(noise.window().lasting_rad, 0);
        EXPECT_EQ(off.window().lasting_rad == 0, i < 3) << "after " << i + 1;
    }
    EXPECT_NEAR(off.window().lasting_rad, -0.05, 0.015) << "a window's, wheels less gyro";
    feed(off, 20 * kWindow, step(true, 0, 0), noisy);
    EXPECT_EQ(off.window().lasting_rad, 0) << "it is forgotten";
}

TEST(MotionCheckTest, AllowsTheScaleErrorThatEverySkidHas) {
    EXPECT_EQ(after_a_window(step(true, 2, 1.75)), MotionState::driving);
    EXPECT_EQ(after_a_window(step(true, -2, -2.25)), MotionState::driving);
    EXPECT_EQ(after_a_window(step(true, 2, 1.6)), MotionState::slipping);
}

TEST(MotionCheckTest, SaysNothingAgainstASilentGyro) {
    EXPECT_EQ(after_a_window(step(false, 0, std::nullopt)), MotionState::standing);
    EXPECT_EQ(after_a_window(step(true, 1, std::nullopt)), MotionState::driving);
    MotionCheck check;
    feed(check, kWindow - 1, step(true, 1, 0));
    feed(check, 1, step(true, 1, std::nullopt));
    EXPECT_EQ(check.state(), MotionState::driving) << "half a window's turn proves nothing";
    EXPECT_EQ(check.window().gyro_turn_rad, 0);
}

/// Each source of doubt by itself: just inside and just outside what it explains.
TEST(MotionCheckTest, ToleratesWhatBiasNoiseAndTicksExplain) {
    constexpr double turn = 0.1, rate = turn / 0.5;  // of a window
    const auto state = [&](double noise, double bias, double tick) {
        return after_a_window(step(false, 0, rate),
                              {noise * noise / 0.5, bias * bias / 0.25, tick});
    };
    EXPECT_EQ(state(0, 0, 0), MotionState::lifted);
    for (const double rather : {1.05, 0.95}) {
        const MotionState expected = rather > 1 ? MotionState::standing : MotionState::lifted;
        EXPECT_EQ(state(rather * turn / 4.5, 0, 0), expected) << "noise of the gyro";
        EXPECT_EQ(state(0, rather * turn / 4.5, 0), expected) << "its bias";
        EXPECT_EQ(state(0, 0, rather * turn / 2), expected) << "ticks of both wheels";
    }
    RotationStep rough = step(true, 0, rate);
    rough.wheel_variance = 1.05 * 1.05 * turn * turn / 4.5 / 4.5 / kWindow;
    EXPECT_EQ(after_a_window(rough, {}), MotionState::driving) << "noise of the wheels";
    rough.wheel_variance /= 1.3;
    EXPECT_EQ(after_a_window(rough, {}), MotionState::slipping);
}

TEST(MotionCheckTest, CountsWindowsWithTheSameVerdictInARow) {
    MotionCheck check;
    std::vector<int> rows;
    const auto windows = [&](int n, const RotationStep& s) {
        for (int i = 0; i < n; ++i) {
            feed(check, kWindow, s);
            rows.push_back(check.window().in_a_row);
        }
    };
    windows(2, step(true, 0.5, 0.5));
    windows(3, step(true, 0.5, 0));
    windows(3, step(false, 0, 0));
    windows(2, step(false, 0, 0.5));
    windows(2, step(false, 0, 0));
    windows(1, step(true, 0, 0));
    windows(1, step(false, 0, 0));
    EXPECT_EQ(rows, (std::vector<int>{1, 2, 1, 2, 3, 1, 2, 3, 1, 2, 1, 2, 1, 1}));
}

TEST(MotionCheckTest, TakesALongStepAsAWindow) {
    MotionCheck check;
    RotationStep gap = step(true, 0, 0);
    gap.dt_s = 3;
    gap.wheel_turn_rad = 1;
    EXPECT_TRUE(check.add(gap, kTolerance));
    EXPECT_EQ(check.state(), MotionState::slipping);
    EXPECT_EQ(check.window().duration_s, 3);
}

}  // namespace
}  // namespace pilotage::test
