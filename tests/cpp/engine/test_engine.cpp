// Messages in, messages out: what is published, what is said, and what is awaited.

#include <cmath>

#include "support/engines.hpp"
#include "support/journeys.hpp"

namespace pilotage::test {
namespace {

TEST(EngineTest, PublishesAPoseAtEachMotionSample) {
    Bench bench;
    for (int i = 0; i <= 100; ++i) bench.send("ENCODERS", encoders(i * 20'000, 10 * i, 10 * i, i));
    ASSERT_EQ(bench.poses.size(), 101U);
    EXPECT_EQ(bench.poses.back().utime, 2'000'000);
    EXPECT_NEAR(bench.poses.back().x, 1, 1e-9);
    EXPECT_NEAR(bench.poses.back().v, 0.5, 1e-9);
    EXPECT_EQ(bench.poses.back().status, status_t::INITIALIZING);
    EXPECT_GT(bench.poses.back().covariance[0], bench.poses.front().covariance[0]);
    bench.send("ENCODERS", encoders(1'990'000, 995, 995, 101));
    EXPECT_EQ(bench.poses.size(), 101U) << "stamps never go back";
}

TEST(EngineTest, ReportsEachSighting) {
    Bench bench;
    bench.send("ENCODERS", encoders(0, 0, 0));
    bench.send("MARKERS", frame(10'000, "camera", {seen(1, 0.3, NAN, 6.1), seen(9, 0.1)}, 33));
    EXPECT_TRUE(bench.reports.empty());
    bench.send("ENCODERS", encoders(20'000, 0, 0));
    ASSERT_EQ(bench.reports.size(), 2U);
    const marker_report_t& taken = bench.reports[0];
    EXPECT_TRUE(taken.accepted);
    EXPECT_EQ(taken.utime, 10'000);
    EXPECT_EQ(taken.sensor, "camera");
    EXPECT_EQ(taken.frame_seq, 33);
    EXPECT_EQ(taken.index, 0);
    EXPECT_EQ(taken.id, 1);
    EXPECT_EQ(taken.dof, 2);
    EXPECT_NEAR(taken.innovation[0], 0.3 - std::atan2(2, 6), 1e-12);
    EXPECT_TRUE(std::isnan(taken.innovation[1]));
    EXPECT_EQ(taken.revision, 0);
    const marker_report_t& unknown = bench.reports[1];
    EXPECT_FALSE(unknown.accepted);
    EXPECT_EQ(unknown.reason, "unknown_marker");
    EXPECT_EQ(unknown.index, 1);
}

TEST(EngineTest, ReportsARejectionWithValueLimitAndUnit) {
    Bench bench;
    for (int i = 0; i <= 200; ++i) bench.send("ENCODERS", encoders(i * 20'000, 0, 0, i));
    bench.send("MARKERS", frame(1'000'000, "camera", {seen(1, 0.3)}));
    ASSERT_EQ(bench.reports.size(), 1U);
    EXPECT_EQ(bench.reports[0].reason, "late");
    EXPECT_EQ(bench.reports[0].value, 3);
    EXPECT_EQ(bench.reports[0].limit, 2);
    EXPECT_EQ(bench.reports[0].unit, "s");
}

TEST(EngineTest, ListensToItsChannels) {
    Bench plain;
    EXPECT_EQ(plain.engine().channels(),
              (std::set<std::string>{"ENCODERS", "GYRO", "MARKERS", "POSE_RESET"}));
    Bench own("encoders: {channel: WHEELS}\ngyro: {channel: IMU}\n");
    EXPECT_EQ(own.engine().channels(),
              (std::set<std::string>{"IMU", "MARKERS", "POSE_RESET", "WHEELS"}));
    Bench speeds("", R"(
motion: {source: velocity}
sensors: {camera: {channel: CAMERA}, scanner: {channel: SCANNER}}
)");
    EXPECT_EQ(speeds.engine().channels(),
              (std::set<std::string>{"CAMERA", "GYRO", "POSE_RESET", "SCANNER", "VELOCITY"}));
}

TEST(EngineTest, SaysWhatItWaitsFor) {
    Bench bench("", "motion: {heading: gyro}\nsensors: {camera: {}}\n");
    EXPECT_EQ(bench.engine().waiting_for(),
              "markers enough to find the pose (or pose_reset_t on POSE_RESET, or initial: in the "
              "configuration), "
              "encoders_t on ENCODERS, gyro_t on GYRO, marker_frame_t on MARKERS");
    bench.send("GYRO", gyro(0, 0));
    bench.send("POSE_RESET", reset(0, 1, 2, 3));
    EXPECT_EQ(bench.engine().waiting_for(), "encoders_t on ENCODERS, marker_frame_t on MARKERS");
    bench.send("ENCODERS", encoders(1, 0, 0));
    bench.send("MARKERS", frame(2, "camera", {}));
    EXPECT_EQ(bench.engine().waiting_for(), "");
}

TEST(EngineTest, TellsItsStateAtEveryTick) {
    Bench bench;
    bench.engine().tick(5, 3);
    ASSERT_EQ(bench.statuses.size(), 1U);
    EXPECT_EQ(bench.statuses[0].state, status_t::WAITING);
    EXPECT_EQ(bench.statuses[0].reason, "waiting for " + bench.engine().waiting_for());
    EXPECT_EQ(bench.statuses[0].drops, 3);
    EXPECT_EQ(bench.statuses[0].since, 5);
    bench.send("ENCODERS", encoders(7, 0, 0));
    bench.engine().tick(10, 3);
    EXPECT_EQ(bench.statuses[1].state, status_t::INITIALIZING);
    EXPECT_EQ(bench.statuses[1].since, 10);
    bench.engine().tick(20, 3);
    EXPECT_EQ(bench.statuses[2].since, 10) << "the state is the same";
    bench.engine().tick(15, 3);
    EXPECT_EQ(bench.statuses[3].utime, 15) << "our clock was set back";
    bench.send_bytes(kTickChannel, bytes_of(tick(30, 4)));
    ASSERT_EQ(bench.statuses.size(), 5U) << "a recorded tick is a tick";
    EXPECT_EQ(bench.statuses[4].utime, 30);
    EXPECT_EQ(bench.statuses[4].drops, 4);
}

TEST(EngineTest, TellsHowNoisyItsInputsAre) {
    for (const bool adapts : {false, true}) {
        Bench bench(adapts ? "noise: {adaptation: on}\n" : "");
        Journey journey(kPlainMap);
        journey.noise = 2;
        bench.run(journey.go(60, 0.2, 0.1));
        EXPECT_NEAR(bench.input("MARKERS", journey.utime).noise_scale, adapts ? 2 : 1, 0.3);
        EXPECT_EQ(bench.input("ENCODERS", journey.utime).noise_scale == 1, !adapts);
        EXPECT_EQ(bench.input("GYRO", journey.utime).noise_scale, 1) << "of the motion it is one";
    }
}

TEST(EngineTest, TakesTwoSensorsOnOneChannelByTheirNames) {
    Bench bench("", R"(
motion: {heading: wheels}
initial: {x_m: 0, y_m: 0, heading_rad: 0}
sensors: {left: {yaw_rad: 1.5}, right: {yaw_rad: -1.5}}
map: [{id: 1, x: 0, y: 5}, {id: 2, x: 0, y: -5}]
)");
    bench.send("ENCODERS", encoders(0, 0, 0));
    bench.send("MARKERS", frame(1, "right", {seen(2, 1.5 - 1.5707963)}));
    bench.send("MARKERS", frame(2, "left", {seen(1, 1.5707963 - 1.5)}));
    bench.send("MARKERS", frame(3, "rigth", {seen(1, 0)}));
    bench.send("ENCODERS", encoders(20'000, 0, 0));
    ASSERT_EQ(bench.reports.size(), 2U);
    EXPECT_EQ(bench.reports[0].sensor, "right");
    EXPECT_EQ(bench.reports[1].sensor, "left");
    for (const marker_report_t& report : bench.reports)
        EXPECT_NEAR(report.innovation[0], 0, 1e-6) << report.sensor;
    EXPECT_EQ(bench.engine().inputs()[0].count(Verdict::fused), 1);
    EXPECT_EQ(bench.engine().inputs()[1].count(Verdict::fused), 1);
    EXPECT_EQ(bench.engine().inputs()[0].count(MessageFault::unknown_sensor), 1);
}

TEST(EngineTest, UsesSixStatesWhereACalibrationMayMove) {
    Bench frozen, moving("calibration: {distance_scale: {sigma: 0.1}}\n");
    for (Bench* bench : {&frozen, &moving}) {
        bench->send("ENCODERS", encoders(0, 0, 0));
        bench->send("ENCODERS", encoders(1'000'000, 1000, 1000));
    }
    EXPECT_NEAR(moving.poses[1].covariance[0] - frozen.poses[1].covariance[0], 0.01, 1e-9)
        << "a metre with a scale of 10 %";
}

TEST(EngineTest, PublishesOnTheConfiguredChannels) {
    struct Names final : EngineOutput {
        std::set<std::string> channels;
        void message(const std::string& channel, const std::uint8_t*, std::size_t) override {
            channels.insert(channel);
        }
    } names;
    const std::string more = "output: {pose: P, report: R, status: S, odometry: O}\n";
    Engine engine(parse_config(kPlainRobot + more, "bench", ""), names);
    const Bytes motion = bytes_of(encoders(0, 0, 0)),
                bad = bytes_of(frame(0, "camera", {seen(1, NAN)}));
    engine.handle("ENCODERS", 0, motion.data(), motion.size());
    engine.handle("MARKERS", 0, bad.data(), bad.size());
    engine.tick(0, 0);
    EXPECT_EQ(names.channels, (std::set<std::string>{"O", "P", "R", "S"}));
}

TEST(EngineTest, GivesWhatWaitsItsVerdictAtTheEnd) {
    Bench bench;
    bench.send("ENCODERS", encoders(0, 0, 0));
    bench.send("MARKERS", frame(1, "camera", {seen(1, 0.3)}));
    EXPECT_EQ(bench.input("MARKERS").pending, 1);
    bench.engine().finish();
    EXPECT_EQ(bench.input("MARKERS").pending, 0);
    EXPECT_EQ(count_of(bench.input("MARKERS"), "no_motion"), 1);
    EXPECT_EQ(bench.reports.at(0).reason, "no_motion");
}

}  // namespace
}  // namespace pilotage::test
