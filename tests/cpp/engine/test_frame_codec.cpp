// Frames hold a name and a count from outside: whatever they claim, nothing is read or reserved for
// it.

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "support/allocations.hpp"
#include "support/messages.hpp"

namespace pilotage::test {
namespace {

constexpr std::size_t kNameAt = 8 + 8 + 4;  // fingerprint, utime, seq

bool decodes(const Bytes& bytes, Decoded& out) {
    const Codec* codec = find_codec(fingerprint_of(bytes.data(), bytes.size()));
    return codec != nullptr && codec->decode(bytes.data(), bytes.size(), out);
}

bool decodes(const Bytes& bytes) {
    Decoded out;
    return decodes(bytes, out);
}

void put(Bytes& bytes, std::size_t at, std::int32_t value) {
    for (int i = 0; i < 4; ++i)
        bytes[at + static_cast<std::size_t>(i)] =
            static_cast<std::uint8_t>(static_cast<std::uint32_t>(value) >> (24 - 8 * i));
}

const std::int32_t kCounts[] = {
    -1, -2147483647 - 1, 1, 3, 4, 0x10000, 0x01000000, 0x7ffffff, 0x7fffffff, 76695845, -76695845};

TEST(FrameCodecTest, MakesASampleOfEachSightingInItsPlace) {
    marker_sighting_t full = seen(7, 0.1, 0.2, 0.3);
    full.label = 5;
    full.sigma_bearing = 0.01;
    full.sigma_elevation = 0.02;
    full.sigma_range = 0.03;
    Decoded out;
    ASSERT_TRUE(decodes(bytes_of(frame(44, "front left", {seen(-1, 1), full}, 12)), out));
    EXPECT_EQ(out.sensor, "front left");
    EXPECT_EQ(out.utime, 44);
    EXPECT_EQ(out.seq, 12);
    ASSERT_EQ(out.samples.size(), 2U);
    for (std::uint16_t i = 0; i < 2; ++i) {
        EXPECT_EQ(out.samples[i].index, i);
        EXPECT_EQ(out.samples[i].stream, Stream::sighting);
        EXPECT_EQ(out.samples[i].utime, 44);
        EXPECT_EQ(out.samples[i].seq, 12);
    }
    EXPECT_EQ(out.samples[0].payload.sighting.id, -1);
    EXPECT_TRUE(std::isnan(out.samples[0].payload.sighting.value[1]));
    const Sighting& s = out.samples[1].payload.sighting;
    for (int i = 0; i < 3; ++i) {
        EXPECT_DOUBLE_EQ(s.value[i], 0.1 * (i + 1));
        EXPECT_DOUBLE_EQ(s.sigma[i], 0.01 * (i + 1));
    }
    EXPECT_EQ(s.id, 7);
    EXPECT_EQ(s.label, 5);
}

TEST(FrameCodecTest, MayHoldNothingAndHaveNoName) {
    Decoded out;
    EXPECT_TRUE(decodes(bytes_of(frame(1, "", {})), out));
    EXPECT_TRUE(out.samples.empty());
    EXPECT_EQ(out.sensor, "");
}

TEST(FrameCodecTest, RefusesACountThatTheBytesCannotHold) {
    const Bytes good = bytes_of(frame(1, "camera", {seen(1, 0.1), seen(2, 0.2)}));
    const std::size_t count_at = kNameAt + 4 + 7;
    ASSERT_TRUE(decodes(good));
    for (const std::int32_t count : kCounts) {
        Bytes bad = good;
        put(bad, count_at, count);
        const AllocationCount allocations;
        EXPECT_FALSE(decodes(bad)) << count;
        EXPECT_LT(allocations.since(), 20) << count;
    }
}

TEST(FrameCodecTest, RefusesANameThatTheBytesCannotHold) {
    const Bytes good = bytes_of(frame(1, "camera", {seen(1, 0.1)}));
    for (const std::int32_t length : kCounts) {
        Bytes bad = good;
        put(bad, kNameAt, length);
        EXPECT_FALSE(decodes(bad)) << length;
    }
    Bytes none = good;
    put(none, kNameAt, 0);
    EXPECT_FALSE(decodes(none)) << "even an empty name has its final zero";
}

TEST(FrameCodecTest, RefusesMoreSightingsThanTheirPlaceCanCount) {
    constexpr std::size_t most = std::numeric_limits<std::uint16_t>::max();
    EXPECT_TRUE(decodes(bytes_of(frame(1, "c", std::vector<marker_sighting_t>(most)))));
    EXPECT_FALSE(decodes(bytes_of(frame(1, "c", std::vector<marker_sighting_t>(most + 1)))));
}

TEST(FrameCodecTest, IsUsedAgainWithoutItsOldContent) {
    Decoded out;
    ASSERT_TRUE(decodes(bytes_of(frame(1, "a long name", {seen(1, 0.1), seen(2, 0.2)})), out));
    out.samples.clear();
    ASSERT_TRUE(decodes(bytes_of(frame(2, "b", {seen(3, 0.3)})), out));
    EXPECT_EQ(out.sensor, "b");
    ASSERT_EQ(out.samples.size(), 1U);
    EXPECT_EQ(out.samples[0].payload.sighting.id, 3);
}

}  // namespace
}  // namespace pilotage::test
