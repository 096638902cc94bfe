// The one order of samples: by time, stream, seq, sensor, place in the frame,
// then bytes.

#include "pilotage/samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/random.hpp"
#include "support/samples.hpp"

namespace pilotage::test {
namespace {

Sample sighting(std::int64_t utime, std::int32_t seq, std::uint8_t source, std::uint16_t index,
                std::int32_t id = 1) {
    const Sighting seen{{0.1, kNan, kNan}, {kNan, kNan, kNan}, id, -1};
    return Sample::make(utime, seq, Stream::sighting, seen, source, index);
}

/// Samples that must stand in this order.
std::vector<Sample> ladder() {
    return {
        sighting(-5, 9, 3, 9),                 // the earliest time wins over all
        reset_at(0, {9, 9, 9}, {9, 9, 9}, 9),  // then the stream: reset,
        gyro_at(0, 9, 9),                      //   gyro,
        encoders_at(0, 9, 9, 8),               //   motion,
        encoders_at(0, 1, 1, 9),               //   (by seq, whatever it holds)
        sighting(0, -1, 3, 9),
        sighting(0, 0, 0, 9),  //   sighting: by seq,
        sighting(0, 0, 1, 0),
        sighting(0, 0, 1, 1, 7),  //   by sensor, by place in the frame,
        sighting(0, 0, 1, 1, 9),  //   by bytes
        gyro_at(1, 0, 0),
    };
}

TEST(SampleTest, CompareByTimeStreamSeqSourceIndexAndPayload) {
    const std::vector<Sample> samples = ladder();
    for (std::size_t i = 0; i < samples.size(); ++i)
        for (std::size_t j = 0; j < samples.size(); ++j) {
            const int order = samples[i].compare(samples[j]);
            EXPECT_EQ(order < 0, i < j) << i << " and " << j;
            EXPECT_EQ(order > 0, i > j) << i << " and " << j;
        }
}

TEST(SampleTest, SortIntoOneOrderWhateverTheArrival) {
    const std::vector<Sample> samples = ladder();
    std::mt19937 generator(4);
    for (int trial = 0; trial < 100; ++trial) {
        std::vector<Sample> arrived = samples;
        std::shuffle(arrived.begin(), arrived.end(), generator);
        std::sort(arrived.begin(), arrived.end(), InOrder{});
        for (std::size_t i = 0; i < samples.size(); ++i)
            ASSERT_EQ(arrived[i].compare(samples[i]), 0) << "place " << i;
    }
}

TEST(SampleTest, OfEqualContentAreEqualByteForByte) {
    const Sample a = sighting(1, 2, 3, 4), b = sighting(1, 2, 3, 4);
    EXPECT_EQ(a.compare(b), 0) << "NaN must not make a sample differ from its copy";
    EXPECT_EQ(std::memcmp(&a, &b, sizeof(Sample)), 0);
}

TEST(SampleTest, CompareAtTheEndsOfTime) {
    constexpr std::int64_t first = std::numeric_limits<std::int64_t>::min();
    constexpr std::int64_t last = std::numeric_limits<std::int64_t>::max();
    EXPECT_LT(gyro_at(first, 0).compare(gyro_at(last, 0)), 0);
    EXPECT_GT(gyro_at(last, 0).compare(gyro_at(first, 0)), 0);
}

}  // namespace
}  // namespace pilotage::test
