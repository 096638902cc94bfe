// Every pose that explains what was seen, and how sure each is.

#include "pilotage/search/pose_search.hpp"

#include "support/allocations.hpp"
#include "support/geometry.hpp"
#include "support/matchers.hpp"
#include "support/random.hpp"
#include "support/sighting_drives.hpp"

namespace pilotage::test {
namespace {

using Mix = Vector<double, 3>;  // 1 where the component is measured
const Mix kBearings(1, 0, 0), kAngles(1, 1, 0), kPoints(1, 0, 1), kRanges(0, 0, 1);

Params one_sensor() {
    Params params;
    params.sensor_count = 1;
    params.sensors[0].x_m = 0.3;
    params.sensors[0].yaw_rad = 0.2;
    params.sensors[0].z_m = 1.5;
    return params;
}

/// Newest first: all markers seen from each of the poses, the last of which is now.
std::vector<Evidence> all_seen(const MarkerMap& map, const std::vector<Pose<double>>& poses,
                               const Mix& mix, bool ids) {
    std::vector<Evidence> result;
    for (auto pose = poses.rbegin(); pose != poses.rend(); ++pose)
        for (const Marker& marker : map.markers())
            result.push_back(
                exact_evidence(*pose, marker, mix, ids ? marker.id : -1, one_sensor().sensors[0]));
    return result;
}

std::vector<Hypothesis> found(const MarkerMap& map, const std::vector<Evidence>& evidence) {
    PoseSearch search(one_sensor(), map);
    const Hypotheses h = search.run(evidence.data(), static_cast<int>(evidence.size()));
    return {h.begin(), h.end()};
}

bool among(const std::vector<Hypothesis>& hypotheses, const Pose<double>& pose, double tolerance) {
    return std::any_of(hypotheses.begin(), hypotheses.end(),
                       [&](const Hypothesis& h) { return minus(h.pose, pose).norm() < tolerance; });
}

const std::vector<Pose<double>> kDrive{{1, -2, 0.6}, {1.8, -1.5, 0.9}, {2.2, -0.8, 1.1}};

TEST(PoseSearchTest, ExactSightingsOfAnyMixGiveThePoseFirst) {
    MarkerMap few({{1, -4, 1, 0, 0}, {2, 5, 3, 0, 0}, {3, 1, 6, 0, 0}, {5, 7, -6, 0, 0}});
    for (const bool ids : {true, false})
        for (const Mix& mix : {kBearings, kAngles, kPoints, kRanges}) {
            const auto hypotheses = found(few, all_seen(few, kDrive, mix, ids));
            ASSERT_FALSE(hypotheses.empty());
            EXPECT_TRUE(same_pose(hypotheses[0].pose, kDrive.back(), 0.01))
                << mix.transpose() << " ids " << ids;
            EXPECT_EQ(hypotheses[0].sightings, 12);
            EXPECT_EQ(hypotheses[0].markers.count(), 4);
        }
}

TEST(PoseSearchTest, TwoMarkersSeenOnTheWayAreEnough) {
    const MarkerMap two({{1, -4, 1, 0, 0}, {2, 5, 3, 0, 0}});
    for (const Mix& mix : {kBearings, kAngles, kPoints}) {
        const auto hypotheses = found(two, all_seen(two, kDrive, mix, true));
        ASSERT_FALSE(hypotheses.empty());
        EXPECT_TRUE(same_pose(hypotheses[0].pose, kDrive.back(), 0.02)) << mix.transpose();
    }
}

TEST(PoseSearchTest, OneSensorsBearingsAndAnothersRangesGoTogether) {
    const MarkerMap map({{1, -4, 1, 0, 0}, {2, 5, 3, 0, 0}, {3, 1, 6, 0, 0}, {5, 7, -6, 0, 0}});
    auto evidence = all_seen(map, kDrive, kBearings, true);
    const auto ranges = all_seen(map, kDrive, kRanges, true);
    for (std::size_t i = 0; i < evidence.size(); i += 2) evidence[i] = ranges[i];
    const auto hypotheses = found(map, evidence);
    ASSERT_FALSE(hypotheses.empty());
    EXPECT_TRUE(same_pose(hypotheses[0].pose, kDrive.back(), 0.01));
}

TEST(PoseSearchTest, ASymmetricMapGivesBothPosesWithTheSameEvidence) {
    const MarkerMap square(
        {{1, 3, 5, 0, 0}, {2, -3, 5, 0, 0}, {3, -3, -5, 0, 0}, {4, 3, -5, 0, 0}});
    const Pose<double> there(-2.2, 0.8, 1.1 - kPi<double>);
    for (const Mix& mix : {kBearings, kAngles, kPoints, kRanges}) {
        const auto hypotheses = found(square, all_seen(square, kDrive, mix, false));
        ASSERT_GE(hypotheses.size(), 2U) << mix.transpose();
        EXPECT_TRUE(among({hypotheses[0], hypotheses[1]}, kDrive.back(), 0.02)) << mix.transpose();
        EXPECT_TRUE(among({hypotheses[0], hypotheses[1]}, there, 0.02)) << mix.transpose();
        EXPECT_NEAR(hypotheses[0].log_evidence, hypotheses[1].log_evidence, 0.01);
        EXPECT_NEAR(hypotheses[0].gain, hypotheses[1].gain, 0.01);
    }
}

TEST(PoseSearchTest, RangesOfBeaconsInALineLeaveTheMirrorImage) {
    const MarkerMap line({{1, -8, 4, 0, 0}, {2, 0, 4, 0, 0}, {3, 5, 4, 0, 0}});
    const Pose<double> here(2, -1, 0.5), mirrored(2, 9, -0.5);
    const auto behind = [&](double metres) {
        return Pose<double>(here[kX] - metres * std::cos(0.5), here[kY] - metres * std::sin(0.5),
                            0.5);
    };
    const auto hypotheses =
        found(line, all_seen(line, {behind(1.5), behind(0.75), here}, kRanges, true));
    ASSERT_GE(hypotheses.size(), 2U);
    EXPECT_TRUE(among({hypotheses[0], hypotheses[1]}, here, 0.05));
    EXPECT_TRUE(among({hypotheses[0], hypotheses[1]}, mirrored, 0.05));
    EXPECT_NEAR(hypotheses[0].log_evidence, hypotheses[1].log_evidence, 0.01);
}

TEST(PoseSearchTest, RangesFromOnePlaceLeaveTheHeadingOpen) {
    const auto hypotheses = found(kYard, all_seen(kYard, {{1, 2, 0.5}}, kRanges, true));
    ASSERT_FALSE(hypotheses.empty());
    for (const Hypothesis& h : hypotheses)
        EXPECT_TRUE(hypotheses.size() > 1 || h.covariance(kHeading, kHeading) > 1);
}

TEST(PoseSearchTest, OneMarkerOrNothingGivesNoPose) {
    const MarkerMap one({{1, 4, 4, 0, 0}});
    for (const Mix& mix : {kBearings, kAngles, kPoints, kRanges})
        EXPECT_TRUE(found(one, all_seen(one, kDrive, mix, true)).empty());
    EXPECT_TRUE(found(kYard, {}).empty());
    EXPECT_TRUE(found(MarkerMap(), all_seen(kYard, kDrive, kPoints, true)).empty());
}

TEST(PoseSearchTest, SightingsOfUnknownMarkersDoNotCount) {
    const MarkerMap map({{1, -4, 1, 0, 0}, {2, 5, 3, 0, 0}, {3, 1, 6, 0, 0}});
    auto evidence = all_seen(map, kDrive, kPoints, true);
    auto stranger = evidence[0];
    stranger.sighting.id = 99;
    evidence.insert(evidence.begin() + 1, stranger);
    EXPECT_TRUE(among(found(map, evidence), kDrive.back(), 0.01));
}

TEST(PoseSearchTest, AGuessIsJudgedWithTheOthers) {
    PoseSearch search(one_sensor(), kYard);
    const auto evidence = all_seen(kYard, {kDrive.back()}, {1, 0, 0}, true);
    const Pose<double> guess = kDrive.back() + Pose<double>(0.1, 0.1, 0.05);
    const Hypotheses h = search.run(evidence.data(), 1, &guess, 1);
    ASSERT_EQ(h.count, 0);  // one sighting proves nothing
    EXPECT_GE(search.run(evidence.data(), 3, &guess, 1).count, 1);
}

TEST(PoseSearchTest, CarriedOffTheNewestSightingsSpeakForTheNewPlace) {
    const MarkerMap& map = kYard;
    auto evidence = all_seen(map, {{-3, 2, 2.5}}, kPoints, true);
    const auto before = all_seen(map, kDrive, kPoints, true);
    evidence.resize(6);
    for (Evidence& e : evidence) e.log_likelihood = -std::numeric_limits<double>::infinity();
    PoseSearch search(one_sensor(), map);
    for (Evidence e : before) {
        if (evidence.size() == 32) break;
        e.log_likelihood = 4.5;  // as good as it gets
        evidence.push_back(e);
    }
    const Hypotheses h = search.run(evidence.data(), static_cast<int>(evidence.size()));
    ASSERT_GE(h.count, 1);
    EXPECT_TRUE(same_pose(h[0].pose, Pose<double>(-3, 2, 2.5), 0.02));
    EXPECT_EQ(h[0].explained, 6);
    EXPECT_GT(h[0].gain, 20);
}

TEST(PoseSearchTest, IsTheSameForTheSameAndTakesNothingFromTheHeap) {
    SightingDrive drive(kYard, {true, false, false, false, 0.2, 2, 4}, 3);
    PoseSearch search(drive.params(), kYard), other(drive.params(), kYard);
    for (int frame = 0; frame < 12; ++frame) drive.step();
    const auto& evidence = drive.newest_first();
    const AllocationCount count;
    const Hypotheses a = search.run(evidence.data(), 32, nullptr, 0, 5);
    EXPECT_EQ(count.since(), 0);
    (void)other.run(evidence.data(), 20);
    const Hypotheses b = other.run(evidence.data(), 32, nullptr, 0, 5);
    ASSERT_EQ(a.count, b.count);
    for (int i = 0; i < a.count; ++i) {
        EXPECT_TRUE(same_bits(a[i].pose, b[i].pose));
        EXPECT_EQ(a[i].gain, b[i].gain);
    }
}

TEST(PoseSearchTest, LikelihoodOfATrackCountsItsOwnUncertainty) {
    const PoseSearch search(one_sensor(), kYard);
    const auto evidence = all_seen(kYard, {{1, 2, 0.5}}, kBearings, true);
    const Sighting& sighting = evidence[0].sighting;
    const auto under = [&](double sigma_rad, double off_rad) {
        const Matrix<double, 3> p = Pose<double>(1e-4, 1e-4, sigma_rad * sigma_rad).asDiagonal();
        return search.log_likelihood({1, 2, 0.5 + off_rad}, p, sighting, 0);
    };
    EXPECT_GT(under(0.01, 0), under(0.1, 0));
    EXPECT_GT(under(0.1, 0.2), under(0.01, 0.2));
    EXPECT_NEAR(under(0.01, 1), std::log(kClutter / (2 * kPi<double>)), 1e-9);
}

}  // namespace
}  // namespace pilotage::test
