// An elevation that is wrong alone, as by a tilt, costs the elevation and nothing else.

#include "support/localizers.hpp"
#include "support/robots.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_LOCALIZER_SUITE(ElevationApartTest);

const MarkerMap kHighMarker({{1, 6, 2, 1.5, 0}});

const Vector<double, 3> kSeen = view({0.02, -0.02, 0.01}, kHighMarker.markers()[0]);
constexpr double kWrong_rad = 0.5;

/// A standing robot that is shown the marker once.
struct Shown {
    Robot robot;
    Sample sample;

    Shown(const LocalizerKind& kind, Fusion fusion, const Vector<double, 3>& seen)
        : robot(kind, params(fusion), kHighMarker), sample(sighting_at(1, 1, seen)) {
        robot.add(encoders_at(0, 0, 0));
        robot.add(sample);
        robot.add(encoders_at(kPeriod, 0, 0));
    }
    [[nodiscard]] static Params params(Fusion fusion) {
        Params params = plain_params();
        params.sensors[0].fusion = fusion;
        return params;
    }
    [[nodiscard]] const SightingReport& report() const { return robot.tally.reports.at(0); }
};

void expect_same_estimate(const Shown& a, const Shown& b) {
    EXPECT_EQ(a.robot.state(), b.robot.state());
    EXPECT_EQ(a.robot.covariance(), b.robot.covariance());
}

TEST_P(ElevationApartTest, AWrongElevationIsLeftOutAndTheRestHasItsFullWeight) {
    for (const Fusion fusion : {Fusion::gate, Fusion::student_t})
        for (const bool range : {false, true}) {
            Vector<double, 3> wrong = only(kSeen, true, true, range);
            wrong[1] += kWrong_rad;
            const Shown apart(GetParam(), fusion, wrong);
            const Shown level(GetParam(), fusion, only(kSeen, true, false, range));
            expect_same_estimate(apart, level);
            const SightingReport& report = apart.report();
            EXPECT_EQ(apart.robot.tally.of(apart.sample), Verdict::fused);
            EXPECT_EQ(report.verdict, Verdict::fused);
            EXPECT_EQ(report.dof, range ? 2 : 1);
            EXPECT_EQ(report.weight, 1);
            EXPECT_TRUE(report.agrees);
            EXPECT_EQ(report.nis, level.report().nis) << "of what was fused";
            EXPECT_TRUE(std::isnan(report.value) && std::isnan(report.limit)) << "not rejected";
        }
}

TEST_P(ElevationApartTest, OfARangeAndAnElevationTheRangeIsKept) {
    Vector<double, 3> wrong = only(kSeen, false, true, true);
    wrong[1] += kWrong_rad;
    const Shown apart(GetParam(), Fusion::student_t, wrong);
    expect_same_estimate(apart,
                         Shown(GetParam(), Fusion::student_t, only(kSeen, false, false, true)));
    EXPECT_EQ(apart.report().dof, 1);
}

TEST_P(ElevationApartTest, ATrueElevationIsFused) {
    for (const Fusion fusion : {Fusion::gate, Fusion::student_t}) {
        const Shown both(GetParam(), fusion, only(kSeen, true, true, false));
        const Shown level(GetParam(), fusion, only(kSeen, true, false, false));
        EXPECT_EQ(both.report().dof, 2);
        EXPECT_EQ(both.report().weight, 1);
        EXPECT_LT(both.robot.covariance()(kX, kX), level.robot.covariance()(kX, kX));
    }
}

/// Nothing tells them apart: a bearing that is wrong may be of another marker.
TEST_P(ElevationApartTest, AWrongBearingDropsBothAtTheGate) {
    for (const double elevation_off : {0.0, kWrong_rad}) {
        const Vector<double, 3> wrong =
            only(kSeen + Vector<double, 3>(1, elevation_off, 0), true, true, false);
        const Shown dropped(GetParam(), Fusion::gate, wrong);
        const SightingReport& report = dropped.report();
        EXPECT_EQ(report.verdict, Verdict::gate);
        EXPECT_EQ(report.dof, 2);
        EXPECT_EQ(report.weight, 0);
        EXPECT_EQ(report.value, report.nis);
        EXPECT_NEAR(report.limit, 13.8155, 1e-3) << "of two components";
        EXPECT_TRUE(same_pose(dropped.robot.pose(), Pose<double>(0, 0, 0), 0));
    }
}

TEST_P(ElevationApartTest, AWrongBearingWeighsBothByTheirNis) {
    for (const double elevation_off : {0.0, kWrong_rad}) {
        const Vector<double, 3> wrong =
            only(kSeen + Vector<double, 3>(1, elevation_off, 0), true, true, false);
        const Shown weighed(GetParam(), Fusion::student_t, wrong);
        const SightingReport& report = weighed.report();
        EXPECT_EQ(report.verdict, Verdict::fused);
        EXPECT_EQ(report.dof, 2);
        EXPECT_NEAR(report.weight, 6 / (4 + report.nis), 1e-6);
        EXPECT_LT(report.weight, 0.2);
        EXPECT_FALSE(report.agrees);
        EXPECT_TRUE(std::isnan(report.value) && std::isnan(report.limit)) << "not rejected";
    }
}

TEST_P(ElevationApartTest, PlainFusionTakesItAsItIs) {
    Vector<double, 3> wrong = only(kSeen, true, true, false);
    wrong[1] += kWrong_rad;
    const Shown plain(GetParam(), Fusion::plain, wrong);
    EXPECT_EQ(plain.report().verdict, Verdict::fused);
    EXPECT_EQ(plain.report().dof, 2);
    EXPECT_EQ(plain.report().weight, 1);
    EXPECT_GT(plain.report().nis, 50);
}

/// There is nothing else to keep.
TEST_P(ElevationApartTest, AnElevationAloneFollowsTheRule) {
    Vector<double, 3> wrong = only(kSeen, false, true, false);
    wrong[1] += kWrong_rad;
    EXPECT_EQ(Shown(GetParam(), Fusion::gate, wrong).report().verdict, Verdict::gate);
    const Shown weighed(GetParam(), Fusion::student_t, wrong);
    EXPECT_NEAR(weighed.report().weight, 5 / (4 + weighed.report().nis), 1e-6);
}

}  // namespace
}  // namespace pilotage::test
