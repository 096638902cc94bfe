// An input: dates its messages by the configured clock, and counts what became of them.

#include "engine/input.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pilotage::test {
namespace {

Input input_with(TimePolicy time, double latency_s) {
    return {"camera", {"MARKERS", time, latency_s}, Kind::frame, 0};
}

TEST(InputTest, DatesByTheSendersStampLessTheLatency) {
    EXPECT_EQ(input_with(TimePolicy::utime, 0).date(1000, 0, 77).utime, 1000);
    EXPECT_EQ(input_with(TimePolicy::utime, 0.065).date(100'000, 0, 77).utime, 35'000);
    EXPECT_EQ(input_with(TimePolicy::utime, -0.2).date(100'000, 0, 77).utime, 300'000);
}

TEST(InputTest, DatesByTheArrivalLessTheLatency) {
    EXPECT_EQ(input_with(TimePolicy::receive, 0).date(1000, 0, 77).utime, 77);
    EXPECT_EQ(input_with(TimePolicy::receive, 0.03).date(0, 0, 100'000).utime, 70'000);
    EXPECT_EQ(input_with(TimePolicy::receive, -0.03).date(0, 0, 100'000).utime, 130'000);
}

TEST(InputTest, DatesByTheMappedStampLessTheLatency) {
    Input input = input_with(TimePolicy::mapped, 0.01);
    EXPECT_EQ(input.date(5'000'000, 0, 1'000'000).utime, 990'000);
    EXPECT_EQ(input.date(5'020'000, 0, 1'090'000).utime, 1'010'000) << "70 ms of delay taken out";
    EXPECT_EQ(input.status(0).clock_offset_us, -4'000'000);
}

TEST(InputTest, MeasuresTheClockOffsetUnderEveryPolicy) {
    for (const TimePolicy time : {TimePolicy::utime, TimePolicy::receive, TimePolicy::mapped}) {
        Input input = input_with(time, 0);
        (void)input.date(1'000, 0, 501'000);
        EXPECT_EQ(input.status(0).clock_offset_us, 500'000);
    }
}

TEST(InputTest, DatesAnyStampsWithoutOverflow) {
    constexpr std::int64_t low = std::numeric_limits<std::int64_t>::min();
    constexpr std::int64_t high = std::numeric_limits<std::int64_t>::max();
    for (const TimePolicy time : {TimePolicy::utime, TimePolicy::receive, TimePolicy::mapped})
        for (const double latency : {0.0, 1e6, -1e6}) {
            Input input = input_with(time, latency);
            for (const std::int64_t utime : {low, low / 2, std::int64_t{0}, high / 2, high})
                for (const std::int64_t received : {low, std::int64_t{0}, high}) {
                    (void)input.date(utime, 0, received);
                    input.received(received, 0, 1);
                    (void)input.status(high);
                    (void)input.status(low);
                }
        }
}

TEST(InputTest, ByArrivalDoesNotCareForTheStamp) {
    for (const std::int64_t utime :
         {std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()})
        EXPECT_EQ(input_with(TimePolicy::receive, 0.001).date(utime, 0, 5'000).utime, 4'000);
}

TEST(InputTest, CountsEverySampleOnce) {
    Input input = input_with(TimePolicy::utime, 0);
    input.received(0, 0, 3);
    input.received(1, 1, 0);  // an empty frame
    input.fault(MessageFault::malformed);
    input.fault(MessageFault::malformed);
    input.fault(MessageFault::unknown_sensor);
    input.judged(Verdict::pending, Verdict::fused);
    input.judged(Verdict::pending, Verdict::gate);
    input.judged(Verdict::fused, Verdict::gate);
    const input_status_t s = input.status(1);
    EXPECT_EQ(s.channel, "MARKERS");
    EXPECT_EQ(s.received, 6);
    EXPECT_EQ(s.fused, 0);
    EXPECT_EQ(s.pending, 1);
    ASSERT_EQ(s.n_rejected, 3);
    EXPECT_EQ(s.rejected[0].reason, "gate");
    EXPECT_EQ(s.rejected[0].count, 2);
    EXPECT_EQ(s.rejected[1].reason, "malformed");
    EXPECT_EQ(s.rejected[1].count, 2);
    EXPECT_EQ(s.rejected[2].reason, "unknown_sensor");
    EXPECT_EQ(s.rejected[2].count, 1);
}

TEST(InputTest, SeesLossesInTheSequence) {
    Input input = input_with(TimePolicy::utime, 0);
    for (const int seq : {5, 6, 9, 10}) input.received(seq, seq, 1);
    EXPECT_EQ(input.status(0).lost, 2);
    for (const int seq : {0, 1, 2}) input.received(seq, seq, 1);
    EXPECT_EQ(input.status(0).lost, 2) << "a sender that starts again has lost nothing";
}

TEST(InputTest, KnowsRateAndAge) {
    Input input = input_with(TimePolicy::utime, 0);
    EXPECT_TRUE(std::isnan(input.status(0).rate_hz));
    EXPECT_TRUE(std::isnan(input.status(0).age_s));
    for (int i = 0; i <= 100; ++i) input.received(i * 20'000, i, 1);
    EXPECT_NEAR(input.status(0).rate_hz, 50, 1e-6);
    EXPECT_NEAR(input.status(2'500'000).age_s, 0.5, 1e-9);
    for (int i = 0; i <= 200; ++i) input.received(2'000'000 + i * 100'000, 101 + i, 1);
    EXPECT_NEAR(input.status(0).rate_hz, 10, 0.1);
}

TEST(InputTest, HasAFiniteRateWhenEverythingArrivesAtOnce) {
    Input input = input_with(TimePolicy::utime, 0);
    for (int i = 0; i < 100'000; ++i) input.received(i < 2 ? i : 1, i, 1);
    EXPECT_FALSE(std::isinf(input.status(1).rate_hz));
}

}  // namespace
}  // namespace pilotage::test
