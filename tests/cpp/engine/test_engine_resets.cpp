// A pose_reset_t: obeyed when the configuration says so, and answered in the status either way.

#include "support/engines.hpp"
#include "support/journeys.hpp"

namespace pilotage::test {
namespace {

/// An engine whose status is OK, or never got there.
struct ResetTrial {
    Bench bench;
    Journey journey{kPlainMap};

    ResetTrial(const std::string& accept, bool ok)
        : bench("pose_reset: {accept: " + accept + "}\n") {
        journey.camera = ok;
        bench.run(journey.go(4, 0.1, 0.1));
        bench.wait(journey.utime);
        EXPECT_EQ(bench.statuses.back().state, ok ? status_t::OK : status_t::INITIALIZING);
        EXPECT_EQ(bench.statuses.back().reset_seq, -1) << "there was none";
        EXPECT_EQ(bench.statuses.back().reset_answer, "");
    }
    /// \return the status after it
    status_t reset_to(double x, double y, std::int32_t seq, double variance = 0.01) {
        pose_reset_t message = reset(journey.utime + 1, x, y, 0.5, variance);
        message.seq = seq;
        bench.send("POSE_RESET", message);
        journey.camera = false;
        bench.run(journey.go(1.1, 0.1, 0));
        return bench.statuses.back();
    }
    [[nodiscard]] bool moved_to(double x, double y) const {
        return std::hypot(bench.poses.back().x - x, bench.poses.back().y - y) < 0.3;
    }
};

TEST(EngineResetTest, AlwaysIsObeyedInAnyState) {
    for (const bool ok : {true, false}) {
        ResetTrial robot("always", ok);
        const status_t status = robot.reset_to(10, -7, 42);
        EXPECT_TRUE(robot.moved_to(10, -7));
        EXPECT_EQ(status.reset_seq, 42);
        EXPECT_EQ(status.reset_answer, "accepted");
        EXPECT_EQ(status.state, status_t::INITIALIZING) << "a hypothesis again";
        EXPECT_EQ(status.resets, 1);
        EXPECT_EQ(robot.bench.input("POSE_RESET", robot.journey.utime).fused, 1);
    }
}

TEST(EngineResetTest, NotOkIsObeyedUnlessTheStatusIsOk) {
    ResetTrial lost("not_ok", false);
    EXPECT_EQ(lost.reset_to(10, -7, 1).reset_answer, "accepted");
    EXPECT_TRUE(lost.moved_to(10, -7));
    ResetTrial sure("not_ok", true);
    const status_t status = sure.reset_to(10, -7, 2);
    EXPECT_EQ(status.reset_seq, 2);
    EXPECT_EQ(status.reset_answer, "not_allowed");
    EXPECT_FALSE(sure.moved_to(10, -7));
    EXPECT_EQ(status.resets, 0);
    EXPECT_EQ(count_of(sure.bench.input("POSE_RESET", sure.journey.utime), "not_allowed"), 1);
}

TEST(EngineResetTest, NeverIsNeverObeyed) {
    for (const bool ok : {true, false}) {
        ResetTrial robot("never", ok);
        EXPECT_EQ(robot.reset_to(10, -7, 3).reset_answer, "not_allowed");
        EXPECT_FALSE(robot.moved_to(10, -7));
    }
    Bench waiting("pose_reset: {accept: never}\n",
                  "motion: {heading: wheels}\nmap: [{id: 1, x: 1, y: 1}]\n");
    waiting.send("POSE_RESET", reset(1, 1, 2, 3));
    EXPECT_EQ(count_of(waiting.input("POSE_RESET", 2), "not_allowed"), 1) << "nor as a start";
    EXPECT_EQ(waiting.statuses.back().state, status_t::WAITING);
}

TEST(EngineResetTest, ABadOneIsAnsweredWithItsReason) {
    ResetTrial robot("always", true);
    EXPECT_EQ(robot.reset_to(NAN, 0, 4).reset_answer, "bad_value");
    EXPECT_EQ(robot.reset_to(1, 1, 5, -1).reset_answer, "bad_value");
    EXPECT_EQ(robot.reset_to(1e9, 1, 6).reset_answer, "implausible");
    EXPECT_EQ(robot.bench.statuses.back().reset_seq, 6);
    EXPECT_EQ(robot.bench.statuses.back().resets, 0);
}

TEST(EngineResetTest, AnOldOneIsLate) {
    ResetTrial robot("always", true);
    pose_reset_t old = reset(100'000, 1, 1, 0);
    old.seq = 9;
    robot.bench.send("POSE_RESET", old, robot.journey.utime);
    robot.bench.run(robot.journey.go(1.1));
    EXPECT_EQ(robot.bench.statuses.back().reset_answer, "late");
    EXPECT_EQ(robot.bench.statuses.back().reset_seq, 9);
}

/// Until the motion sample after it nothing is decided, and the status does not pretend it was.
TEST(EngineResetTest, TheAnswerIsTheNewestOnes) {
    ResetTrial robot("always", true);
    EXPECT_EQ(robot.reset_to(10, -7, 1).reset_answer, "accepted");
    pose_reset_t next = reset(robot.journey.utime + 1, 1, 1, 0);
    next.seq = 2;
    robot.bench.send("POSE_RESET", next);
    robot.bench.engine().tick(robot.journey.utime + 2, 0);
    EXPECT_EQ(robot.bench.statuses.back().reset_seq, 2);
    EXPECT_EQ(robot.bench.statuses.back().reset_answer, "pending") << "not the one before's";
    robot.bench.run(robot.journey.go(1.1));
    EXPECT_EQ(robot.bench.statuses.back().reset_answer, "accepted");
}

TEST(EngineResetTest, TheStartIsAnsweredToo) {
    Bench bench("", "motion: {heading: wheels}\nmap: [{id: 1, x: 1, y: 1}]\n");
    pose_reset_t start = reset(1, 1, 2, 3);
    start.seq = 5;
    bench.send("POSE_RESET", start);
    bench.engine().tick(2, 0);
    EXPECT_EQ(bench.statuses.back().reset_seq, 5);
    EXPECT_EQ(bench.statuses.back().reset_answer, "accepted");
}

}  // namespace
}  // namespace pilotage::test
