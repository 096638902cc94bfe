// A sender's clock on ours: delays only ever add, so the smallest difference of the last minute is
// the best.

#include "engine/clock_map.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random.hpp"
#include "support/units.hpp"

namespace pilotage::test {
namespace {

constexpr std::int64_t kYear = 365 * 24 * 3600 * kSecond;

/// Arrival of a message that was sent at a time of ours.
struct Sent {
    std::int64_t utime, received;
};

/// `seconds` of messages at 50 Hz with delays of 1 to 50 ms; the sender's clock is off and drifts.
template <typename Check>
void send_for(double seconds, double offset_us, double drift, unsigned seed, const Check& check) {
    Draw draw(seed);
    for (std::int64_t t = 0; t < std::llround(seconds * 1e6); t += 20'000) {
        const double delay = 1000 * draw.log_uniform(1, 50);
        const auto utime = t + std::llround(offset_us + drift * static_cast<double>(t));
        check(t, Sent{utime, t + std::llround(delay)});
    }
}

TEST(ClockMapTest, MapsToTheTimeOfSendingPlusTheSmallestDelay) {
    for (const double offset : {0.0, 3e6, -349 * 86400e6, 5e14}) {
        ClockMap clock;
        send_for(30, offset, 0, 1, [&](std::int64_t t, const Sent& sent) {
            const std::int64_t mapped = clock.map(sent.utime, sent.received);
            if (t > kSecond) {
                ASSERT_NEAR(static_cast<double>(mapped - t), 1000, 400) << "at " << t;
            }
            ASSERT_LE(mapped, sent.received) << "nothing is measured after it arrived";
        });
        EXPECT_NEAR(static_cast<double>(clock.offset_us()), -offset + 1000, 400);
    }
}

TEST(ClockMapTest, FollowsADriftOf50Ppm) {
    for (const double ppm : {50.0, -50.0}) {
        ClockMap clock;
        double worst = 0;
        send_for(600, 1e9, ppm * 1e-6, 2, [&](std::int64_t t, const Sent& sent) {
            const std::int64_t mapped = clock.map(sent.utime, sent.received);
            if (t > kSecond) worst = std::max(worst, std::abs(static_cast<double>(mapped - t)));
        });
        EXPECT_LT(worst, 5000) << "us: 50 ppm are 3 ms a minute, delays begin at 1 ms";
    }
}

TEST(ClockMapTest, FollowsAJumpForwardAtOnce) {
    ClockMap clock;
    send_for(10, 0, 0, 3,
             [&](std::int64_t, const Sent& s) { (void)clock.map(s.utime, s.received); });
    const std::int64_t mapped = clock.map(kYear + 10 * kSecond, 10 * kSecond + 2000);
    EXPECT_EQ(mapped, 10 * kSecond + 2000);
}

TEST(ClockMapTest, FollowsAJumpBackwardAfterAMinute) {
    ClockMap clock;
    send_for(10, 0, 0, 4,
             [&](std::int64_t, const Sent& s) { (void)clock.map(s.utime, s.received); });
    std::int64_t first_good = 0;
    send_for(100, -5e6, 0, 5, [&](std::int64_t t, const Sent& s) {
        const std::int64_t now = t + 10 * kSecond;
        const std::int64_t mapped = clock.map(s.utime + 10 * kSecond, s.received + 10 * kSecond);
        if (std::abs(mapped - now) < 5000 && first_good == 0) first_good = t;
    });
    EXPECT_GT(first_good, 0) << "never";
    EXPECT_LE(first_good, 61 * kSecond);
}

TEST(ClockMapTest, ForgetsWhatIsOlderThanAMinuteAlsoAfterASilence) {
    ClockMap clock;
    EXPECT_EQ(clock.map(100, 100), 100);
    EXPECT_EQ(clock.map(30 * kSecond, 30 * kSecond + 500), 30 * kSecond);
    EXPECT_EQ(clock.map(300 * kSecond, 300 * kSecond + 700), 300 * kSecond + 700);
    EXPECT_EQ(clock.offset_us(), 700);
}

TEST(ClockMapTest, WorksBeforeTheEpoch) {
    ClockMap clock;
    for (std::int64_t t = -200 * kSecond; t < -100 * kSecond; t += kSecond / 2)
        ASSERT_EQ(clock.map(t - 77, t), t) << "at " << t;
}

TEST(ClockMapTest, SaysZeroBeforeTheFirstMessage) {
    EXPECT_EQ(ClockMap().offset_us(), 0);
}

}  // namespace
}  // namespace pilotage::test
