// One sighting into the filter: each mix of components, and the report that it leaves.

#include "pilotage/fuse_sighting.hpp"

#include "support/filters.hpp"
#include "support/matchers.hpp"
#include "support/robots.hpp"
#include "support/scalars.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(FuseSightingTest);

const MarkerMap kMarkerFive({{5, 6, 2, 0.4, 0}});

template <typename Scalar>
Ekf<Scalar, 3> near_origin() {
    return {Pose<Scalar>(Scalar(0.1), Scalar(-0.2), Scalar(0.3)),
            Pose<Scalar>(Scalar(0.04), Scalar(0.05), Scalar(0.003)).asDiagonal()};
}

/// What the filter makes of each mix must be what it makes of the same models by hand.
template <typename Scalar, typename... Components>
void expect_as_by_hand(const Vector<double, 3>& measured, const std::vector<int>& which,
                       const Components&... components) {
    constexpr int M = sizeof...(Components);
    const SensorParams sensor;
    const double sigmas[] = {sensor.sigma_bearing_rad, sensor.sigma_elevation_rad,
                             sensor.sigma_range_m};
    auto by_hand = near_origin<Scalar>();
    const MarkerSighting<Scalar, Components...> model{{Scalar(6), Scalar(2), Scalar(0.4)},
                                                      {components...}};
    Vector<Scalar, M> z;
    Matrix<Scalar, M> r = Matrix<Scalar, M>::Zero();
    for (int i = 0; i < M; ++i) {
        const int c = which[static_cast<std::size_t>(i)];
        z[i] = Scalar(measured[c]);
        r(i, i) = Scalar(sigmas[c] * sigmas[c]);
    }
    const auto expected = by_hand.update(model, z, r, Policy{});

    auto filter = near_origin<Scalar>();
    const SightingReport report =
        fuse_sighting(filter, sighting_at(9, 5, measured, 4), kMarkerFive, sensor, Policy{});
    EXPECT_TRUE(close(filter.state(), by_hand.state(), kTight<Scalar>));
    EXPECT_TRUE(close(filter.covariance(), by_hand.covariance(), kTight<Scalar>));
    EXPECT_EQ(report.verdict, Verdict::fused);
    EXPECT_EQ(report.dof, M);
    EXPECT_EQ(report.weight, 1);
    EXPECT_NEAR(report.nis, double(expected.nis), 1e-4 * double(expected.nis));
    for (int c = 0; c < 3; ++c) {
        const auto at = std::find(which.begin(), which.end(), c);
        if (at == which.end()) {
            EXPECT_TRUE(std::isnan(report.innovation[c]) && std::isnan(report.sigma[c]));
            continue;
        }
        const auto i = at - which.begin();
        EXPECT_NEAR(report.innovation[c], double(expected.innovation[i]), 1e-5);
        EXPECT_NEAR(report.sigma[c], std::sqrt(double(expected.s(i, i))), 1e-5);
    }
    EXPECT_TRUE(std::isnan(report.value) && std::isnan(report.limit));
}

TYPED_TEST(FuseSightingTest, TakesEachMixOfComponentsAsOneMeasurement) {
    using Scalar = TypeParam;
    const Bearing<Scalar> b;
    const Elevation<Scalar> e;
    const Range<Scalar> r;
    expect_as_by_hand<Scalar>({0.1, kNan, kNan}, {0}, b);
    expect_as_by_hand<Scalar>({kNan, 0.1, kNan}, {1}, e);
    expect_as_by_hand<Scalar>({kNan, kNan, 6.1}, {2}, r);
    expect_as_by_hand<Scalar>({0.1, 0.1, kNan}, {0, 1}, b, e);
    expect_as_by_hand<Scalar>({0.1, kNan, 6.1}, {0, 2}, b, r);
    expect_as_by_hand<Scalar>({kNan, 0.1, 6.1}, {1, 2}, e, r);
    expect_as_by_hand<Scalar>({0.1, 0.1, 6.1}, {0, 1, 2}, b, e, r);
}

TYPED_TEST(FuseSightingTest, WrapsABearingAcrossTheBack) {
    using Scalar = TypeParam;
    Ekf<Scalar, 3> filter = near_origin<Scalar>();
    const MarkerMap behind({{1, -10, -0.2, 0, 0}});
    const Vector<double, 3> seen =
        view(filter.state().template cast<double>(), behind.markers()[0]);
    const auto report =
        fuse_sighting(filter, sighting_at(0, 1, {seen[0] - 0.01 - 2 * kPi<double>, kNan, kNan}),
                      behind, SensorParams{}, Policy{});
    EXPECT_NEAR(report.innovation[0], -0.01, 1e-5);
}

TYPED_TEST(FuseSightingTest, ReportsWhichSightingItIsOf) {
    auto filter = near_origin<TypeParam>();
    Sample sample = sighting_at(-77, 5, {0.1, kNan, kNan}, 9);
    sample.seq = 13;
    sample.source = 2;
    const auto report = fuse_sighting(filter, sample, kMarkerFive, SensorParams{}, Policy{});
    EXPECT_EQ(report.utime, -77);
    EXPECT_EQ(report.frame_seq, 13);
    EXPECT_EQ(report.index, 9);
    EXPECT_EQ(report.sensor, 2);
    EXPECT_EQ(report.id, 5);
}

TYPED_TEST(FuseSightingTest, ReportsTheRobustWeight) {
    auto filter = near_origin<TypeParam>();
    const Policy policy = Policy::make(Fusion::student_t, 0.001, 4);
    const auto report = fuse_sighting(filter, sighting_at(0, 5, {1.5, kNan, kNan}), kMarkerFive,
                                      SensorParams{}, policy);
    EXPECT_EQ(report.verdict, Verdict::fused);
    EXPECT_NEAR(report.weight, 5 / (4 + report.nis), 1e-5);
    EXPECT_LT(report.weight, 0.5);
}

TEST(BlankReportTest, HoldsNothingButWhatWasMeasured) {
    const SightingReport report =
        blank_report(sighting_at(1, 3, {0.1, kNan, 5}), Verdict::before_motion);
    EXPECT_EQ(report.dof, 2);
    EXPECT_EQ(report.verdict, Verdict::before_motion);
    EXPECT_EQ(report.revision, 0);
    EXPECT_EQ(report.weight, 0);
    for (const double v : report.innovation) EXPECT_TRUE(std::isnan(v));
    for (const double v : report.sigma) EXPECT_TRUE(std::isnan(v));
    for (const double v : {report.nis, report.value, report.limit}) EXPECT_TRUE(std::isnan(v));
}

TEST(VerdictTest, HasANameEachAndRejectsAllButPendingAndFused) {
    std::vector<std::string> names;
    for (int v = 0; v < kVerdicts; ++v) {
        names.emplace_back(name(static_cast<Verdict>(v)));
        EXPECT_EQ(rejected(static_cast<Verdict>(v)), v > 1) << names.back();
    }
    std::sort(names.begin(), names.end());
    EXPECT_EQ(std::unique(names.begin(), names.end()), names.end());
}

}  // namespace
}  // namespace pilotage::test
