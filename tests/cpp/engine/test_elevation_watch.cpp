// An alarm on elevations that share a sign or change with range, and on nothing else.

#include "engine/elevation_watch.hpp"

#include <gtest/gtest.h>

#include "support/engines.hpp"
#include "support/journeys.hpp"
#include "support/random.hpp"
#include "support/units.hpp"

namespace pilotage::test {
namespace {

constexpr double kSigma = 0.02;

/// What is said of sightings from 2 to 12 m whose elevations are off by so much at a distance.
template <typename Offset>
std::string said_of(int sightings, const Offset& offset) {
    Draw draw(1);
    ElevationWatch watch;
    for (int i = 0; i < sightings; ++i) {
        const double distance = draw.uniform(2, 12);
        watch.add(offset(distance) + kSigma * draw.normal<double, 1>()(0), kSigma, distance);
    }
    return watch.problem();
}

TEST(ElevationWatchTest, NoiseAloneIsNoAlarm) {
    EXPECT_EQ(ElevationWatch().problem(), "");
    Draw draw(1);
    ElevationWatch watch;
    for (int i = 0; i < 300'000; ++i) {
        const double sigma = draw.uniform(0.005, 0.03);
        watch.add(sigma * draw.normal<double, 1>()(0), sigma, draw.log_uniform(0.5, 30));
        ASSERT_EQ(watch.problem(), "") << "after " << i;
    }
}

TEST(ElevationWatchTest, NorAreTheOutliersOfOneSighting) {
    ElevationWatch watch;
    for (int i = 0; i < 3; ++i) watch.add(1.5, kSigma, 5);
    EXPECT_EQ(watch.problem(), "");
}

TEST(ElevationWatchTest, AMeanThatIsNotZeroSpeaksOfThePitch) {
    EXPECT_EQ(said_of(2000, [](double) { return 0.8 * kDegree; }),
              "its elevations are 0.8 deg too high on average: check the sensor's pitch, or tilt:");
    EXPECT_EQ(said_of(2000, [](double) { return -0.8 * kDegree; }),
              "its elevations are 0.8 deg too low on average: check the sensor's pitch, or tilt:");
}

TEST(ElevationWatchTest, ASlopeSpeaksOfHeightsAndTheGround) {
    const std::string rising = said_of(2000, [](double d) { return 0.25 * kDegree * (d - 5); });
    EXPECT_EQ(rising.substr(0, 37), "its elevations rise with range, by 0.") << rising;
    const std::string height = said_of(2000, [](double d) { return 0.3 / d; });
    EXPECT_EQ(height.substr(0, 31), "its elevations fall with range,") << height;
}

TEST(ElevationWatchTest, ForgetsWhatWasCuredLongAgo) {
    ElevationWatch watch;
    Draw draw(1);
    const auto see = [&](int sightings, double offset) {
        for (int i = 0; i < sightings; ++i) {
            const double noise = kSigma * draw.normal<double, 1>()(0);
            watch.add(offset + noise, kSigma, draw.uniform(2, 12));
        }
    };
    see(1000, kDegree);
    EXPECT_NE(watch.problem(), "");
    see(2000, 0);
    EXPECT_EQ(watch.problem(), "");
}

/// What the engine says of a drive in the end, and whether it ever said anything.
struct Heard {
    std::string last;
    bool ever = false;
};

/// \param offset of an elevation, by the distance
template <typename Offset>
Heard heard_of(unsigned seed, const Offset& offset) {
    const MarkerMap& map = kAroundOrigin;
    Bench bench("", kGyroRobot);
    Journey journey(map, seed);
    journey.elevation = true;
    Heard heard;
    for (int i = 0; i < 60; ++i) {
        std::vector<Sample> samples = journey.go(1, 0.5, 0.2 + 0.01 * i);
        for (Sample& s : samples) {
            if (s.stream != Stream::sighting) continue;
            const Marker* marker = map.find(s.payload.sighting.id);
            s.payload.sighting.value[kElevation] += offset(
                std::hypot(marker->x_m - journey.truth[kX], marker->y_m - journey.truth[kY]));
        }
        bench.run(samples);
        heard.last = bench.input("MARKERS", journey.utime).problem;
        heard.ever |= heard.last.find("elevations") != std::string::npos;
    }
    return heard;
}

TEST(ElevationWatchTest, AHealthyDriveIsNoAlarm) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const Heard heard = heard_of(seed, [](double) { return 0.0; });
        EXPECT_FALSE(heard.ever) << seed << ": " << heard.last;
    }
}

TEST(ElevationWatchTest, APitchedSensorIsNamedByTheEngine) {
    const Heard heard = heard_of(1, [](double) { return -1.5 * kDegree; });
    EXPECT_NE(heard.last.find("deg too low on average: check the sensor's pitch"),
              std::string::npos)
        << heard.last;
}

TEST(ElevationWatchTest, AWrongHeightIsNamedByTheEngine) {
    const Heard heard = heard_of(1, [](double d) { return std::atan(0.2 / d); });
    EXPECT_NE(heard.last.find("with range"), std::string::npos) << heard.last;
}

}  // namespace
}  // namespace pilotage::test
