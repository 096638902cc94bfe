// A sender's stamps against our clock: what a delay explains, what a set clock, and what nothing.

#include "engine/sender_clock.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/units.hpp"

namespace pilotage::test {
namespace {

using Stamp = SenderClock::Stamp;

constexpr std::int64_t kOff = 1'234'567'890;  // of the sender's clock behind ours

/// A sender of 50 messages a second.
struct ClockSender {
    static constexpr std::int64_t kPeriod = 20'000;

    SenderClock clock;
    std::int64_t now = 10 * kSecond, delay = 1000, off = kOff;
    std::int32_t seq = 0;
    double fast_ppm = 0;

    Stamp send() { return send(stamp()); }
    Stamp send(std::int64_t utime) {
        const Stamp stamp = clock.look(utime, seq++, now + delay);
        now += kPeriod;
        return stamp;
    }
    [[nodiscard]] std::int64_t stamp() const {
        return now - off + std::llround(1e-6 * fast_ppm * static_cast<double>(now - 10 * kSecond));
    }
    /// \return how many of so many seconds' messages were stamped like that
    int run(double seconds, Stamp which = Stamp::good) {
        int count = 0;
        for (int i = 0; i < std::lround(50 * seconds); ++i) count += send() == which ? 1 : 0;
        return count;
    }
};

TEST(SenderClockTest, HealthyStampsAreGoodWhateverTheOffset) {
    for (const std::int64_t off : {std::int64_t{0}, kOff, -kOff, std::int64_t{1} << 55}) {
        ClockSender sender;
        sender.off = off;
        EXPECT_EQ(sender.run(100), 5000);
        EXPECT_EQ(sender.clock.offset_us(), off + 1000);
        EXPECT_EQ(sender.clock.mapped(sender.stamp()), sender.now + 1000);
        EXPECT_EQ(sender.clock.steps(), 0);
        EXPECT_EQ(sender.clock.repeated(), 0);
    }
}

TEST(SenderClockTest, AFastReplayOfRareMessagesIsNoJump) {
    SenderClock clock;
    std::int64_t stamp = kOff, received = 10 * kSecond;
    for (int i = 0; i < 2000; ++i) {
        EXPECT_EQ(clock.look(stamp, i, received), Stamp::good) << "message " << i;
        const std::int64_t pause = (i % 7 == 0 ? 20 : 2) * kSecond;
        stamp += pause;
        received += pause / 50;
    }
}

TEST(SenderClockTest, AJumpAheadIsToldHoweverRareTheMessages) {
    SenderClock clock;
    std::int64_t now = 10 * kSecond;
    for (int i = 0; i < 20; ++i, now += 2 * kSecond)
        EXPECT_EQ(clock.look(now - kOff, i, now), Stamp::good);
    EXPECT_EQ(clock.look(now - kOff + kSecond, 20, now), Stamp::jumped);
}

TEST(SenderClockTest, DelaysOfAnyTwoSecondsAreGood) {
    ClockSender sender;
    for (int i = 0; i < 5000; ++i) {
        sender.delay = 1000 + (i * 7919LL) % (2 * kSecond);
        EXPECT_EQ(sender.send(), Stamp::good) << "message " << i;
    }
}

TEST(SenderClockTest, AForwardJumpIsHeldBackForASecondAndThenFollowed) {
    ClockSender sender;
    sender.run(5);
    sender.off -= 10 * kSecond;
    EXPECT_EQ(sender.run(1, Stamp::jumped), 50);
    EXPECT_EQ(sender.clock.offset_us(), kOff + 1000) << "nothing of it is left so far";
    EXPECT_EQ(sender.clock.jump_us(), -10 * kSecond) << "ahead of the others";
    EXPECT_EQ(sender.send(), Stamp::followed);
    EXPECT_EQ(sender.clock.steps(), 1);
    EXPECT_EQ(sender.clock.offset_us(), kOff - 10 * kSecond + 1000);
    EXPECT_EQ(sender.run(5), 250);
}

TEST(SenderClockTest, ABackwardJumpIsHeldBackAndThenFollowed) {
    for (const std::int64_t jump : {kSecond / 2, 2 * kSecond, 10 * kSecond, 3600 * kSecond}) {
        ClockSender sender;
        sender.run(5);
        sender.off += jump;
        EXPECT_EQ(sender.run(1, Stamp::jumped), 50) << jump;
        EXPECT_EQ(sender.send(), Stamp::followed) << jump;
        EXPECT_EQ(sender.clock.offset_us(), kOff + jump + 1000);
        EXPECT_EQ(sender.run(5), 250);
        EXPECT_EQ(sender.clock.steps(), 1);
    }
}

TEST(SenderClockTest, SingleWildStampsAreHeldBackAndLeaveNothing) {
    ClockSender sender;
    sender.run(5);
    for (const std::int64_t wild : {10 * kSecond, -10 * kSecond, 3600 * kSecond, kSecond / 2}) {
        EXPECT_EQ(sender.send(sender.stamp() + wild), Stamp::jumped) << wild;
        EXPECT_EQ(sender.run(0.3), 15) << "after " << wild;
    }
    EXPECT_EQ(sender.clock.steps(), 0);
    EXPECT_EQ(sender.clock.offset_us(), kOff + 1000);
}

/// Every third stamp is from another world, for a minute.
TEST(SenderClockTest, OftenWildStampsAreNeverFollowed) {
    ClockSender sender;
    sender.run(5);
    for (int i = 0; i < 3000; ++i) {
        const bool wild = i % 3 == 0;
        const Stamp stamp = sender.send(sender.stamp() + (wild ? 7 * kSecond : 0));
        ASSERT_EQ(stamp, wild ? Stamp::jumped : Stamp::good) << "message " << i;
    }
    EXPECT_EQ(sender.clock.steps(), 0);
}

/// A delay that stays looks like a clock set back, but seq and stamps go on.
TEST(SenderClockTest, AConstantDelayFromNowOnIsNoJump) {
    for (const std::int64_t delay : {kSecond / 5, kSecond / 2, 2 * kSecond}) {
        ClockSender sender;
        sender.run(5);
        sender.now += delay;  // nothing came meanwhile
        sender.off += delay;
        EXPECT_EQ(sender.run(20), 1000) << delay;
        EXPECT_EQ(sender.clock.steps(), 0);
        EXPECT_EQ(sender.clock.offset_us(), kOff + 1000) << "the fastest of the last minute";
    }
}

/// Messages overtake each other on the way: that their seq goes back with the stamp excuses them.
TEST(SenderClockTest, AMessageThatWasOvertakenIsGood) {
    ClockSender sender;
    sender.run(5);
    const std::int64_t utime = sender.stamp();
    const std::int32_t seq = sender.seq;
    sender.now += kSecond;
    sender.seq += 50;
    sender.run(1);
    EXPECT_EQ(sender.clock.look(utime, seq, sender.now), Stamp::good);
    EXPECT_EQ(sender.send(), Stamp::good);
}

TEST(SenderClockTest, AStandingStampIsMeasured) {
    ClockSender sender;
    sender.run(5);
    EXPECT_EQ(sender.clock.still_us(), 0);
    const std::int64_t stuck = sender.stamp();
    for (int i = 0; i < 100; ++i) (void)sender.send(stuck);
    EXPECT_NEAR(static_cast<double>(sender.clock.still_us()), 2e6, 2.0 * ClockSender::kPeriod);
    EXPECT_EQ(sender.clock.repeated(), 99);
    EXPECT_EQ(sender.clock.steps(), 0);
    (void)sender.send();
    EXPECT_EQ(sender.clock.still_us(), 0);
}

TEST(SenderClockTest, RepeatsAreCounted) {
    ClockSender sender;
    for (int i = 0; i < 100; ++i) {
        const std::int64_t utime = sender.stamp();
        (void)sender.send(utime);
        if (i % 10 != 0) continue;
        EXPECT_EQ(sender.send(utime), Stamp::good) << "20 ms late is no jump";
    }
    EXPECT_EQ(sender.clock.repeated(), 10);
}

TEST(SenderClockTest, SkewIsMeasuredAndNoJump) {
    for (const double ppm : {50.0, -50.0, 2000.0, -2000.0}) {
        ClockSender sender;
        sender.fast_ppm = ppm;
        EXPECT_TRUE(std::isnan(sender.clock.skew_ppm()));
        EXPECT_EQ(sender.run(10), 500);
        EXPECT_TRUE(std::isnan(sender.clock.skew_ppm())) << "too early to tell";
        EXPECT_EQ(sender.run(120), 6000);
        EXPECT_NEAR(sender.clock.skew_ppm(), -ppm, 0.05 * std::abs(ppm)) << "positive: slow";
        EXPECT_EQ(sender.clock.steps(), 0);
    }
}

/// Before anything is known of a sender it is believed.
TEST(SenderClockTest, TheFirstSecondIsGood) {
    ClockSender sender;
    EXPECT_EQ(sender.send(sender.stamp() + 100 * kSecond), Stamp::good);
    EXPECT_EQ(sender.run(0.9), 45);
}

TEST(SenderClockTest, StampsOfNoClockAreNeverGood) {
    ClockSender sender;
    sender.run(5);
    for (const std::int64_t utime :
         {std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()})
        EXPECT_EQ(sender.send(utime), Stamp::jumped);
    EXPECT_EQ(sender.run(1), 50);
}

}  // namespace
}  // namespace pilotage::test
