// noise.adaptation: the localizer learns how noisy its sensors and its motion are.

#include <algorithm>
#include <random>

#include "support/localizers.hpp"
#include "support/random.hpp"
#include "support/robots.hpp"
#include "support/sighting_drives.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_LOCALIZER_SUITE(NoiseAdaptationTest);

/// A robot on a circle in the yard, with noise in everything that it is configured to have.
struct NoisyCircle {
    double sensor = 1, motion = 1;  ///< true over configured sigmas
    double outliers = 0;
    bool stated = false;  ///< sightings state the sigmas that are configured otherwise
    bool ids = true;
    unsigned seed = 1;

    static Params params(NoiseAdaptation adaptation = NoiseAdaptation::on) {
        Params params = plain_params();
        params.initial.y_m = -2;
        params.wheels.left_m_per_tick = params.wheels.right_m_per_tick = 1e-7;
        params.noise.adaptation = adaptation;
        return params;
    }

    [[nodiscard]] std::vector<Sample> samples(double seconds) const {
        const Params p = params();
        const MarkerMap& map = kYard;
        constexpr double left_m = 0.0095, right_m = 0.0105, driven_m = 0.01, track_m = 0.5;
        Draw draw(seed);
        std::vector<Sample> samples;
        Pose<double> truth(0, -2, 0);
        double left = 0, right = 0;
        for (int i = 0; i <= seconds * kSecond / kPeriod; ++i) {
            if (i > 0) {
                truth = after_arc(truth, driven_m, (right_m - left_m) / track_m);
                const auto n = draw.normal<double, 4>();
                const double slip = motion * p.noise.position_m_per_sqrt_m * std::sqrt(driven_m);
                const double wheel = motion * p.noise.wheel_m_per_sqrt_m;
                truth += slip * Pose<double>(n[0], n[1], 0);
                left += left_m + wheel * std::sqrt(left_m) * n[2];
                right += right_m + wheel * std::sqrt(right_m) * n[3];
            }
            samples.push_back(
                encoders_at(i * kPeriod, std::llround(left * 1e7), std::llround(right * 1e7), i));
            if (i % 5 == 0) look(map, truth, i, draw, samples);
        }
        return samples;
    }

   private:
    void look(const MarkerMap& map, const Pose<double>& truth, int i, Draw& draw,
              std::vector<Sample>& samples) const {
        const SensorParams s;
        const Vector<double, 3> sigma(s.sigma_bearing_rad, s.sigma_elevation_rad, s.sigma_range_m);
        for (std::uint16_t k = 0; k < 3; ++k) {
            const auto marker = static_cast<std::size_t>(i / 5 + 3 * k) % map.markers().size();
            Vector<double, 3> z = view(truth, map.markers()[marker]);
            z += sensor * sigma.cwiseProduct(draw.normal<double, 3>());
            if (draw.uniform(0, 1) < outliers) z = {draw.uniform(-3, 3), 0, draw.uniform(1, 15)};
            const auto id = ids ? map.markers()[marker].id : kUnknownId;
            Sample sample = sighting_at(i * kPeriod, id, only(z, true, false, true), k);
            sample.seq = i;
            if (stated) {
                sample.payload.sighting.sigma[kBearing] = sigma[kBearing];
                sample.payload.sighting.sigma[kRange] = sigma[kRange];
            }
            samples.push_back(sample);
        }
    }
};

/// What is learned of a drive.
NoiseScale learned(const LocalizerKind& kind, const NoisyCircle& circle, double seconds) {
    Params params = NoisyCircle::params();
    if (circle.stated)  // what is configured does not count then
        params.sensors[0].sigma_bearing_rad = params.sensors[0].sigma_range_m = 1;
    Robot robot(kind, params, kYard);
    robot.add(circle.samples(seconds));
    EXPECT_EQ(robot.estimate().status, Status::ok);
    return robot.noise();
}

void expect_within_a_fifth(double scale, double truth) {
    EXPECT_GT(scale, truth / 1.2);
    EXPECT_LT(scale, truth * 1.2);
}

TEST_P(NoiseAdaptationTest, FindsTheSensorsNoiseInAMinute) {
    for (const double truth : {0.5, 1.0, 2.0})
        for (const bool stated : {false, true}) {
            SCOPED_TRACE(truth);
            NoisyCircle circle;
            circle.sensor = truth;
            circle.stated = stated;
            const NoiseScale noise = learned(GetParam(), circle, 60);
            expect_within_a_fifth(noise.sensor(0), truth);
            expect_within_a_fifth(noise.motion(), 1);
            EXPECT_EQ(noise.sensor(1), 1) << "of which nothing was seen";
        }
}

