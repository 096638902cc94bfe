// A whole recording through the engine, and the files that are written of it.

#include "engine/run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "engine/config_file.hpp"
#include "engine/text_table.hpp"
#include "support/engines.hpp"
#include "support/files.hpp"

namespace pilotage::test {
namespace {

using Replay = ::pilotage::Run;  // ::testing::Test has a Run of its own

Config plain_config() {
    return parse_config(kPlainRobot, "robot.yaml", "");
}

/// Two seconds with three frames, one of them late, one with an unknown marker.
Recording short_drive() {
    Recording recording;
    for (int i = 0; i <= 100; ++i)
        recording.add(i * 20'000, "ENCODERS", encoders(i * 20'000, 9 * i, 11 * i, i));
    recording.add(500'500, "MARKERS",
                  frame(500'000, "camera", {seen(1, 0.3, -0.1), seen(8, 0)}, 1));
    recording.add(1'000'500, "MARKERS", frame(1'000'000, "camera", {seen(2, -0.9, NAN, 5)}, 2));
    recording.add(1'500'500, "MARKERS", frame(700'000, "camera", {seen(1, 0.25)}, 3));
    recording.add(1'600'000, "REFERENCE", reference(1'600'000, 1, 2, 3));
    recording.sort();
    return recording;
}

TEST(RunTest, KeepsPosesReportsAndCounts) {
    Replay run(plain_config());
    run.replay(short_drive());
    EXPECT_EQ(run.messages(), 105);
    ASSERT_EQ(run.poses().size(), 101U);
    EXPECT_EQ(run.poses().back().utime, 2'000'000);
    EXPECT_EQ(run.poses().back().covariance[0][1], run.poses().back().covariance[1][0]);
    ASSERT_EQ(run.final_reports().size(), 4U);
    EXPECT_TRUE(run.notices().empty());
    EXPECT_EQ(run.published().size(), 0U) << "not kept unless asked for";
}

TEST(RunTest, GivesTheNewestReportOfEachSighting) {
    Replay run(plain_config());
    run.replay(short_drive());
    const std::vector<SightingReport> reports = run.final_reports();
    const std::int64_t times[] = {500'000, 500'000, 1'000'000, 700'000};
    const int revisions[] = {0, 0, 1, 0};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(reports[i].utime, times[i]) << "in the order of their first report";
        EXPECT_EQ(reports[i].revision, revisions[i]) << "row " << i;
    }
}

/// Beside a twin; that the other one was seen as well comes late, and tells which this is.
TEST(RunTest, ASightingWithoutIdStaysItselfWhenItsMarkerIsFoundLater) {
    Recording recording;
    for (int i = 0; i <= 100; ++i)
        recording.add(i * 20'000, "ENCODERS", encoders(i * 20'000, 0, 0, i));
    recording.add(500'500, "MARKERS", frame(500'000, "camera", {seen(-1, -0.785, NAN, 5.657)}, 1));
    recording.add(1'000'500, "MARKERS", frame(500'000, "camera", {seen(3, -0.797, NAN, 5.73)}, 1));
    recording.sort();
    Replay run(parse_config(std::string(kPlainRobot) + "- {id: 3, x: 4, y: -4.1}\n", "robot", ""));
    run.replay(recording);
    const std::vector<SightingReport> reports = run.final_reports();
    ASSERT_EQ(reports.size(), 2U);
    EXPECT_EQ(reports[0].id, 2);
    EXPECT_EQ(reports[0].revision, 1);
    EXPECT_EQ(reports[0].given_id, -1);
    EXPECT_EQ(reports[1].id, 3);
}

/// A copy that is refused says nothing of the sighting that it is a copy of: both have a row.
TEST(RunTest, ARefusedCopyDoesNotTakeTheSightingsPlace) {
    Recording recording = short_drive();
    const marker_frame_t again = frame(500'000, "camera", {seen(1, 0.3, -0.1)}, 1);
    recording.add(900'000, "MARKERS", again);  // a duplicate
    for (int i = 101; i <= 300; ++i)
        recording.add(i * 20'000, "ENCODERS", encoders(i * 20'000, 9 * i, 11 * i, i));
    recording.add(6'000'001, "MARKERS", again);  // late
    recording.sort();
    Replay run(plain_config());
    run.replay(recording);
    int fused = 0, duplicate = 0, late = 0;
    for (const SightingReport& report : run.final_reports()) {
        fused += report.verdict == Verdict::fused;
        duplicate += report.verdict == Verdict::duplicate;
        late += report.verdict == Verdict::late;
    }
    EXPECT_EQ(fused, 3);
    EXPECT_EQ(duplicate, 1);
    EXPECT_EQ(late, 1);
    EXPECT_EQ(run.final_reports().size(), 6U);
    EXPECT_EQ(run.engine().inputs()[0].samples(), 6);
}

TEST(RunTest, IsTheSameFromMemoryAndFromAFile) {
    const Folder folder;
    short_drive().save(folder.path("run.lcmlog"));
    Replay memory(plain_config(), true), file(plain_config(), true);
    memory.replay(short_drive());
    std::vector<double> progress;
    file.replay(folder.path("run.lcmlog"), [&](double done) { progress.push_back(done); });
    ASSERT_EQ(memory.published().size(), file.published().size());
    EXPECT_GT(memory.published().size(), 105U);
    for (std::size_t i = 0; i < memory.published().size(); ++i) {
        const LogEvent a = memory.published()[i], b = file.published()[i];
        ASSERT_EQ(a.received, b.received);
        ASSERT_EQ(a.channel, b.channel);
        ASSERT_EQ(a.size, b.size);
        ASSERT_EQ(std::memcmp(a.data, b.data, a.size), 0) << "message " << i;
    }
}

TEST(RunTest, TellsWhatIsDamaged) {
    const Folder folder;
    short_drive().save(folder.path("run.lcmlog"));
    std::string bytes = folder.read("run.lcmlog");
    bytes.replace(bytes.size() / 2, 3, "\xff\xff\xff");
    Replay run(plain_config());
    run.replay(folder.write("damaged.lcmlog", bytes));
    EXPECT_GE(run.messages(), 103);
    EXPECT_GE(run.poses().size(), 99U);
    EXPECT_NEAR(run.poses().back().x, 1, 0.1);
}

TEST(RunTest, TellsWhatWaitedInVain) {
    Recording recording = short_drive();
    recording.add(2'000'500, "MARKERS", frame(2'000'400, "camera", {seen(1, 0.3)}, 4));
    Replay run(plain_config());
    run.replay(recording);
    EXPECT_EQ(run.final_reports().back().verdict, Verdict::no_motion);
}

TEST(RunTest, WritesPosesAsNumbersThatReadBack) {
    const Folder folder;
    Replay run(plain_config());
    run.replay(short_drive());
    run.write_poses_csv(folder.path("pose.csv"));
    std::string text = folder.read("pose.csv");
    EXPECT_EQ(text.substr(0, text.find('\n')),
              "utime,x,y,heading,xx,xy,xh,yy,yh,hh,v,omega,status,resets");
    text = "#" + text;
    const std::vector<double> rows =
        read_table(folder.write("numbers.txt", text), {0, 1, 2, 3, 4, 9, 11, 12});
    ASSERT_EQ(rows.size(), 101U * 8);
    const Replay::PoseRow& last = run.poses().back();
    const double expected[] = {2e6,
                               last.x,
                               last.y,
                               last.heading,
                               last.covariance[0][0],
                               last.covariance[2][2],
                               last.omega,
                               static_cast<double>(last.status)};
    for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(rows[100 * 8 + i], expected[i]) << "column " << i;
}

TEST(RunTest, WritesTumTrajectories) {
    const Folder folder;
    Replay run(plain_config());
    Recording recording;
    recording.add(0, "ENCODERS", encoders(-20'000, 0, 0));
    recording.add(1, "ENCODERS", encoders(1'980'000, -500, 500));
    run.replay(recording);
    run.write_poses_tum(folder.path("pose.tum"));
    const std::string text = folder.read("pose.tum");
    EXPECT_EQ(text.substr(0, text.find('\n')), "-0.020000 0 0 0 0 0 0 1");
    const std::vector<double> rows = read_table(folder.path("pose.tum"), {0, 1, 2, 3, 4, 5, 6, 7});
    EXPECT_EQ(rows[8], 1.98);
    EXPECT_NEAR(rows[8 + 6], std::sin(1.0), 1e-12) << "half of two radians";
    EXPECT_NEAR(rows[8 + 7], std::cos(1.0), 1e-12);
}

TEST(RunTest, WritesAReportALine) {
    const Folder folder;
    Replay run(plain_config());
    run.replay(short_drive());
    run.write_reports_csv(folder.path("reports.csv"));
    const std::string text = folder.read("reports.csv");
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 4);
    EXPECT_NE(text.find("\n500000,camera,1,0,1,0,"), std::string::npos) << text;
    EXPECT_NE(text.find("\n500000,camera,1,1,8,0,nan,nan,nan,nan,nan,nan,nan,1,0,unknown_marker,"),
              std::string::npos)
        << text;
    const auto commas =
        std::count(text.begin(), text.begin() + static_cast<long>(text.find('\n')), ',');
    EXPECT_EQ(std::count(text.begin(), text.end(), ','), 5 * commas) << "as many columns as names";
}

}  // namespace
}  // namespace pilotage::test
