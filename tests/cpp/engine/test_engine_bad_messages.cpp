// Bad messages: each is counted once, the first of a kind is told, none changes what is published.

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/engines.hpp"

namespace pilotage::test {
namespace {

TEST(BadMessageTest, OfAnotherTypeIsCountedAndToldOnce) {
    Bench bench;
    for (int i = 0; i < 5; ++i) bench.send("ENCODERS", gyro(i, 0.1));
    ASSERT_EQ(bench.notices.size(), 1U);
    EXPECT_EQ(count_of(bench.input("ENCODERS"), "wrong_type"), 5);
    EXPECT_EQ(bench.statuses.back().inputs[1].problem, "5 of 5 rejected: wrong_type");
    EXPECT_EQ(bench.notices.size(), 2U) << "the input is not well";
    EXPECT_EQ(bench.notices[0].find("ENCODERS: expected encoders_t, got gyro_t"), 0U)
        << bench.notices[0];
    bench.send("MARKERS", gyro(9, 0.1));
    EXPECT_EQ(bench.notices.size(), 3U) << "once a channel";
    EXPECT_TRUE(bench.poses.empty());
}

TEST(BadMessageTest, OfNoKnownTypeIsNamedByItsFingerprint) {
    Bench bench;
    bench.send_bytes("GYRO", {0xde, 0xad, 0xbe, 0xef, 0, 0, 0, 1, 42});
    ASSERT_EQ(bench.notices.size(), 1U);
    EXPECT_NE(bench.notices[0].find("deadbeef00000001"), std::string::npos) << bench.notices[0];
    EXPECT_EQ(count_of(bench.input("GYRO"), "wrong_type"), 1);
}

TEST(BadMessageTest, CutAtAnyLengthIsCountedAndToldOnce) {
    Bench bench;
    const Bytes whole = bytes_of(frame(1, "camera", {seen(1, 0.1), seen(2, 0.2)}));
    for (std::size_t size = 0; size < whole.size(); ++size)
        bench.send_bytes("MARKERS", Bytes(whole.begin(), whole.begin() + static_cast<long>(size)));
    EXPECT_EQ(bench.notices.size(), 2U);
    const input_status_t input = bench.input("MARKERS");
    EXPECT_EQ(count_of(input, "wrong_type"), 8) << "shorter than a fingerprint";
    EXPECT_EQ(count_of(input, "malformed"), static_cast<long>(whole.size()) - 8);
}

TEST(BadMessageTest, WithBytesTooManyIsMalformed) {
    Bench bench;
    Bytes bytes = bytes_of(encoders(1, 2, 3));
    bytes.push_back(0);
    bench.send_bytes("ENCODERS", bytes);
    EXPECT_EQ(count_of(bench.input("ENCODERS"), "malformed"), 1);
    EXPECT_TRUE(bench.poses.empty());
}

TEST(BadMessageTest, OfAnUnknownSensorSaysWhatToAdd) {
    Bench bench;
    for (int i = 0; i < 3; ++i) bench.send("MARKERS", frame(i, "scanner", {seen(1, 0.1)}));
    ASSERT_EQ(bench.notices.size(), 1U);
    EXPECT_EQ(count_of(bench.input("MARKERS"), "unknown_sensor"), 3);
    EXPECT_NE(bench.notices[0].find("add sensors.scanner"), std::string::npos);
}

TEST(BadMessageTest, WithInventedNamesFillNeitherJournalNorMemory) {
    Bench bench;
    for (int i = 0; i < 5000; ++i)
        bench.send("MARKERS", frame(i, "sensor" + std::to_string(i), {}));
    EXPECT_LE(bench.notices.size(), 100U);
    Bench long_name;
    long_name.send("MARKERS", frame(0, std::string(50'000, 'x'), {}));
    long_name.send("MARKERS", frame(0, "two\nlines\x1b[2J", {}));
    for (const std::string& line : long_name.notices) {
        EXPECT_LT(line.size(), 300U);
        EXPECT_TRUE(std::all_of(line.begin(), line.end(), [](char c) { return c >= ' '; }))
            << "control characters from outside";
    }
}

TEST(BadMessageTest, OnAChannelOfNobodyIsNotOurs) {
    Bench bench;
    bench.send("CAMERA_IMAGE", encoders(1, 2, 3));
    bench.send("", encoders(1, 2, 3));
    bench.send("ENCODERS2", encoders(1, 2, 3));
    bench.engine().tick(0, 0);
    for (const input_status_t& input : bench.statuses.back().inputs) EXPECT_EQ(input.received, 0);
    EXPECT_TRUE(bench.notices.empty());
    EXPECT_TRUE(bench.poses.empty());
}

TEST(BadMessageTest, WithANonFiniteFieldIsCounted) {
    Bench bench;
    constexpr double inf = std::numeric_limits<double>::infinity();
    bench.send("ENCODERS", encoders(0, 0, 0));
    for (const double bad : {static_cast<double>(NAN), inf, -inf}) {
        bench.send("GYRO", gyro(1, bad));
        bench.send("POSE_RESET", reset(1, bad, 0, 0));
        bench.send("POSE_RESET", reset(1, 0, 0, 0, bad));
    }
    bench.send("MARKERS", frame(1, "camera", {seen(1, inf), seen(1, NAN), seen(1, 0.1, -inf)}));
    bench.send("ENCODERS", encoders(20'000, 0, 0));
    EXPECT_EQ(count_of(bench.input("GYRO"), "bad_value"), 3);
    EXPECT_EQ(count_of(bench.input("POSE_RESET"), "bad_value"), 6);
    EXPECT_EQ(count_of(bench.input("MARKERS"), "bad_value"), 3);
    EXPECT_EQ(bench.poses.size(), 2U);
}

TEST(BadMessageTest, AFrameBeforeAPoseIsKnownIsCountedSightingBySighting) {
    Bench bench("", "sensors: {camera: {}}\n");
    bench.send("ENCODERS", encoders(0, 0, 0));
    bench.send("MARKERS", frame(1, "camera", {seen(1, 0.1), seen(2, 0.2), seen(3, 0.3)}));
    bench.send("ENCODERS", encoders(2, 0, 0));
    EXPECT_EQ(count_of(bench.input("MARKERS"), "not_initialized"), 3);
    EXPECT_EQ(bench.input("MARKERS").received, 3);
    EXPECT_EQ(bench.input("ENCODERS").fused, 2);
    EXPECT_EQ(bench.reports.size(), 3U);
    EXPECT_TRUE(bench.poses.empty());
}

}  // namespace
}  // namespace pilotage::test