TEST_P(NoiseAdaptationTest, FindsItWithoutIdsToo) {
    NoisyCircle circle;
    circle.sensor = 2;
    circle.stated = true;
    circle.ids = false;
    expect_within_a_fifth(learned(GetParam(), circle, 60).sensor(0), 2);
}

/// Motion has a small share in each innovation, so it takes longer.
TEST_P(NoiseAdaptationTest, FindsTheMotionsNoiseInMinutes) {
    for (const double truth : {0.5, 2.0}) {
        SCOPED_TRACE(truth);
        NoisyCircle circle;
        circle.motion = truth;
        const NoiseScale noise = learned(GetParam(), circle, 900);
        expect_within_a_fifth(noise.sensor(0), 1);
        expect_within_a_fifth(noise.motion(), truth);
    }
}

TEST_P(NoiseAdaptationTest, OutliersAreNoNoise) {
    NoisyCircle circle;
    circle.outliers = 0.2;
    const NoiseScale noise = learned(GetParam(), circle, 120);
    expect_within_a_fifth(noise.sensor(0), 1);
    expect_within_a_fifth(noise.motion(), 1);
}

TEST_P(NoiseAdaptationTest, HasBounds) {
    NoisyCircle circle;
    circle.outliers = 0.2;
    for (const double truth : {0.02, 50.0}) {
        circle.sensor = circle.motion = truth;
        Robot robot(GetParam(), NoisyCircle::params(), kYard);
        for (const Sample& sample : circle.samples(200)) {
            robot.add(sample);
            const NoiseScale noise = robot.noise();
            for (const double scale : {noise.sensor(0), noise.motion()}) {
                ASSERT_GE(scale, 0.9999 / NoiseScale::kMost);
                ASSERT_LE(scale, 1.0001 * NoiseScale::kMost);
            }
        }
    }
}

/// Samples are late by up to 1.9 s of the 2 s that the history holds.
TEST_P(NoiseAdaptationTest, DoesNotDependOnTheOrderOfArrival) {
    NoisyCircle circle;
    circle.sensor = 2;
    const std::vector<Sample> samples = circle.samples(20);
    Robot in_order(GetParam(), NoisyCircle::params(), kYard);
    in_order.add(samples);
    Draw draw(3);
    std::vector<std::pair<double, std::size_t>> arrival;
    for (std::size_t i = 0; i < samples.size(); ++i)
        arrival.emplace_back(double(samples[i].utime) + draw.uniform(0, 1.9e6), i);
    std::sort(arrival.begin(), arrival.end());
    Robot robot(GetParam(), NoisyCircle::params(), kYard);
    for (const auto& [time, i] : arrival) robot.add(samples[i]);
    EXPECT_GT(in_order.noise().sensor(0), 1.5);
    EXPECT_EQ(robot.noise().sensor(0), in_order.noise().sensor(0));
    EXPECT_EQ(robot.noise().motion(), in_order.noise().motion());
    EXPECT_EQ(robot.state(), in_order.state());
    EXPECT_EQ(robot.covariance(), in_order.covariance());
}

TEST_P(NoiseAdaptationTest, OffNothingIsLearned) {
    NoisyCircle circle;
    circle.sensor = 2;
    Robot robot(GetParam(), NoisyCircle::params(NoiseAdaptation::off), kYard);
    robot.add(circle.samples(20));
    EXPECT_EQ(robot.noise().sensor(0), 1);
    EXPECT_EQ(robot.noise().motion(), 1);
}

/// Until three sightings have confirmed the pose their innovations speak of the pose.
TEST_P(NoiseAdaptationTest, BeforeAnythingIsLearnedOnIsOff) {
    NoisyCircle circle;
    circle.sensor = 2;
    std::vector<Sample> samples = circle.samples(2);
    const auto sighting = [](const Sample& s) { return s.stream == Stream::sighting; };
    int seen = 0;
    samples.erase(std::remove_if(samples.begin(), samples.end(),
                                 [&](const Sample& s) { return sighting(s) && ++seen > 2; }),
                  samples.end());
    Robot on(GetParam(), NoisyCircle::params(), kYard);
    Robot off(GetParam(), NoisyCircle::params(NoiseAdaptation::off), kYard);
    on.add(samples);
    off.add(samples);
    EXPECT_EQ(on.state(), off.state());
    EXPECT_EQ(on.covariance(), off.covariance());
}

}  // namespace
}  // namespace pilotage::test
