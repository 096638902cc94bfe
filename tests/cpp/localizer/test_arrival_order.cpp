// The estimate depends on the set of samples, not on the order in which they arrived.

#include <algorithm>
#include <map>
#include <random>
#include <tuple>

#include "support/localizers.hpp"
#include "support/random.hpp"
#include "support/robots.hpp"
#include "support/sanitized.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_LOCALIZER_SUITE(ArrivalOrderTest);

Params robot_params(Fusion fusion, HeadingSource heading) {
    Params params = params_with(heading);
    params.gyro_bias.sigma = 0.01;
    params.gyro_bias.walk = 0.001;
    params.distance_scale.sigma = params.rotation_scale.sigma = 0.02;
    params.sensor_count = 2;
    params.sensors[0].fusion = params.sensors[1].fusion = fusion;
    params.sensors[1].yaw_rad = 1;
    return params;
}

/// A noisy drive of encoders at 50 Hz, a gyro at 90 Hz and two sensors, with wrong ids, outliers,
/// markers too close, frames of several sightings, equal stamps and a counter reset.
std::vector<Sample> noisy_drive(double seconds, unsigned seed) {
    Draw draw(seed);
    const Params params = robot_params(Fusion::plain, HeadingSource::gyro);
    std::vector<Sample> samples;
    const auto end = static_cast<std::int64_t>(seconds * kSecond);
    std::int64_t left = 0, right = 0;
    for (std::int64_t t = 0; t <= end; t += kPeriod) {
        left += std::lround(draw.uniform(7, 11));
        right += std::lround(draw.uniform(9, 13));
        if (t == 35 * kPeriod) left = right = -40'000;
        samples.push_back(encoders_at(t, left, right, static_cast<std::int32_t>(t / kPeriod)));
    }
    for (std::int64_t t = 0; t <= end; t += 11'111)
        samples.push_back(gyro_at(t - t % 1000, draw.uniform(0.1, 0.3)));
    for (std::int64_t t = 5'000; t <= end; t += 33'000) {
        const Pose<double> at = after_arc({0, 0, 0}, 0.5e-6 * double(t), 0.2e-6 * double(t));
        const auto source = static_cast<std::uint8_t>(t % 2);
        const double outlier = draw.uniform(0, 1) < 0.1 ? 1.5 : 0;
        for (std::uint16_t i = 0; i < 3; ++i) {
            const Marker& marker = kSurveyedMarkers.markers()[i];
            Vector<double, 3> seen = view(at, marker, params.sensors[source]);
            seen += Vector<double, 3>(0.02, 0.02, 0.1).cwiseProduct(draw.normal<double, 3>());
            seen[0] += outlier;
            Sample sample = sighting_at(t, draw.uniform(0, 1) < 0.1 ? 99 : marker.id,
                                        only(seen, i != 1, i == 1, i != 0), i);
            sample.source = source;
            samples.push_back(sample);
        }
    }
    std::sort(samples.begin(), samples.end(), InOrder{});
    return samples;
}

/// The last report of each sighting.
using Reports = std::map<std::tuple<std::int64_t, std::uint8_t, std::uint16_t>, SightingReport>;
Reports final_reports(const Tally& tally) {
    Reports reports;
    for (const SightingReport& report : tally.reports)
        reports[{report.utime, report.sensor, report.index}] = report;
    return reports;
}

void expect_same_outcome(const Robot& robot, const Robot& in_order, const LocalizerKind& kind) {
    const double tolerance = kind.is_double ? 1e-9 : 1e-4;
    EXPECT_TRUE(close(robot.state(), in_order.state(), tolerance));
    EXPECT_TRUE(close(robot.covariance(), in_order.covariance(), tolerance));
    EXPECT_EQ(robot.estimate().utime, in_order.estimate().utime);
    EXPECT_EQ(robot.estimate().status, in_order.estimate().status);
    for (const auto& [sample, verdict] : in_order.tally.verdicts())
        ASSERT_EQ(robot.tally.of(sample), verdict)
            << name(robot.tally.of(sample)) << " instead of " << name(verdict);
    EXPECT_EQ(robot.tally.rejected(), in_order.tally.rejected());
    const Reports reports = final_reports(robot.tally), expected = final_reports(in_order.tally);
    ASSERT_EQ(reports.size(), expected.size());
    for (const auto& [key, report] : expected) {
        const SightingReport& actual = reports.at(key);
        ASSERT_EQ(actual.verdict, report.verdict);
        for (int i = 0; i < 3; ++i)
            if (std::isnan(report.innovation[i]))
                ASSERT_TRUE(std::isnan(actual.innovation[i]));
            else
                ASSERT_NEAR(actual.innovation[i], report.innovation[i], tolerance);
    }
    expect_sums_hold(robot);
}

void run_through(Robot& robot, const std::vector<Sample>& samples) {
    robot.add(samples);
    robot.finish();
}

TEST_P(ArrivalOrderTest, OfASetWithinTheWindowDoesNotMatter) {
    std::mt19937 generator(11);
    for (const Fusion fusion : {Fusion::plain, Fusion::gate, Fusion::student_t})
        for (const HeadingSource heading : {HeadingSource::gyro, HeadingSource::both}) {
            const Params params = robot_params(fusion, heading);
            std::vector<Sample> samples = noisy_drive(1.9, 21);
            Robot in_order(GetParam(), params, kSurveyedMarkers);
            run_through(in_order, samples);
            EXPECT_GT(in_order.tally.count(Verdict::fused), 300);
            EXPECT_EQ(in_order.tally.count(Verdict::counter_reset), 1);
            for (int trial = 0; trial < repeats(10); ++trial) {
                SCOPED_TRACE(trial);
                std::shuffle(samples.begin(), samples.end(), generator);
                Robot robot(GetParam(), params, kSurveyedMarkers);
                run_through(robot, samples);
                expect_same_outcome(robot, in_order, GetParam());
            }
        }
}

/// Each sample of a long drive is late by up to 1.9 s of the 2 s that the history holds.
TEST_P(ArrivalOrderTest, OfADriveWithDelaysWithinTheWindowDoesNotMatter) {
    const Params params = robot_params(Fusion::student_t, HeadingSource::gyro);
    for (int seed = 0; seed < repeats(4); ++seed) {
        SCOPED_TRACE(seed);
        const std::vector<Sample> samples = noisy_drive(10, static_cast<unsigned>(seed));
        Robot in_order(GetParam(), params, kSurveyedMarkers);
        run_through(in_order, samples);
        Draw draw(static_cast<unsigned>(100 + seed));
        std::vector<std::pair<double, std::size_t>> arrival;
        for (std::size_t i = 0; i < samples.size(); ++i)
            arrival.emplace_back(double(samples[i].utime) + draw.uniform(0, 1.9e6), i);
        std::sort(arrival.begin(), arrival.end());
        Robot robot(GetParam(), params, kSurveyedMarkers);
        for (const auto& [time, i] : arrival) robot.add(samples[i]);
        robot.finish();
        expect_same_outcome(robot, in_order, GetParam());
    }
}

TEST_P(ArrivalOrderTest, OfRepeatedSamplesDoesNotMatterEither) {
    const Params params = robot_params(Fusion::gate, HeadingSource::gyro);
    std::vector<Sample> samples = noisy_drive(1.5, 5);
    Robot in_order(GetParam(), params, kSurveyedMarkers);
    run_through(in_order, samples);
    const std::size_t once = samples.size();
    for (std::size_t i = 0; i < once; i += 3) samples.push_back(samples[i]);
    std::mt19937 generator(2);
    std::shuffle(samples.begin(), samples.end(), generator);
    Robot robot(GetParam(), params, kSurveyedMarkers);
    run_through(robot, samples);
    const int repeated = static_cast<int>(samples.size() - once);
    EXPECT_EQ(robot.tally.count(Verdict::duplicate), repeated);
    EXPECT_EQ(robot.tally.rejected(), in_order.tally.rejected() + repeated);
    EXPECT_TRUE(close(robot.state(), in_order.state(), GetParam().is_double ? 1e-9 : 1e-4));
    expect_sums_hold(robot);
}

TEST_P(ArrivalOrderTest, OfAResetAmongTheSamplesDoesNotMatter) {
    const Params params = robot_params(Fusion::plain, HeadingSource::both);
    std::vector<Sample> samples = noisy_drive(1.5, 8);
    samples.push_back(reset_at(700'001, {4, -2, 1}, {0.1, 0.2, 0.3}));
    std::sort(samples.begin(), samples.end(), InOrder{});
    Robot in_order(GetParam(), params, kSurveyedMarkers);
    run_through(in_order, samples);
    EXPECT_GE(in_order.estimate().resets, 1);
    std::mt19937 generator(7);
    for (int trial = 0; trial < repeats(20); ++trial) {
        std::shuffle(samples.begin(), samples.end(), generator);
        Robot robot(GetParam(), params, kSurveyedMarkers);
        run_through(robot, samples);
        expect_same_outcome(robot, in_order, GetParam());
        EXPECT_EQ(robot.estimate().resets, in_order.estimate().resets);
    }
}

}  // namespace
}  // namespace pilotage::test
