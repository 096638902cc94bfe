// Each input on, off for eleven seconds and on again, and a jump of twenty metres: what the status
// says, what it blames, and that no sample gets lost in the books.

#include "support/engines.hpp"
#include "support/journeys.hpp"

namespace pilotage::test {
namespace {

constexpr double kOff_s = 11;

std::string robot(const std::string& heading = "gyro", const std::string& source = "encoders",
                  const std::string& camera = "{}") {
    return "motion: {heading: " + heading + ", source: " + source + R"(}
initial: {x_m: 0, y_m: 0, heading_rad: 0}
sensors: {camera: )" +
           camera + R"(}
map:
- {id: 1, x: 6, y: 2, z: 0.4}
- {id: 2, x: -3, y: 5, z: 0.3}
- {id: 3, x: 4, y: -4, z: 0.2}
)";
}

/// A robot in the circle that it drives, and its engine.
struct Trial {
    Journey journey{kAroundOrigin};
    Bench bench;

    explicit Trial(const std::string& config = robot()) : bench("", config) {}

    void go(double seconds, double v = 0.2, double omega = 0.1) {
        bench.run(journey.go(seconds, v, omega));
        bench.wait(journey.utime);
    }
    [[nodiscard]] const status_t& status() const { return bench.statuses.back(); }
    [[nodiscard]] int state() const { return status().state; }
    [[nodiscard]] std::string problem(const std::string& name) const {
        for (const input_status_t& input : status().inputs)
            if (input.name == name) return input.problem;
        return "no input " + name;
    }
    [[nodiscard]] bool says(const std::string& text) const {
        return status().reason.find(text) != std::string::npos;
    }
    [[nodiscard]] Pose<double> pose() const {
        const pose_t& p = bench.poses.back();
        return {p.x, p.y, p.heading};
    }
    void expect_well(const std::string& when) {
        SCOPED_TRACE(when);
        EXPECT_EQ(state(), status_t::OK);
        EXPECT_EQ(status().reason, "");
        for (const input_status_t& input : status().inputs) EXPECT_EQ(input.problem, "");
        EXPECT_TRUE(same_pose(pose(), journey.truth, 0.2));
    }
    /// received = fused + pending + rejected, in every status so far, is checked by the bench.
    ~Trial() { EXPECT_GT(bench.statuses.size(), 10U); }
};

TEST(FusionLogicTest, WithoutSightingsThePoseIsNotOk) {
    Trial t;
    t.journey.camera = false;
    t.go(12);
    EXPECT_EQ(t.state(), status_t::INITIALIZING);
    EXPECT_TRUE(t.says("0 of the 3 sightings in a row that confirm the pose")) << t.status().reason;
    EXPECT_TRUE(t.says("waiting for marker_frame_t on MARKERS")) << t.status().reason;
}

TEST(FusionLogicTest, EncodersOffIsALossOfMotionAndOnAgainARecovery) {
    Trial t;
    t.go(11);
    t.expect_well("before");
    t.journey.encoders = false;
    t.go(2, 0, 0);
    EXPECT_EQ(t.state(), status_t::DEAD_RECKONING);
    EXPECT_TRUE(t.says("no motion for")) << t.status().reason;
    EXPECT_EQ(t.problem("encoders").substr(0, 10), "silent for");
    EXPECT_EQ(t.problem("gyro"), "") << "is not to blame";
    EXPECT_EQ(t.problem("camera"), "") << "is not to blame";
    t.go(kOff_s - 2, 0, 0);
    EXPECT_EQ(t.state(), status_t::LOST);
    EXPECT_TRUE(t.says("limit")) << t.status().reason;
    t.journey.encoders = true;
    t.go(11);
    t.expect_well("after");
    EXPECT_EQ(t.bench.jumps.size(), 0U) << "it had not moved";
}

TEST(FusionLogicTest, EncodersOffOnADriveIsFoundAgain) {
    Trial t;
    t.go(11);
    t.journey.encoders = false;
    t.go(kOff_s);
    EXPECT_NE(t.state(), status_t::OK);
    t.journey.encoders = true;
    t.go(15);
    t.expect_well("after");
}

TEST(FusionLogicTest, GyroOffIsNamedAndTheWheelsTurnMeanwhile) {
    Trial t;
    t.go(11);
    t.journey.gyro = false;
    t.go(kOff_s);
    EXPECT_EQ(t.state(), status_t::OK) << t.status().reason;
    EXPECT_EQ(t.problem("gyro").substr(0, 10), "silent for");
    EXPECT_TRUE(t.says("gyro: silent for")) << t.status().reason;
    EXPECT_TRUE(same_pose(t.pose(), t.journey.truth, 0.2));
    t.journey.gyro = true;
    t.go(11);
    t.expect_well("after");
    EXPECT_EQ(t.bench.jumps.size(), 0U);
}

TEST(FusionLogicTest, AGyroThatNobodyNeedsIsNotMissed) {
    Trial t(robot("wheels"));
    t.journey.gyro = false;
    t.go(11);
    t.expect_well("without");
}

TEST(FusionLogicTest, CameraOffIsDeadReckoningAndOnAgainOk) {
    Trial t;
    t.go(11);
    t.journey.camera = false;
    t.go(4);
    EXPECT_EQ(t.state(), status_t::OK) << "5 s are allowed";
    EXPECT_EQ(t.problem("camera").substr(0, 10), "silent for");
    t.go(kOff_s - 4);
    EXPECT_EQ(t.state(), status_t::DEAD_RECKONING);
    EXPECT_TRUE(t.says("no sighting that agrees for")) << t.status().reason;
    EXPECT_TRUE(t.says("limit 5.0 s")) << t.status().reason;
    EXPECT_TRUE(same_pose(t.pose(), t.journey.truth, 0.3)) << "the wheels carry it";
    t.journey.camera = true;
    t.go(2);
    t.expect_well("after");
    EXPECT_EQ(t.bench.jumps.size(), 0U);
}

/// Each component and mix of them is enough to be OK, and its silence is told.
TEST(FusionLogicTest, AnyComponentsOfTheMarkersConfirmAndAreMissed) {
    for (int bits = 1; bits < 8; ++bits) {
        SCOPED_TRACE(bits);
        Trial t;
        t.journey.bearing = bits & 1;
        t.journey.elevation = bits & 2;
        t.journey.range = bits & 4;
        t.journey.noise = 0.5;
        t.go(11);
        EXPECT_EQ(t.state(), status_t::OK) << t.status().reason;
        EXPECT_TRUE(same_pose(t.pose(), t.journey.truth, 0.5));
        EXPECT_EQ(t.bench.reports.back().dof, (bits & 1) + (bits >> 1 & 1) + (bits >> 2 & 1));
        t.journey.camera = false;
        t.go(kOff_s);
        EXPECT_EQ(t.state(), status_t::DEAD_RECKONING) << t.status().reason;
        t.journey.camera = true;
        t.go(11);
        EXPECT_EQ(t.state(), status_t::OK) << t.status().reason;
    }
}

/// The robot is set down elsewhere: the sightings jump by so much.
struct JumpTrial : Trial {
    int wrong_and_ok = 0;  ///< tenths of a second

