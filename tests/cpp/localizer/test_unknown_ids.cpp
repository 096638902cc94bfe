// Sightings without ids through the localizer: recognised a frame at a time, fused as with ids.

#include <algorithm>

#include "support/allocations.hpp"
#include "support/journeys.hpp"
#include "support/localizers.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_LOCALIZER_SUITE(UnknownIdTest);

const MarkerMap kTwoSideBySide(
    {{1, 6, 2, 0.4, 0}, {2, -3, 5, 0.3, 0}, {3, 4, -4, 0.2, 0}, {4, 4, -4.1, 0.2, 0}});

std::vector<Sample> without_ids(std::vector<Sample> samples) {
    for (Sample& sample : samples)
        if (sample.stream == Stream::sighting) sample.payload.sighting.id = kUnknownId;
    return samples;
}

/// A standing robot that sees these, all at once.
std::vector<Sample> stand_and_see(const std::vector<Vector<double, 3>>& seen) {
    std::vector<Sample> samples = drive(2, 0, 0);
    for (std::size_t i = 0; i < seen.size(); ++i)
        samples.insert(samples.begin() + 1 + static_cast<std::ptrdiff_t>(i),
                       sighting_at(10'000, kUnknownId, seen[i], static_cast<std::uint16_t>(i)));
    return samples;
}

Vector<double, 3> seen_of(int id) {
    return view({0, 0, 0}, *kTwoSideBySide.find(id));
}

TEST_P(UnknownIdTest, AreFusedAsOfTheMarkerFound) {
    std::vector<Sample> anonymous = stand_and_see({seen_of(2), seen_of(1)}), named = anonymous;
    named[1].payload.sighting.id = 2;
    named[2].payload.sighting.id = 1;
    Robot found(GetParam(), plain_params(), kTwoSideBySide),
        known(GetParam(), plain_params(), kTwoSideBySide);
    found.add(anonymous);
    known.add(named);
    EXPECT_EQ(found.state(), known.state());
    EXPECT_EQ(found.covariance(), known.covariance());
    ASSERT_EQ(found.tally.reports.size(), 2U);
    EXPECT_EQ(found.tally.reports[0].id, 2) << "the report says of which marker";
    EXPECT_EQ(found.tally.reports[1].id, 1);
    EXPECT_EQ(found.tally.of(anonymous[1]), Verdict::fused);
    expect_sums_hold(found);
}

TEST_P(UnknownIdTest, ThatCannotBeToldSayWhy) {
    const auto samples = stand_and_see({{2, kNan, 3}, seen_of(3), seen_of(1)});
    Robot robot(GetParam(), plain_params(), kTwoSideBySide);
    robot.add(samples);
    const Verdict expected[] = {Verdict::no_match, Verdict::ambiguous_match, Verdict::fused};
    ASSERT_EQ(robot.tally.reports.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(robot.tally.reports[i].verdict, expected[i]);
        EXPECT_EQ(robot.tally.of(samples[i + 1]), expected[i]);
    }
    EXPECT_EQ(robot.tally.reports[0].id, kUnknownId);
    expect_sums_hold(robot);
}

/// Markers 3 and 4 stand 0.1 m apart: the one beside it in the frame tells which it is.
TEST_P(UnknownIdTest, UseWhatTheFrameKnowsBeforeAndAfterThem) {
    for (const std::size_t named : {1U, 2U}) {
        auto samples = stand_and_see({seen_of(3), seen_of(3)});
        samples[named].payload.sighting.id = 4;
        Robot robot(GetParam(), plain_params(), kTwoSideBySide);
        robot.add(samples);
        ASSERT_EQ(robot.tally.reports.size(), 2U);
        EXPECT_EQ(robot.tally.reports[2 - named].id, 3);
    }
}

TEST_P(UnknownIdTest, OfOtherFramesAreNoRivals) {
    auto samples = stand_and_see({seen_of(1), seen_of(1)});
    samples[2].seq = 1;
    Robot robot(GetParam(), plain_params(), kTwoSideBySide);
    robot.add(samples);
    EXPECT_EQ(robot.tally.count(Verdict::fused), 5) << "one marker in two frames";
}

TEST_P(UnknownIdTest, OfAFrameWithoutEndAreTakenInParts) {
    std::vector<Vector<double, 3>> many(100, Vector<double, 3>(2, kNan, 3));
    many[70] = seen_of(1);
    Robot robot(GetParam(), plain_params(), kTwoSideBySide);
    robot.add(stand_and_see(many));
    EXPECT_EQ(robot.tally.count(Verdict::no_match), 99);
    EXPECT_EQ(robot.tally.reports[70].id, 1);
}

/// Whatever comes late, and frames in pieces: the estimate is that of the right order.
TEST_P(UnknownIdTest, InAnyOrderGiveTheSame) {
    const MarkerMap& map = kAroundOrigin;
    const std::vector<Sample> ordered = without_ids(Journey(map, 3).go(6, 0.4, 0.4));
    std::vector<std::pair<double, Sample>> arrivals;
    Draw draw(8);
    for (const Sample& sample : ordered)
        arrivals.emplace_back(
            double(sample.utime) +
                (sample.stream == Stream::sighting ? draw.uniform(0, 500'000) : 0),
            sample);
    std::stable_sort(arrivals.begin(), arrivals.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    Robot in_order(GetParam(), gyro_params(), map), late(GetParam(), gyro_params(), map);
    in_order.add(ordered);
    for (const auto& [time, sample] : arrivals) late.add(sample);
    for (Robot* robot : {&in_order, &late}) robot->finish();
    EXPECT_EQ(in_order.state(), late.state());
    EXPECT_EQ(in_order.covariance(), late.covariance());
    EXPECT_EQ(in_order.tally.verdicts().size(), late.tally.verdicts().size());
    for (const auto& [sample, verdict] : in_order.tally.verdicts())
        EXPECT_EQ(late.tally.of(sample), verdict);
}

/// Ten markers, two loops of an eight, every hundredth sighting a stray.
TEST_P(UnknownIdTest, CostNextToNoAccuracyOnAFigureEight) {
    const MarkerMap map({{1, 4, 1, 0, 0},
                         {2, -3, 4, 0, 0},
                         {3, 5, -4, 0, 0},
                         {4, -6, -1, 0, 0},
                         {5, 0, 6, 0, 0},
                         {6, 8, 3, 0, 0},
                         {7, -4, -5, 0, 0},
                         {8, 1, -7, 0, 0},
                         {9, -8, 4, 0, 0},
                         {10, 4, 7, 0, 0}});
    Robot known(GetParam(), gyro_params(), map), found(GetParam(), gyro_params(), map);
    Journey journey(map, 5);
    double known_square = 0, found_square = 0;
    for (int lap = 0; lap < 4; ++lap)
        for (int step = 0; step < 785; ++step) {  // a circle of 2 m
            std::vector<Sample> samples = journey.go(0.02, 0.8, lap % 2 == 0 ? 0.4 : -0.4);
            for (Sample& sample : samples)
                if (sample.stream == Stream::sighting && (sample.seq + sample.index) % 100 == 0)
                    sample.payload.sighting.value[0] += 1;
            known.add(samples);
            found.add(without_ids(samples));
            const Pose<double> of_known = known.pose() - journey.truth,
                               of_found = found.pose() - journey.truth;
            known_square += of_known.head<2>().squaredNorm();
            found_square += of_found.head<2>().squaredNorm();
        }
    EXPECT_LE(std::sqrt(found_square), 1.05 * std::sqrt(known_square));
    EXPECT_LT(std::sqrt(found_square / (4 * 785)), 0.05);
    EXPECT_GT(found.tally.count(Verdict::no_match), 0);
    EXPECT_GT(found.tally.count(Verdict::fused), 0.97 * known.tally.count(Verdict::fused));
    for (const SightingReport& report : found.tally.reports)
        EXPECT_TRUE(rejected(report.verdict) || report.id == report.index + 1) << report.utime;
}

TEST_P(UnknownIdTest, TakeNothingFromTheHeap) {
    struct Nobody final : Listener {
        void on_verdict(const Sample&, Verdict, Verdict) override {}
        void on_sighting(const SightingReport&) override {}
    } nobody;
    const MarkerMap& map = kAroundOrigin;
    const auto samples = without_ids(Journey(map, 3).go(10, 0.4, 0.4));
    Localizer<double, kPoseStates> localizer(gyro_params(), map, nobody);
    const AllocationCount allocations;
    for (const Sample& sample : samples) localizer.add(sample);
    localizer.finish();
    EXPECT_EQ(allocations.since(), 0);
}

}  // namespace
}  // namespace pilotage::test
