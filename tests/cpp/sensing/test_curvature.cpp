// What linearising leaves out of a close pass: second derivatives, their variance, and what the
// filter makes of it.

#include "pilotage/sensing/curvature.hpp"

#include <Eigen/Cholesky>

#include "pilotage/fuse_sighting.hpp"
#include "support/filters.hpp"
#include "support/matchers.hpp"
#include "support/random.hpp"
#include "support/robots.hpp"
#include "support/scalars.hpp"

namespace pilotage::test {
namespace {

using Place = Vector<double, 2>;

/// A component's value with the sensor moved away from the origin.
template <typename Component>
double value_from(const Component& component, const Place& sensor,
                  const Vector<double, 3>& marker) {
    return component.predict({Pose<double>(sensor[0], sensor[1], 0.3), marker}).value;
}

/// Second derivatives by the sensor's place, by differences.
template <typename Component>
Matrix<double, 2> hessian(const Component& component, const Vector<double, 3>& marker) {
    const double step = 1e-3 * marker.head<2>().norm();
    const auto at = [&](double x, double y) {
        return value_from(component, Place(x, y) * step, marker);
    };
    const double mixed = (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / 4;
    Matrix<double, 2> h;
    h << at(1, 0) - 2 * at(0, 0) + at(-1, 0), mixed, mixed, at(0, 1) - 2 * at(0, 0) + at(0, -1);
    return h / (step * step);
}

const std::vector<Vector<double, 3>> kCloseMarkers{{0.7, 0.2, 0.3}, {-0.4, 0.5, -0.6},
                                                   {-2, -3, 1},     {0.1, -0.9, -0.2},
                                                   {5, 0.01, 2},    {0.3, 0.3, 0}};

template <typename Component>
void expect_bend(const Component& component) {
    for (const Vector<double, 3>& marker : kCloseMarkers) {
        const double d = marker.head<2>().norm();
        const Place along = marker.head<2>() / d, left(-along[1], along[0]);
        const Matrix<double, 2> h = hessian(component, marker);
        const Bend<double> bend = component.bend({Pose<double>(0, 0, 0.3), marker});
        const double tolerance = 1e-5 * h.norm() + 1e-9;
        EXPECT_NEAR(bend.along, along.dot(h * along), tolerance) << marker.transpose();
        EXPECT_NEAR(bend.mixed, along.dot(h * left), tolerance) << marker.transpose();
        EXPECT_NEAR(bend.across, left.dot(h * left), tolerance) << marker.transpose();
    }
}

TEST(CurvatureTest, BendsAreTheSecondDerivatives) {
    expect_bend(Bearing<double>{});
    expect_bend(Elevation<double>{});
    expect_bend(Range<double>{1.02, 0.4});
}

/// tr((H P)^2) / 2 as it stands, in frame map.
template <typename Component>
void expect_variance(const Component& component, Draw& draw) {
    for (const Vector<double, 3>& marker : kCloseMarkers) {
        const auto p = draw.covariance<double, 3>(0.01);
        const Matrix<double, 2> hp = hessian(component, marker) * p.topLeftCorner<2, 2>();
        const double expected = (hp * hp).trace() / 2;
        const Bend<double> bend = component.bend({Pose<double>(0, 0, 0.3), marker});
        EXPECT_NEAR(curvature_variance(bend, marker[0], marker[1], p), expected, 1e-4 * expected)
            << marker.transpose();
    }
}

TEST(CurvatureTest, VarianceIsHalfTheTraceOfTheSquare) {
    Draw draw(1);
    expect_variance(Bearing<double>{}, draw);
    expect_variance(Elevation<double>{}, draw);
    expect_variance(Range<double>{1.02, 0.4}, draw);
    const Matrix<double, 2> h = (Matrix<double, 2>() << 0.7, -0.4, -0.4, 1.1).finished();
    const auto p = draw.covariance<double, 2>();
    EXPECT_NEAR(curvature_variance(Bend<double>{0.7, -0.4, 1.1}, 1.0, 0.0, p),
                (h * p * h * p).trace() / 2, 1e-12)
        << "all three at once";
}

TEST(CurvatureTest, VarianceNeedsTheLowerTriangleAlone) {
    Draw draw(2);
    auto p = draw.covariance<double, 3>();
    const Bend<double> bend{0.3, 0.2, 0.1};
    const double whole = curvature_variance(bend, 1.0, 2.0, p);
    p.triangularView<Eigen::StrictlyUpper>().setConstant(1e9);
    EXPECT_EQ(curvature_variance(bend, 1.0, 2.0, p), whole);
}

/// Of the models themselves, less their linear part, over random places.
template <typename Component>
void expect_spread(const Component& component, Draw& draw) {
    constexpr int kDraws = 20'000;
    const Vector<double, 3> marker(0.6, 0.5, 0.4);
    const auto p = draw.covariance<double, 2>(1e-4);
    const Matrix<double, 2> root = p.llt().matrixL();
    const Prediction<double> linear = component.predict({Pose<double>(0, 0, 0.3), marker});
    double sum = 0, square = 0;
    for (int i = 0; i < kDraws; ++i) {
        const Place off = root * draw.normal<double, 2>();
        const double rest = value_from(component, off, marker) - linear.value -
                            linear.by_x * off[0] - linear.by_y * off[1];
        sum += rest;
        square += rest * rest;
    }
    const double variance = square / kDraws - sum * sum / kDraws / kDraws;
    const Bend<double> bend = component.bend({Pose<double>(0, 0, 0.3), marker});
    EXPECT_NEAR(variance / curvature_variance(bend, marker[0], marker[1], p), 1, 0.1);
}

TEST(CurvatureTest, VarianceIsThatOfWhatTheLinearModelLeavesOut) {
    Draw draw(3);
    expect_spread(Bearing<double>{}, draw);
    expect_spread(Elevation<double>{}, draw);
    expect_spread(Range<double>{}, draw);
}

constexpr double kSigma_m = 0.15, kSigma_rad = 0.03;

template <typename Scalar>
Ekf<Scalar, 3> prior(const Pose<double>& pose = {0, 0, 0}) {
    return {Pose<Scalar>(pose.cast<Scalar>()),
            Pose<Scalar>(Scalar(kSigma_m * kSigma_m), Scalar(kSigma_m * kSigma_m),
                         Scalar(kSigma_rad * kSigma_rad))
                .asDiagonal()};
}

/// NEES / dof after one bearing to a marker so far away, from a random place that is known as
/// stated.
double nees(double distance_m, Fusion fusion) {
    constexpr int kRuns = 4000;
    const Policy policy = Policy::make(fusion, 0.001, 4);
    const MarkerMap map({{1, distance_m, 0, 0, 0}});
    SensorParams sensor;
    sensor.sigma_bearing_rad = 0.02;
    Draw draw(4);
    double sum = 0;
    for (int run = 0; run < kRuns; ++run) {
        const Vector<double, 3> n = draw.normal<double, 3>();
        const Pose<double> truth(kSigma_m * n[0], kSigma_m * n[1], kSigma_rad * n[2]);
        Vector<double, 3> seen = view(truth, map.markers()[0]);
        seen[0] = wrap(seen[0] + 0.02 * draw.normal<double, 1>()(0));
        auto filter = prior<double>();
        (void)fuse_sighting(filter, sighting_at(0, 1, only(seen, true, false, false)), map, sensor,
                            policy);
        const Pose<double> off = minus(truth, filter.state());
        sum += off.dot(filter.covariance().ldlt().solve(off));
    }
    return sum / kRuns / 3;
}

TEST(CurvatureTest, AClosePassIsConsistentWhereThePlainRuleIsNot) {
    EXPECT_GT(nees(0.5, Fusion::plain), 2);
    EXPECT_NEAR(nees(0.5, Fusion::student_t), 1, 0.25);
    EXPECT_NEAR(nees(0.5, Fusion::gate), 1, 0.25);
    EXPECT_NEAR(nees(8, Fusion::plain), 1, 0.1) << "far away there is no difference";
    EXPECT_NEAR(nees(8, Fusion::student_t), 1, 0.1);
}

PILOTAGE_SUITE(CloseSightingTest);

/// A sighting of a marker that is seen where it should be, and the same by hand with a variance
/// more.
template <typename Scalar>
void expect_variances(double distance_m, Fusion fusion, bool widened) {
    const MarkerMap map({{1, distance_m, 0.1, 0.4, 0}});
    const SensorParams sensor;
    const Vector<double, 3> seen = view({0, 0, 0}, map.markers()[0]);
    auto filter = prior<Scalar>(), by_hand = filter;
    const auto report =
        fuse_sighting(filter, sighting_at(0, 1, seen), map, sensor, Policy::make(fusion, 0.001, 4));
    EXPECT_EQ(report.verdict, Verdict::fused);
    const Vector<double, 3> marker(distance_m, 0.1, 0.4);
    const auto p = prior<double>().covariance();
    const LineOfSight<double> sight({0, 0, 0}, marker);
    Vector<Scalar, 3> variances;
    int i = 0;
    const auto add = [&](const auto& component, double sigma) {
        const double more = curvature_variance(component.bend(sight), marker[0], marker[1], p);
        variances[i++] = Scalar(sigma * sigma + (widened ? more : 0));
    };
    add(Bearing<double>{}, sensor.sigma_bearing_rad);
    add(Elevation<double>{}, sensor.sigma_elevation_rad);
    add(Range<double>{}, sensor.sigma_range_m);
    const BearingElevationRange<Scalar> model{marker.template cast<Scalar>()};
    (void)by_hand.update(model, Vector<Scalar, 3>(seen.template cast<Scalar>()),
                         diagonal(variances), Policy{});
    EXPECT_TRUE(close(filter.covariance(), by_hand.covariance(), kTight<Scalar>)) << distance_m;
    EXPECT_TRUE(close(filter.state(), by_hand.state(), kTight<Scalar>)) << distance_m;
}

TYPED_TEST(CloseSightingTest, OfAllComponentsIsFusedWithTheirCurvature) {
    for (const Fusion fusion : {Fusion::gate, Fusion::student_t})
        expect_variances<TypeParam>(0.6, fusion, true);
}

TYPED_TEST(CloseSightingTest, IsTakenAsItIsByPlainFusionAndFromAfar) {
    expect_variances<TypeParam>(0.6, Fusion::plain, false);
    for (const Fusion fusion : {Fusion::gate, Fusion::student_t})
        expect_variances<TypeParam>(6, fusion, false);
}

}  // namespace
}  // namespace pilotage::test