    explicit JumpTrial(double metres) {
        go(11);
        EXPECT_EQ(state(), status_t::OK);
        journey.truth[kX] += metres;
        for (int i = 0; i < 200; ++i) {
            go(0.1, 0, 0);
            const bool right = same_pose(pose(), journey.truth, 0.25 * metres);
            wrong_and_ok += bench.poses.back().status == status_t::OK && !right ? 1 : 0;
        }
        go(20, 0.1, 0.1);
    }
};

TEST(FusionLogicTest, AJumpIsNotOkUntilItIsFollowedAndAnnounced) {
    for (const double metres : {1.0, 2.0, 3.0, 5.0, 7.0, 10.0}) {
        SCOPED_TRACE(metres);
        JumpTrial t(metres);
        EXPECT_LE(t.wrong_and_ok, 5);
        EXPECT_EQ(t.state(), status_t::OK) << t.status().reason;
        EXPECT_TRUE(same_pose(t.pose(), t.journey.truth, 0.3));
        EXPECT_FALSE(t.bench.jumps.empty());
        EXPECT_EQ(static_cast<int>(t.bench.jumps.size()), t.bench.poses.back().resets)
            << "every jump is counted and announced";
    }
}

/// Farther than the robot itself can find, it knows that it is lost, until a reset tells it more.
TEST(FusionLogicTest, AJumpOfTwentyMetresIsLostAndMendedByAReset) {
    JumpTrial t(20);
    EXPECT_LE(t.wrong_and_ok, 5);
    if (t.state() != status_t::OK) {
        EXPECT_EQ(t.state(), status_t::LOST);
        EXPECT_TRUE(t.says("contradict")) << t.status().reason;
        EXPECT_NE(t.problem("camera"), "");
        t.bench.run({reset_at(t.journey.utime + 1, t.journey.truth, {0.1, 0.1, 0.1})});
        t.go(11);
    }
    EXPECT_EQ(t.state(), status_t::OK);
    EXPECT_TRUE(same_pose(t.pose(), t.journey.truth, 0.3));
}

/// The camera alone is wrong, for a while.
TEST(FusionLogicTest, ACameraThatLiesForASecondDoesNotMoveThePoseMuch) {
    Trial t;
    t.go(11);
    t.journey.lie = {20, 0, 0};
    t.go(0.3);
    t.journey.lie = {0, 0, 0};
    t.go(11);
    t.expect_well("after");
    t.journey.lie = {20, 0, 0};
    t.go(3);
    EXPECT_NE(t.state(), status_t::OK) << "nobody can tell who is right";
    t.journey.lie = {0, 0, 0};
    t.go(30);
    EXPECT_EQ(t.state(), status_t::OK) << t.status().reason;
    EXPECT_TRUE(same_pose(t.pose(), t.journey.truth, 0.2));
}

TEST(FusionLogicTest, AResetTellsOfAMoveOfTwentyMetresAtOnce) {
    Trial t;
    t.go(11);
    t.journey.truth[kX] += 20;
    t.bench.run({reset_at(t.journey.utime + 1, t.journey.truth, {0.1, 0.1, 0.1})});
    t.go(0.1);
    EXPECT_EQ(t.bench.jumps.size(), 1U);
    EXPECT_EQ(t.bench.jumps[0].cause, "reset");
    EXPECT_NEAR(t.bench.jumps[0].after[0] - t.bench.jumps[0].before[0], 20, 0.2);
    t.go(3);
    t.expect_well("after");
    EXPECT_EQ(t.bench.poses.back().resets, 1);
    EXPECT_EQ(t.bench.jumps.size(), 1U) << "and is no correction as well";
}

TEST(FusionLogicTest, VelocityOffIsALossOfMotionAndOnAgainARecovery) {
    Trial t(robot("wheels", "velocity"));
    t.journey.encoders = t.journey.gyro = false;
    const auto go = [&](double seconds, double v, double omega, bool heard = true) {
        for (int i = 0; i < std::lround(50 * seconds); ++i) {
            const std::vector<Sample> seen = t.journey.go(0.02, v, omega);
            t.bench.wait(t.journey.utime);
            velocity_t m = velocity(t.journey.utime, v, omega);
            m.seq = t.journey.seq;
            if (heard) t.bench.send("VELOCITY", m);
            t.bench.run(seen);
        }
        t.bench.wait(t.journey.utime);
    };
    go(11, 0.2, 0.1);
    t.expect_well("before");
    go(2, 0.2, 0.1, false);
    EXPECT_EQ(t.state(), status_t::DEAD_RECKONING);
    EXPECT_TRUE(t.says("no motion for")) << t.status().reason;
    EXPECT_EQ(t.problem("velocity").substr(0, 10), "silent for");
    go(kOff_s - 2, 0.2, 0.1, false);
    EXPECT_EQ(t.state(), status_t::LOST);
    go(15, 0.2, 0.1);
    t.expect_well("after");
}

}  // namespace
}  // namespace pilotage::test
