// Nothing is taken from the heap after construction, over a whole replay with late samples.

#include <algorithm>

#include "pilotage/localizer.hpp"
#include "support/allocations.hpp"
#include "support/images.hpp"
#include "support/journeys.hpp"
#include "support/random.hpp"
#include "support/robots.hpp"

#include <gtest/gtest.h>

namespace pilotage::test {
namespace {

/// Counts, and takes nothing from the heap itself.
struct Counter final : Listener {
    long verdicts[kVerdicts] = {};
    long sightings = 0;
    void on_verdict(const Sample&, Verdict before, Verdict now) override {
        --verdicts[static_cast<int>(before)];
        ++verdicts[static_cast<int>(now)];
    }
    void on_sighting(const SightingReport&) override { ++sightings; }
    [[nodiscard]] long count(Verdict v) const { return verdicts[static_cast<int>(v)]; }
};

/// A minute in the order of arrival: some samples late, some too late, repeated, bad, or after a
/// gap.
std::vector<Sample> rough_minute() {
    Draw draw(17);
    std::vector<std::pair<double, Sample>> arrivals;
    const auto send = [&](const Sample& sample) {
        const double late = draw.uniform(0, 1) < 0.1 ? draw.uniform(0, 2.2e6) : 0;
        arrivals.emplace_back(double(sample.utime) + late, sample);
        if (draw.uniform(0, 1) < 0.02) arrivals.emplace_back(double(sample.utime) + 1e5, sample);
    };
    for (const Sample& sample : drive(3000, 9, 11)) {
        if (sample.utime > 20 * kSecond && sample.utime < 23 * kSecond) continue;
        send(sample);
        send(gyro_at(sample.utime - 3000, draw.uniform(0.1, 0.3)));
        if (sample.utime % 50'000) continue;
        const double t = double(sample.utime) * 1e-6;
        for (std::uint16_t i = 0; i < 3; ++i) {
            Vector<double, 3> seen =
                view(after_arc({0, 0, 0}, 0.5 * t, 0.2 * t), kSurveyedMarkers.markers()[i]);
            seen[0] += 0.02 * draw.normal<double, 1>()(0);
            if (draw.uniform(0, 1) < 0.02) seen[2] = kInf;
            const int id = draw.uniform(0, 1) < 0.05 ? 7 : kSurveyedMarkers.markers()[i].id;
            send(sighting_at(sample.utime - 7000, id, only(seen, true, i == 0, i == 1), i));
        }
    }
    send(reset_at(30 * kSecond + 1, {0, 0, 0}, {1, 1, 1}));
    std::stable_sort(arrivals.begin(), arrivals.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Sample> samples;
    for (const auto& [time, sample] : arrivals) samples.push_back(sample);
    return samples;
}

template <typename Scalar, int N>
void expect_no_allocation(Fusion fusion) {
    const std::vector<Sample> samples = rough_minute();
    Params params = plain_params();
    params.motion.heading = HeadingSource::both;
    params.gyro_bias.sigma = 0.01;
    params.sensors[0].fusion = fusion;
    params.history.capacity = 512;
    Counter counter;
    Localizer<Scalar, N> localizer(params, kSurveyedMarkers, counter);
    const AllocationCount allocations;
    double sum = 0;
    for (const Sample& sample : samples) {
        localizer.add(sample);
        sum += localizer.estimate().pose[kX];
    }
    localizer.finish();
    EXPECT_EQ(allocations.since(), 0) << sum;
    EXPECT_GT(samples.size(), 7500U);
    EXPECT_GT(counter.count(Verdict::late), 5) << "the replay was to be rough";
    EXPECT_GT(counter.count(Verdict::duplicate), 100);
    EXPECT_GT(counter.count(Verdict::bad_value), 5);
    EXPECT_GT(counter.count(Verdict::fused), 7000);
    EXPECT_GT(counter.sightings, counter.count(Verdict::fused) / 5);
    EXPECT_EQ(counter.count(Verdict::pending), -static_cast<long>(samples.size()));
}

/// Stands, creeps, drives, slips, is lifted, goes silent, in the order of arrival: all sightings
/// half a second late, each tenth gyro sample too.
std::vector<Sample> faulty_minute(const MarkerMap& map) {
    Journey journey(map);
    journey.gyro_bias = 0.004;
    std::vector<std::pair<std::int64_t, Sample>> arrivals;
    const auto go = [&](double seconds, double v, double omega) {
        for (const Sample& sample : journey.go(seconds, v, omega)) {
            const bool late = sample.stream == Stream::sighting ||
                              (sample.stream == Stream::gyro && sample.seq % 10 == 0);
            arrivals.emplace_back(sample.utime + (late ? 500'000 : 0), sample);
        }
    };
    go(8, 0, 0);
    go(4, 0.002, 0.002);
    go(10, 0.3, 0.3);
    journey.left_spin_m_s = 0.6;
    go(5, 0.3, 0.3);
    journey.left_spin_m_s = 0;
    go(5, 0, 0);
    journey.carried_rad_s = 0.7;
    go(4, 0, 0);
    journey.carried_rad_s = 0;
    go(4, 0.3, 0);
    journey.encoders = journey.gyro = false;
    go(5, 0.3, 0);
    journey.encoders = journey.gyro = true;
    go(5, 0.3, 0.3);
    std::stable_sort(arrivals.begin(), arrivals.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Sample> samples;
    for (const auto& [time, sample] : arrivals) samples.push_back(sample);
    return samples;
}

template <typename Scalar, int N>
void expect_no_allocation_with_faults() {
    const MarkerMap& map = kAroundOrigin;
    const std::vector<Sample> samples = faulty_minute(map);
    Params params = gyro_params();
    params.gyro_bias.sigma = 0.01;
    Counter counter;
    Localizer<Scalar, N> before(params, map, counter), localizer(params, map, counter);
    for (int i = 0; i < 50; ++i) before.add(samples[static_cast<std::size_t>(i)]);
    const AllocationCount allocations;
    EXPECT_TRUE(localizer.restore(before.checkpoint()));
    bool seen[4] = {};
    double sum = 0;
    std::int64_t shift = 0;
    for (const Sample& arrived : samples) {
        Sample sample = arrived;
        if (shift == 0 && sample.utime > 20 * kSecond) {
            shift = 3600 * kSecond;
            localizer.add(sighting_at(sample.utime + 1, 1, {0.3, kNan, kNan}));
            localizer.set_time(localizer.estimate().utime + shift);
        }
        sample.utime += shift;
        localizer.add(sample);
        const Estimate e = localizer.estimate();
        seen[static_cast<int>(e.motion)] = true;
        sum += localizer.estimate(e.utime + 700'000).pose[kX] + localizer.checkpoint().state[0];
    }
    localizer.finish();
    EXPECT_EQ(allocations.since(), 0) << sum;
    for (int i = 0; i < 4; ++i) EXPECT_TRUE(seen[i]) << "motion state " << i << " was to be met";
    EXPECT_EQ(counter.count(Verdict::no_motion), 1) << "waited when the clock was set";
    EXPECT_GT(counter.count(Verdict::fused), 5000);
}

TEST(AllocationTest, NoneWithStandstillSlipLiftGapsLateSamplesAndARestart) {
    expect_no_allocation_with_faults<double, 3>();
    expect_no_allocation_with_faults<double, 6>();
    expect_no_allocation_with_faults<float, 3>();
    expect_no_allocation_with_faults<float, 6>();
}

/// Starts anywhere, among markers without ids, the symmetry of which is broken late; is carried
/// off; elevations alone go wrong. Every third frame comes late.
std::vector<Sample> lost_drive(const MarkerMap& map) {
    const MarkerMap rectangle({map.markers().begin(), map.markers().begin() + 4});
    MarkerMap seen = rectangle;
    Journey journey(seen);
    journey.truth = {1, 0.5, -2};
    journey.ids = false;
    journey.elevation = true;
    std::vector<std::pair<std::int64_t, Sample>> arrivals;
    const auto go = [&](double seconds, double off_rad) {
        for (Sample& sample : journey.go(seconds, 0.4, 0.3)) {
            const bool late = sample.stream == Stream::sighting && sample.seq % 3 == 0;
            if (sample.stream == Stream::sighting) sample.payload.sighting.value[1] += off_rad;
            arrivals.emplace_back(sample.utime + (late ? 500'000 : 0), sample);
        }
    };
    go(2, 0);
    seen = map;
    go(4, 0);
    journey.truth[kX] += 3;
    go(3, 0);
    go(3, 0.3);
    std::stable_sort(arrivals.begin(), arrivals.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Sample> samples;
    for (const auto& [time, sample] : arrivals) samples.push_back(sample);
    return samples;
}

template <typename Scalar, int N>
void expect_no_allocation_where_lost() {
    const MarkerMap map({{1, 5, 3, 0.4, 0},
                         {2, -5, 3, 0.4, 0},
                         {3, -5, -3, 0.4, 0},
                         {4, 5, -3, 0.4, 0},
                         {5, 1, 6, 0.4, 0.01}});
    const std::vector<Sample> samples = lost_drive(map);
    Params params = gyro_params();
    params.initial = {};
    params.tilt.pitch_sigma_rad = params.tilt.roll_sigma_rad = 0.01;
    Counter counter;
    Localizer<Scalar, N> localizer(params, map, counter);
    const AllocationCount allocations;
    bool ambiguous = false, lost = false, refound = false;
    for (const Sample& sample : samples) {
        localizer.add(sample);
        const Estimate e = localizer.estimate();
        ambiguous |= e.status == Status::ambiguous;
        lost |= e.status == Status::lost;
        refound |= e.status == Status::ok && e.resets == 1;
    }
    localizer.finish();
    EXPECT_EQ(allocations.since(), 0);
    EXPECT_TRUE(ambiguous && lost && refound) << ambiguous << lost << refound;
    EXPECT_GT(counter.count(Verdict::not_initialized), 60);
    EXPECT_GT(counter.count(Verdict::fused), 1400);
}

TEST(AllocationTest, NoneWhereThePoseIsSearchedForAndMarkersAreFound) {
    expect_no_allocation_where_lost<double, 3>();
    expect_no_allocation_where_lost<double, 6>();
    expect_no_allocation_where_lost<double, 8>();
    expect_no_allocation_where_lost<float, 3>();
    expect_no_allocation_where_lost<float, 6>();
}

/// Images without ids, half of them late, from nothing to a pose and after the robot was carried
/// off.
template <typename Scalar, int N>
void expect_no_allocation_with_pixels(double radius_px, Filter filter) {
    const MarkerMap map({{1, 5, 3, 0.4, 0},
                         {2, -5, 3, 0.4, 0.01},
                         {3, -5, -3, 0.4, 0},
                         {4, 5, -3, 0.4, 0},
                         {5, 1, 6, 0.4, 0},
                         {6, 4, 0, 0.4, 0}});
    Params params = gyro_params();
    params.initial = {};
    params.filter = filter;
    params.sensors[0] = camera_sensor();
    params.sensors[0].association_radius_pixel = radius_px;
    params.noise.adaptation = NoiseAdaptation::on;
    FilmedJourney film(map, params.sensors[0]);
    film.ids = false;
    std::vector<std::pair<std::int64_t, Sample>> arrivals;
    for (int leg = 0; leg < 2; ++leg) {
        for (const Sample& sample : film.go(8, 0.4, 0.5)) {
            const bool late = sample.stream == Stream::sighting && sample.seq % 2 == 0;
            arrivals.emplace_back(sample.utime + (late ? 500'000 : 0), sample);
        }
        film.journey.truth = {-1, 1, 2};
    }
    std::stable_sort(arrivals.begin(), arrivals.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    Counter counter;
    Localizer<Scalar, N> localizer(params, map, counter);
    const AllocationCount allocations;
    for (const auto& [time, sample] : arrivals) localizer.add(sample);
    localizer.add(sighting_at(localizer.estimate().utime, 1, {-5, 7, kNan}));
    localizer.finish();
    EXPECT_EQ(allocations.since(), 0);
    EXPECT_EQ(counter.count(Verdict::outside_image), 1);
    EXPECT_TRUE(localizer.has_pose());
    EXPECT_GT(counter.sightings, 200);
}

TEST(AllocationTest, NoneWithPixels) {
    expect_no_allocation_with_pixels<double, 3>(0, Filter::ekf);
    expect_no_allocation_with_pixels<double, 8>(0, Filter::ukf);
    expect_no_allocation_with_pixels<float, 3>(64, Filter::ukf);
    expect_no_allocation_with_pixels<float, 6>(0, Filter::ekf);
}

TEST(AllocationTest, NoneInDoubleWithThreeStates) {
    expect_no_allocation<double, 3>(Fusion::student_t);
    expect_no_allocation<double, 3>(Fusion::gate);
}
TEST(AllocationTest, NoneInDoubleWithSixStates) {
    expect_no_allocation<double, 6>(Fusion::student_t);
}
TEST(AllocationTest, NoneInFloatWithThreeStates) {
    expect_no_allocation<float, 3>(Fusion::plain);
}
TEST(AllocationTest, NoneInFloatWithSixStates) {
    expect_no_allocation<float, 6>(Fusion::gate);
}

}  // namespace
}  // namespace pilotage::test
