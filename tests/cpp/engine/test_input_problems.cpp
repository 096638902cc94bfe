// What an input's review finds wrong with it, in the words that a person reads.

#include "engine/input.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/units.hpp"

namespace pilotage::test {
namespace {

/// An input with its sender: fifty messages a second, a review every second.
struct InputSender {
    Input input;
    std::int64_t now = 100 * kSecond, off = 0;
    std::int32_t seq = 0;
    double speed = 1;  // of its clock against ours
    Verdict verdict = Verdict::fused;
    bool standing = false, needed = true;
    std::int64_t stood_at = 0;

    explicit InputSender(Kind kind = Kind::encoders, TimePolicy time = TimePolicy::utime)
        : input("it", {"CHANNEL", time, 0}, kind, kind == Kind::frame ? 0 : -1) {}

    void send() {
        now += 20'000;
        if (!standing)
            stood_at = std::llround(speed * static_cast<double>(now - 100 * kSecond)) - off;
        const Input::Date date = input.date(stood_at, seq, now);
        input.received(now, seq++, 1);
        input.judged(Verdict::pending, date.good ? verdict : Verdict::clock);
    }
    /// \return what the review after so many seconds says
    std::string go(int seconds = 3) {
        for (int i = 0; i < 50 * seconds; ++i) {
            send();
            if (i % 50 == 49) (void)input.review(now, needed);
        }
        return input.problem();
    }
    std::string wait(double seconds) {
        now += static_cast<std::int64_t>(seconds * kSecond);
        return input.review(now, needed);
    }
};

bool begins(const std::string& text, const std::string& with) {
    return text.rfind(with, 0) == 0;
}

TEST(InputProblemTest, AHealthyInputHasNone) {
    for (const TimePolicy time : {TimePolicy::utime, TimePolicy::receive, TimePolicy::mapped}) {
        InputSender sender(Kind::encoders, time);
        EXPECT_EQ(sender.input.review(sender.now, true), "") << "not yet heard of is no problem";
        EXPECT_EQ(sender.go(100), "");
        EXPECT_EQ(sender.input.status(sender.now).problem, "");
    }
}

TEST(InputProblemTest, SilenceIsOneWhereItIsNeededAndEndsWithAMessage) {
    InputSender sender;
    sender.go();
    EXPECT_EQ(sender.wait(0.5), "");
    EXPECT_EQ(sender.wait(0.6), "silent for 1.1 s");
    EXPECT_EQ(sender.input.status(sender.now).problem, "silent for 1.1 s");
    EXPECT_EQ(sender.wait(9), "silent for 10.1 s");
    EXPECT_EQ(sender.go(), "");
    sender.needed = false;
    EXPECT_EQ(sender.wait(100), "");
}

TEST(InputProblemTest, ASlowSenderIsNotSilentBetweenItsMessages) {
    InputSender sender;
    for (int i = 0; i < 20; ++i) {
        sender.now += kSecond;
        sender.send();
        const std::string problem = sender.wait(0.9);
        if (i == 0) continue;  // of one message nobody knows the rate
        EXPECT_EQ(problem, "") << "at one message in two seconds";
    }
    EXPECT_NE(sender.wait(10), "");
}

TEST(InputProblemTest, RejectionsAreNamedWithTheirCount) {
    InputSender sender(Kind::frame);
    sender.go();
    sender.verdict = Verdict::unknown_marker;
    EXPECT_EQ(sender.go(), "50 of 50 rejected: unknown_marker");
    sender.verdict = Verdict::fused;
    EXPECT_EQ(sender.go(), "");
    for (int i = 0; i < 10; ++i) sender.send();
    sender.input.fault(MessageFault::malformed);
    EXPECT_EQ(sender.wait(0), "") << "one of eleven is no problem yet";
    for (int i = 0; i < 5; ++i) sender.input.fault(MessageFault::wrong_type);
    EXPECT_EQ(sender.wait(0), "5 of 5 rejected: wrong_type");
}

TEST(InputProblemTest, TheMostFrequentReasonIsNamed) {
    InputSender sender(Kind::frame);
    sender.go();
    for (int i = 0; i < 30; ++i) {
        sender.verdict = i % 3 == 0 ? Verdict::late : Verdict::gate;
        sender.send();
    }
    EXPECT_EQ(sender.wait(0), "30 of 30 rejected: gate");
}

TEST(InputProblemTest, AJumpOfTheStampsIsNamedAndThenThatTheClockWasSet) {
    for (const double jump : {10.0, -10.0}) {
        SCOPED_TRACE(jump);
        InputSender sender;
        sender.go();
        sender.off -= static_cast<std::int64_t>(jump * kSecond);
        const std::string size = jump > 0 ? "10.000 s" : "-10.000 s";
        for (int i = 0; i < 10; ++i) sender.send();
        EXPECT_EQ(sender.wait(0), "stamps jump by " + size);
        for (int i = 0; i < 60; ++i) sender.send();
        EXPECT_EQ(sender.wait(0), "its clock was set, by " + size);
        EXPECT_EQ(sender.go(), "");
        EXPECT_EQ(sender.input.status(sender.now).clock_steps, 1);
    }
}

TEST(InputProblemTest, ByArrivalNoClockMatters) {
    InputSender sender(Kind::encoders, TimePolicy::receive);
    sender.go();
    sender.off = -10 * kSecond;
    EXPECT_EQ(sender.go(1), "");
    sender.standing = true;
    EXPECT_EQ(sender.go(), "");
}

TEST(InputProblemTest, AStandingStampIsNamed) {
    InputSender sender;
    sender.go();
    sender.standing = true;
    EXPECT_TRUE(begins(sender.go(2), "the stamp has stood still for 2.0 s"))
        << sender.input.problem();
}

TEST(InputProblemTest, RepeatedStampsAreNamed) {
    InputSender sender;
    sender.go();
    for (int i = 0; i < 50; ++i) {
        sender.standing = i % 10 == 9;
        sender.send();
    }
    EXPECT_EQ(sender.wait(0), "stamps repeat");
    sender.standing = false;
    EXPECT_EQ(sender.go(), "");
}

TEST(InputProblemTest, AClockThatRunsFastOrSlowIsNamed) {
    for (const double ppm : {2000.0, -2000.0}) {
        InputSender sender;
        sender.speed = 1 + 1e-6 * ppm;
        EXPECT_EQ(sender.go(20), "") << "too early to tell";
        const std::string problem = sender.go(60);
        EXPECT_TRUE(begins(problem, "its clock runs ")) << problem;
        EXPECT_NE(problem.find(ppm > 0 ? "ppm fast" : "ppm slow"), std::string::npos) << problem;
        EXPECT_NEAR(std::stod(problem.substr(15)), 2000, 100) << problem;
    }
    InputSender usual;
    usual.speed = 1 + 50e-6;
    EXPECT_EQ(usual.go(100), "") << "50 ppm every quartz has";
}

/// Sightings of several markers, of which some contradict.
std::string after_sightings(double bad_share, int bad_marker = 0) {
    InputSender sender(Kind::frame);
    sender.go();
    SightingReport report{};
    double owed = 0;
    for (int i = 0; i < 500; ++i) {
        report.verdict = Verdict::fused;
        report.id = 1 + i % 25;
        owed += bad_share;
        const bool bad = bad_marker > 0 ? report.id == bad_marker : owed >= 1;
        if (owed >= 1) owed -= 1;
        report.agrees = !bad;
        sender.input.reported(report, 5);
    }
    return sender.go(1);
}

TEST(InputProblemTest, SightingsThatContradictThePoseAreNamed) {
    EXPECT_EQ(after_sightings(0), "");
    EXPECT_EQ(after_sightings(0.01), "") << "an outlier now and then is no problem";
    EXPECT_EQ(after_sightings(1), "100 % of the latest sightings contradict the pose");
    EXPECT_NE(after_sightings(0.6).find("of the latest sightings contradict the pose"),
              std::string::npos);
}

TEST(InputProblemTest, OneMarkerThatContradictsIsNamed) {
    EXPECT_NE(after_sightings(0, 7).find("marker 7"), std::string::npos) << after_sightings(0, 7);
}

/// Sightings that were not held against the pose say nothing of it.
TEST(InputProblemTest, RejectedSightingsAreNoContradiction) {
    InputSender sender(Kind::frame);
    sender.go();
    SightingReport report{};
    report.verdict = Verdict::unknown_marker;
    for (int i = 0; i < 100; ++i) sender.input.reported(report, 5);
    EXPECT_EQ(sender.go(1), "");
}

TEST(InputProblemTest, LostMessagesAreNamed) {
    InputSender sender;
    sender.go();
    for (int i = 0; i < 50; ++i) {
        if (i % 5 == 0) ++sender.seq;
        sender.send();
    }
    EXPECT_EQ(sender.wait(0), "lost 10 messages, by gaps in seq");
    EXPECT_EQ(sender.go(), "");
}

TEST(InputProblemTest, ARateFarBelowTheUsualOneIsNamed) {
    InputSender sender;
    sender.go(60);
    for (int i = 0; i < 50; ++i) {
        sender.now += 80'000;  // 10 Hz instead of 50
        sender.send();
    }
    EXPECT_TRUE(begins(sender.wait(0), "slow: 10")) << sender.input.problem();
}

}  // namespace
}  // namespace pilotage::test
