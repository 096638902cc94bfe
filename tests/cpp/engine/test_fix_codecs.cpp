// Fixes and ranges to walls: one kind of input, several types.

#include <gtest/gtest.h>

#include <cmath>

#include "support/messages.hpp"

namespace pilotage::test {
namespace {

Decoded decoded_as(const Bytes& bytes, Kind kind) {
    const Codec* codec = find_codec(fingerprint_of(bytes.data(), bytes.size()));
    Decoded out;
    EXPECT_NE(codec, nullptr);
    if (codec == nullptr) return out;
    EXPECT_EQ(codec->kind, kind);
    EXPECT_TRUE(codec->decode(bytes.data(), bytes.size(), out));
    return out;
}

TEST(FixCodecTest, APartOfThePoseLeavesTheRestUnmeasured) {
    const Decoded compass = decoded_as(bytes_of(heading(5, "compass", 1.5, 0.1, 7)), Kind::fix);
    ASSERT_EQ(compass.samples.size(), 1U);
    EXPECT_EQ(compass.sensor, "compass");
    EXPECT_EQ(compass.samples[0].stream, Stream::fix);
    EXPECT_EQ(compass.samples[0].utime, 5);
    EXPECT_EQ(compass.samples[0].seq, 7);
    const Fix& h = compass.samples[0].payload.fix;
    EXPECT_TRUE(std::isnan(h.value[0]) && std::isnan(h.value[1]));
    EXPECT_EQ(h.value[2], 1.5);
    EXPECT_NEAR(h.covariance[5], 0.01, 1e-15);

    position_fix_t message = position_fix(5, "gps", 1, 2);
    for (int i = 0; i < 4; ++i) message.covariance[i] = i;
    const Fix p = decoded_as(bytes_of(message), Kind::fix).samples.at(0).payload.fix;
    EXPECT_EQ(p.value[0], 1);
    EXPECT_EQ(p.value[1], 2);
    EXPECT_TRUE(std::isnan(p.value[2]));
    EXPECT_EQ(p.covariance[0], 0);
    EXPECT_EQ(p.covariance[1], 2) << "row-major, lower triangle";
    EXPECT_EQ(p.covariance[2], 3);
}

TEST(FixCodecTest, APoseComesWhole) {
    pose_fix_t message = pose_fix(5, "dock", 1, 2, 3);
    for (int i = 0; i < 9; ++i) message.covariance[i] = i;
    const Fix f = decoded_as(bytes_of(message), Kind::fix).samples.at(0).payload.fix;
    for (int i = 0; i < 3; ++i) EXPECT_EQ(f.value[i], i + 1);
    const double lower[] = {0, 3, 4, 6, 7, 8};
    for (int i = 0; i < 6; ++i) EXPECT_EQ(f.covariance[i], lower[i]);
}

TEST(FixCodecTest, ANegativeSigmaStaysOne) {
    const Fix f =
        decoded_as(bytes_of(heading(0, "compass", 0, -0.1)), Kind::fix).samples.at(0).payload.fix;
    EXPECT_LT(f.covariance[5], 0);
}

TEST(FixCodecTest, ABeamThatHitNothingIsNone) {
    const Decoded out = decoded_as(
        bytes_of(wall_ranges(3, "laser", {0, 0.1, 0.2}, {1, NAN, 2}, 0.05, 9)), Kind::walls);
    ASSERT_EQ(out.samples.size(), 2U);
    EXPECT_EQ(out.sensor, "laser");
    EXPECT_EQ(out.samples[1].stream, Stream::beam);
    EXPECT_EQ(out.samples[1].index, 2) << "its place in the message";
    EXPECT_EQ(out.samples[1].payload.beam.angle_rad, 0.2);
    EXPECT_EQ(out.samples[1].payload.beam.range_m, 2);
    EXPECT_EQ(out.samples[1].payload.beam.sigma_m, 0.05);
}

TEST(FixCodecTest, ALieAboutTheLengthIsNoMessage) {
    const Bytes messages[] = {
        bytes_of(heading(0, "compass", 0)), bytes_of(position_fix(0, "gps", 0, 0)),
        bytes_of(pose_fix(0, "dock", 0, 0, 0)), bytes_of(wall_ranges(0, "laser", {0, 1}, {1, 2}))};
    for (const Bytes& bytes : messages) {
        const Codec* codec = find_codec(fingerprint_of(bytes.data(), bytes.size()));
        ASSERT_NE(codec, nullptr);
        Decoded out;
        for (std::size_t size = 8; size < bytes.size(); ++size)
            EXPECT_FALSE(codec->decode(bytes.data(), size, out)) << size;
        for (std::size_t at = 20; at < 24; ++at)  // the name's length
            for (const unsigned value : {0x7fU, 0xffU}) {
                Bytes lie = bytes;
                lie[at] = static_cast<std::uint8_t>(value);
                EXPECT_FALSE(codec->decode(lie.data(), lie.size(), out));
            }
    }
    Bytes walls = messages[3];
    for (std::size_t at = 24 + 6; at < 24 + 10; ++at) {  // the count of beams
        Bytes lie = walls;
        lie[at] = 0x7f;
        Decoded out;
        EXPECT_FALSE(find_codec(fingerprint_of(lie.data(), lie.size()))
                         ->decode(lie.data(), lie.size(), out));
    }
}

TEST(FixCodecTest, AnInputNamesAllItsTypes) {
    EXPECT_EQ(expected_types(Kind::fix), "pose_fix_t or position_fix_t or heading_t");
    EXPECT_EQ(expected_types(Kind::walls), "wall_range_t");
}

}  // namespace
}  // namespace pilotage::test
