// The start without any prior: the sightings of some frames tell where the robot is.

#include <algorithm>

#include "support/journeys.hpp"
#include "support/localizers.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_LOCALIZER_SUITE(StartTest);

/// No symmetry, no two distances alike, and high enough to tell the distance by the elevation.
const MarkerMap kOverheadMarkers({{1, 6, 2, 2.5, 0}, {2, -3, 5, 2.2, 0}, {3, 2, -5, 2.0, 0}});

const Pose<double> kBegin(0.5, -0.4, 2);

Params nowhere() {
    Params params = gyro_params();
    params.initial = {};
    return params;
}

/// Drives a bend until the robot has found itself, no longer than so many seconds.
void drive_until_found(Robot& robot, Journey& journey, double at_most_s) {
    for (double s = 0; s < at_most_s && !robot.has_pose(); s += 0.1)
        robot.add(journey.go(0.1, 0.4, 0.3));
}

struct StartSight {
    const char* name;
    int markers;
    bool bearing, elevation, range, ids;
    double within_s;
};

TEST_P(StartTest, FindsThePoseFromWhateverTellsIt) {
    for (const StartSight& sight :
         {StartSight{"3 bearings", 3, true, false, false, true, 1},
          StartSight{"2 bearings and ranges", 2, true, false, true, true, 1},
          StartSight{"2 bearings and elevations", 2, true, true, false, true, 2},
          StartSight{"3 ranges", 3, false, false, true, true, 5},
          StartSight{"no ids", 3, true, false, true, false, 1.5}}) {
        SCOPED_TRACE(sight.name);
        for (unsigned seed = 1; seed <= 3; ++seed) {
            const MarkerMap seen({kOverheadMarkers.markers().begin(),
                                  kOverheadMarkers.markers().begin() + sight.markers});
            Journey journey(seen, seed);
            journey.truth = kBegin;
            journey.bearing = sight.bearing;
            journey.elevation = sight.elevation;
            journey.range = sight.range;
            journey.ids = sight.ids;
            Robot robot(GetParam(), nowhere(), kOverheadMarkers);
            drive_until_found(robot, journey, sight.within_s);
            ASSERT_TRUE(robot.has_pose()) << "seed " << seed;
            const Estimate e = robot.estimate();
            EXPECT_LT(contradiction(e.pose, e.covariance, journey.truth), kRare);
            EXPECT_EQ(e.resets, 0) << "a start is no jump";
            robot.add(journey.go(2, 0.4, 0.3));
            EXPECT_EQ(robot.estimate().status, Status::ok);
            EXPECT_TRUE(same_pose(robot.pose(), journey.truth, 0.3));
            expect_sums_hold(robot);
        }
    }
}

TEST_P(StartTest, SaysWhatItWaitsForUntilItIsOk) {
    Journey journey(kOverheadMarkers);
    journey.truth = kBegin;
    Robot robot(GetParam(), nowhere(), kOverheadMarkers);
    EXPECT_EQ(robot.estimate().reason, Reason::no_motion);
    robot.add(gyro_at(1, 0));
    std::vector<std::pair<Status, Reason>> said;
    for (int i = 0; i < 100; ++i) {
        robot.add(journey.go(0.02, 0.4, 0.3));
        const Estimate e = robot.estimate();
        EXPECT_EQ(e.status == Status::waiting || e.reason == Reason::found, !robot.has_pose());
        EXPECT_TRUE(e.reason != Reason::found || e.value <= e.limit) << e.value << " frames";
        if (said.empty() || said.back().second != e.reason) said.emplace_back(e.status, e.reason);
    }
    const std::vector<std::pair<Status, Reason>> expected{{Status::waiting, Reason::no_pose},
                                                          {Status::initializing, Reason::found},
                                                          {Status::ok, Reason::none}};
    EXPECT_EQ(said, expected);
}

TEST_P(StartTest, CountsTheSightingsBeforeItAsNotInitialized) {
    Journey journey(kOverheadMarkers);
    journey.truth = kBegin;
    Robot robot(GetParam(), nowhere(), kOverheadMarkers);
    std::vector<Sample> before, after;
    while (!robot.has_pose() && before.size() < 1000)
        for (const Sample& sample : journey.go(0.02, 0.4, 0.3)) {
            (robot.has_pose() ? after : before).push_back(sample);
            robot.add(sample);
        }
    for (const Sample& sample : journey.go(1, 0.4, 0.3)) {
        after.push_back(sample);
        robot.add(sample);
    }
    robot.finish();
    int unused = 0;
    for (const Sample& sample : before) {
        if (sample.stream != Stream::sighting) continue;
        EXPECT_EQ(robot.tally.of(sample), Verdict::not_initialized);
        const SightingReport& report = robot.tally.reports[static_cast<std::size_t>(unused++)];
        EXPECT_EQ(report.verdict, Verdict::not_initialized);
        EXPECT_EQ(report.dof, 2);
        EXPECT_EQ(report.weight, 0);
        EXPECT_TRUE(std::isnan(report.nis));
    }
    EXPECT_GE(unused, 9) << "three frames of three";
    EXPECT_EQ(robot.tally.count(Verdict::not_initialized), unused);
    for (const Sample& sample : after)
        EXPECT_EQ(robot.tally.of(sample),
                  sample.stream != Stream::sighting || sample.utime < journey.utime
                      ? Verdict::fused
                      : Verdict::no_motion);
    expect_sums_hold(robot);
}

TEST_P(StartTest, IsFoundWhateverTheTime) {
    for (const std::int64_t utime : {-1'000 * kSecond, std::int64_t{0}, 1'700'000'000 * kSecond}) {
        Journey journey(kOverheadMarkers);
        journey.truth = kBegin;
        journey.utime = utime;
        Robot robot(GetParam(), nowhere(), kOverheadMarkers);
        robot.add(journey.go(2, 0.4, 0.3));
        EXPECT_EQ(robot.estimate().status, Status::ok) << utime;
    }
}

