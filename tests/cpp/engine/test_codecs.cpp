// Bytes to samples: the decoder is found by the fingerprint, and takes whole messages only.

#include "engine/codecs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "support/messages.hpp"

namespace pilotage::test {
namespace {

/// One of each type that the engine takes.
std::vector<Bytes> every_message() {
    return {bytes_of(encoders(1, 2, 3, 4)),
            bytes_of(velocity(1, 2, 3)),
            bytes_of(gyro(1, 2, 3)),
            bytes_of(frame(1, "camera", {seen(1, 0.1), seen(2, 0.2)})),
            bytes_of(pixels(1, "camera", {spotted(1, 0.1, 2), spotted(-1, 0.2, 3)})),
            bytes_of(reset(1, 2, 3, 1)),
            bytes_of(reference(1, 2, 3, 1)),
            bytes_of(tick(1, 2))};
}

const Codec& codec_of(const Bytes& bytes) {
    const Codec* codec = find_codec(fingerprint_of(bytes.data(), bytes.size()));
    if (codec == nullptr) throw std::runtime_error("no codec");
    return *codec;
}

Decoded decoded(const Bytes& bytes) {
    Decoded out;
    EXPECT_TRUE(codec_of(bytes).decode(bytes.data(), bytes.size(), out));
    return out;
}

TEST(CodecTest, IsFoundByTheFingerprint) {
    EXPECT_STREQ(codec_of(bytes_of(encoders(0, 0, 0))).type, "encoders_t");
    EXPECT_EQ(codec_of(bytes_of(encoders(0, 0, 0))).kind, Kind::encoders);
    EXPECT_EQ(codec_of(bytes_of(velocity(0, 0, 0))).kind, Kind::velocity);
    EXPECT_EQ(codec_of(bytes_of(gyro(0, 0))).kind, Kind::gyro);
    EXPECT_EQ(codec_of(bytes_of(frame(0, "", {}))).kind, Kind::frame);
    EXPECT_EQ(codec_of(bytes_of(pixels(0, "", {}))).kind, Kind::pixels);
    EXPECT_EQ(codec_of(bytes_of(reset(0, 0, 0, 0))).kind, Kind::reset);
    EXPECT_EQ(codec_of(bytes_of(reference(0, 0, 0, 0))).kind, Kind::reference);
    EXPECT_EQ(codec_of(bytes_of(tick(0))).kind, Kind::tick);
    EXPECT_EQ(find_codec(0), nullptr);
    EXPECT_EQ(find_codec(-1), nullptr);
    EXPECT_EQ(find_codec(encoders_t::getHash() + 1), nullptr);
}

TEST(CodecTest, TypesHaveFingerprintsOfTheirOwn) {
    std::vector<std::int64_t> all;
    for (const Bytes& bytes : every_message())
        all.push_back(fingerprint_of(bytes.data(), bytes.size()));
    std::sort(all.begin(), all.end());
    EXPECT_EQ(std::unique(all.begin(), all.end()), all.end());
}

TEST(CodecTest, AFingerprintNeedsEightBytes) {
    const Bytes bytes = bytes_of(gyro(0, 0));
    EXPECT_EQ(fingerprint_of(bytes.data(), 7), 0);
    EXPECT_EQ(fingerprint_of(nullptr, 0), 0);
    EXPECT_EQ(fingerprint_of(bytes.data(), 8), gyro_t::getHash());
}

TEST(CodecTest, KnowsWhatAnInputExpects) {
    EXPECT_EQ(expected_types(Kind::encoders), "encoders_t");
    EXPECT_EQ(expected_types(Kind::velocity), "velocity_t");
    EXPECT_EQ(expected_types(Kind::gyro), "gyro_t");
    EXPECT_EQ(expected_types(Kind::frame), "marker_frame_t");
    EXPECT_EQ(expected_types(Kind::pixels), "pixel_frame_t");
    EXPECT_EQ(expected_types(Kind::reset), "pose_reset_t");
}

TEST(CodecTest, MakesSamplesOfMessages) {
    const Decoded motion = decoded(bytes_of(encoders(-5, std::int64_t{1} << 40, -7, 9)));
    EXPECT_EQ(motion.utime, -5);
    EXPECT_EQ(motion.seq, 9);
    ASSERT_EQ(motion.samples.size(), 1U);
    EXPECT_EQ(motion.samples[0].stream, Stream::motion);
    EXPECT_EQ(motion.samples[0].seq, 9);
    EXPECT_EQ(motion.samples[0].payload.ticks.left, std::int64_t{1} << 40);
    EXPECT_EQ(motion.samples[0].payload.ticks.right, -7);

    const Decoded speeds = decoded(bytes_of(velocity(3, 0.5, -0.25)));
    EXPECT_EQ(speeds.samples.at(0).payload.velocity.v_m_s, 0.5);
    EXPECT_EQ(speeds.samples.at(0).payload.velocity.omega_rad_s, -0.25);

    const Decoded rate = decoded(bytes_of(gyro(3, 0.125, 4)));
    EXPECT_EQ(rate.samples.at(0).stream, Stream::gyro);
    EXPECT_EQ(rate.samples.at(0).payload.gyro.rate_rad_s, 0.125);

    const Decoded truth = decoded(bytes_of(reference(8, 1, 2, 3)));
    EXPECT_TRUE(truth.samples.empty()) << "truth is never fused";
    EXPECT_EQ(truth.utime, 8);
    EXPECT_EQ(truth.reference[2], 3);
    EXPECT_EQ(decoded(bytes_of(tick(5, 17))).drops, 17);
}

TEST(CodecTest, TakesTheLowerTriangleOfAResetsCovariance) {
    pose_reset_t message = reset(0, 1, 2, 3);
    for (int i = 0; i < 9; ++i) message.covariance[i] = i;
    const PoseReset taken = decoded(bytes_of(message)).samples.at(0).payload.reset;
    const double expected[] = {0, 3, 4, 6, 7, 8};
    for (int i = 0; i < 6; ++i) EXPECT_EQ(taken.covariance[i], expected[i]);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(taken.pose[i], i + 1);
}

TEST(CodecTest, RefusesEveryTruncationAndEveryByteTooMany) {
    for (Bytes bytes : every_message()) {
        const Codec& codec = codec_of(bytes);
        for (std::size_t size = 8; size < bytes.size(); ++size) {
            const Bytes part(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
            Decoded out;
            EXPECT_FALSE(codec.decode(part.data(), size, out))
                << codec.type << ", " << size << " of " << bytes.size() << " bytes";
        }
        for (int extra = 0; extra < 80; ++extra) {
            bytes.push_back(0);
            Decoded out;
            EXPECT_FALSE(codec.decode(bytes.data(), bytes.size(), out))
                << codec.type << " and " << extra + 1 << " bytes";
        }
    }
}

TEST(CodecTest, ReadsTheMBotsEncoders) {
    const Bytes bytes = {0x7d, 0x09, 0x0b, 0xfb, 0x22, 0x1d, 0x74, 0xf9,  // fingerprint
                         0,    0,    0,    0,    0,    0,    1,    0,     // utime 256
                         0xff, 0xff, 0xff, 0xfe, 0,    0,    0,    7};    // -2, 7
    const Codec& codec = codec_of(bytes);
    EXPECT_EQ(codec.kind, Kind::encoders);
    const Decoded out = decoded(bytes);
    EXPECT_EQ(out.utime, 256);
    EXPECT_EQ(out.samples.at(0).payload.ticks.left, -2);
    EXPECT_EQ(out.samples.at(0).payload.ticks.right, 7);
    Decoded rest;
    EXPECT_FALSE(codec.decode(bytes.data(), bytes.size() - 1, rest));
    EXPECT_EQ(expected_types(Kind::encoders), "encoders_t") << "ours is what we ask for";
}

}  // namespace
}  // namespace pilotage::test
