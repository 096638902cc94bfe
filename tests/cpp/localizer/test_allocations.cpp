// Nothing is taken from the heap after construction, over a whole replay with late samples.

#include <algorithm>

#include "pilotage/localizer.hpp"
#include "support/allocations.hpp"
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

const MarkerMap kMap({{1, 6, 2, 0.4, 0.01}, {2, -3, 5, 0, 0}, {3, 4, -4, 0, 0.02}});

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
                view(after_arc({0, 0, 0}, 0.5 * t, 0.2 * t), kMap.markers()[i]);
            seen[0] += 0.02 * draw.normal<double, 1>()(0);
            if (draw.uniform(0, 1) < 0.02) seen[2] = kInf;
            const int id = draw.uniform(0, 1) < 0.05 ? 7 : kMap.markers()[i].id;
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
    Localizer<Scalar, N> localizer(params, kMap, counter);
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