TEST_P(StartTest, FromTwoBearingsThatStayTheSameIsNone) {
    const MarkerMap seen({kOverheadMarkers.markers()[0], kOverheadMarkers.markers()[1]});
    Journey journey(seen);
    journey.truth = kBegin;
    journey.range = false;
    Robot robot(GetParam(), nowhere(), kOverheadMarkers);
    robot.add(journey.go(10));
    EXPECT_FALSE(robot.has_pose()) << "an arc of poses explains them, and it stands";
    EXPECT_NE(robot.estimate().status, Status::ok);
}

struct Symmetric {
    MarkerMap map, seen{kRectangle};
    Journey journey{seen};
    Robot robot;

    explicit Symmetric(const LocalizerKind& kind) : map(broken()), robot(kind, nowhere(), map) {
        journey.truth = kBegin;
        journey.ids = false;
    }
    [[nodiscard]] static MarkerMap broken() {
        std::vector<Marker> markers = kRectangle.markers();
        markers.push_back({5, 1, 6, 0, 0});
        return MarkerMap(markers);
    }
    void go(double seconds) { robot.add(journey.go(seconds, 0.4, 0.3)); }
};

TEST_P(StartTest, OnASymmetricSiteStaysAmbiguousUntilAMarkerBreaksTheSymmetry) {
    Symmetric s(GetParam());
    s.go(1);
    for (int i = 0; i < 200; ++i) {
        s.go(0.1);
        ASSERT_EQ(s.robot.estimate().status, Status::ambiguous) << "after " << i << " frames";
        ASSERT_EQ(s.robot.estimate().reason, Reason::rival);
        ASSERT_FALSE(s.robot.has_pose());
    }
    s.seen = s.map;
    s.go(2);
    EXPECT_EQ(s.robot.estimate().status, Status::ok);
    EXPECT_TRUE(same_pose(s.robot.pose(), s.journey.truth, 0.15));
}

TEST_P(StartTest, OnASymmetricSiteIsDecidedByAPoseFromOutside) {
    for (const bool mirrored : {false, true}) {
        Symmetric s(GetParam());
        s.go(5);
        ASSERT_EQ(s.robot.estimate().status, Status::ambiguous);
        Pose<double> about = s.journey.truth + Pose<double>(0.2, -0.2, 0.1);
        if (mirrored) about = {-about[kX], -about[kY], about[kHeading] + kPi<double>};
        s.robot.add(reset_at(s.journey.utime + 1, about, {0.3, 0.3, 0.1}));
        s.go(0.02);
        EXPECT_EQ(s.robot.estimate().status, Status::initializing);
        s.go(2);
        EXPECT_EQ(s.robot.estimate().status, Status::ok) << "whoever set it knows";
        Pose<double> there = s.journey.truth;
        if (mirrored) there = {-there[kX], -there[kY], there[kHeading] + kPi<double>};
        EXPECT_TRUE(same_pose(s.robot.pose(), there, 0.15));
        EXPECT_EQ(s.robot.estimate().resets, 0) << "there was no pose before";
    }
}

/// Frames that come late, in pieces and in any order are put where they belong.
TEST_P(StartTest, IsTheSameInWhateverOrderItsFramesArrive) {
    Journey journey(kOverheadMarkers, 5);
    journey.truth = kBegin;
    const std::vector<Sample> ordered = journey.go(4, 0.4, 0.3);
    Robot in_order(GetParam(), nowhere(), kOverheadMarkers);
    in_order.add(ordered);
    in_order.finish();
    ASSERT_TRUE(in_order.has_pose());
    for (const unsigned seed : {1U, 2U, 3U}) {
        Draw draw(seed);
        std::vector<std::pair<double, Sample>> arrivals;
        for (const Sample& sample : ordered) {
            const double late_us =
                sample.stream == Stream::sighting ? draw.uniform(0, 1'800'000) : 0;
            arrivals.emplace_back(double(sample.utime) + late_us, sample);
        }
        std::stable_sort(arrivals.begin(), arrivals.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        Robot late(GetParam(), nowhere(), kOverheadMarkers);
        for (const auto& [time, sample] : arrivals) late.add(sample);
        late.finish();
        EXPECT_EQ(in_order.state(), late.state());
        EXPECT_EQ(in_order.covariance(), late.covariance());
        EXPECT_EQ(in_order.estimate().status, late.estimate().status);
        EXPECT_EQ(in_order.estimate().resets, late.estimate().resets);
        for (const auto& [sample, verdict] : in_order.tally.verdicts())
            EXPECT_EQ(late.tally.of(sample), verdict) << sample.utime;
        expect_sums_hold(late);
    }
}

TEST_P(StartTest, IsNotMisledBySightingsOfOtherThings) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        Journey journey(kOverheadMarkers, seed);
        journey.truth = kBegin;
        Draw draw(seed);
        Robot robot(GetParam(), nowhere(), kOverheadMarkers);
        for (int frame = 0; frame < 40; ++frame) {
            for (Sample sample : journey.go(0.1, 0.4, 0.3)) {
                if (sample.stream == Stream::sighting && draw.uniform(0, 1) < 0.2)
                    sample.payload.sighting.value[0] = draw.uniform(-3.1, 3.1);
                robot.add(sample);
            }
            if (robot.estimate().status != Status::ok) continue;
            EXPECT_TRUE(same_pose(robot.pose(), journey.truth, 0.4)) << "frame " << frame;
        }
        EXPECT_TRUE(robot.has_pose());
    }
}

}  // namespace
}  // namespace pilotage::test
