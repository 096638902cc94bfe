// A pixel into the filter, and the report that it leaves.

#include "pilotage/fuse_pixel.hpp"

#include "pilotage/fuse_sighting.hpp"
#include "support/images.hpp"
#include "support/matchers.hpp"
#include "support/scalars.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(FusePixelTest);

const MarkerMap kAheadAndBehind({{5, 6, 2, 0.4, 0}, {6, -6, 2, 0.4, 0}});
const Pose<double> kTruth(0.1, -0.2, 0.3);

/// So sure that everything is linear.
template <typename Scalar, int N = 3>
Ekf<Scalar, N> near_truth(double sigma = 0.003) {
    Vector<Scalar, N> x = Vector<Scalar, N>::Zero();
    x.template head<3>() = (kTruth + Pose<double>(0.5, -0.4, 0.3) * sigma).cast<Scalar>();
    Vector<Scalar, N> p = Vector<Scalar, N>::Constant(Scalar(1e-4));
    p.template head<3>().setConstant(Scalar(sigma * sigma));
    return {x, Matrix<Scalar, N>(p.asDiagonal())};
}

Sample seen_at(const Pose<double>& robot, int id, const Vector<double, 2>& off = {0, 0}) {
    const Vector<double, 3> point = in_sensor(robot, *kAheadAndBehind.find(id), kCamera);
    return pixel_at(9, id, kCamera.camera.project(point).value + off);
}

TYPED_TEST(FusePixelTest, SaysWhatItsAnglesSay) {
    const Sample pixel = seen_at(kTruth, 5, {0.7, -0.4});
    SensorParams angular = kCamera;
    angular.measures = Measures::markers;
    Sample angles = pixel;
    angles.payload.sighting = angles_of(pixel.payload.sighting, kCamera);
    for (const bool unscented : {false, true}) {
        auto by_pixel = near_truth<TypeParam>(), by_angles = near_truth<TypeParam>();
        const auto report =
            fuse_pixel(by_pixel, pixel, kAheadAndBehind, kCamera, Policy{}, unscented);
        const auto other = fuse_sighting(by_angles, angles, kAheadAndBehind, angular, Policy{});
        ASSERT_EQ(report.verdict, Verdict::fused);
        EXPECT_EQ(report.dof, 2);
        EXPECT_NEAR(report.nis, other.nis, 0.05 * other.nis) << "but for how u and v correlate";
        const double moved = double((by_angles.state() - near_truth<TypeParam>().state()).norm());
        EXPECT_NEAR(double((by_pixel.state() - by_angles.state()).norm()), 0, 0.05 * moved);
    }
}

TYPED_TEST(FusePixelTest, IsReportedInPixels) {
    auto filter = Ekf<TypeParam, 3>(kTruth.cast<TypeParam>(),
                                    Matrix<TypeParam, 3>::Identity() * TypeParam(1e-12));
    const auto report =
        fuse_pixel(filter, seen_at(kTruth, 5, {3, -4}), kAheadAndBehind, kCamera, Policy{}, false);
    EXPECT_NEAR(report.innovation[0], 3, 1e-2);
    EXPECT_NEAR(report.innovation[1], -4, 1e-2);
    EXPECT_NEAR(report.sigma[0], 0.5, 1e-3);
    EXPECT_NEAR(report.nis, 100, 1);
    EXPECT_TRUE(std::isnan(report.innovation[2]));
    EXPECT_EQ(report.id, 5);
}

TYPED_TEST(FusePixelTest, OfNoMarkerOrOfOneThatCannotBeSeenSaysWhy) {
    auto filter = near_truth<TypeParam>();
    const auto before = filter.state();
    EXPECT_EQ(
        fuse_pixel(filter, pixel_at(9, 7, {300, 200}), kAheadAndBehind, kCamera, Policy{}, false)
            .verdict,
        Verdict::unknown_marker);
    for (const bool unscented : {false, true})
        EXPECT_EQ(fuse_pixel(filter, pixel_at(9, 6, {300, 200}), kAheadAndBehind, kCamera, Policy{},
                             unscented)
                      .verdict,
                  Verdict::out_of_view);
    EXPECT_EQ(filter.state(), before);
}

/// A pass so close that the projection is no line within the pose's uncertainty: what the filter
/// then states must hold.
TYPED_TEST(FusePixelTest, IsHonestOnAClosePass) {
    const MarkerMap near({{1, 1.5, 0.4, 0, 0}});
    Draw draw(4);
    double squares = 0;
    constexpr int runs = 400;
    const Policy policy = Policy::make(Fusion::student_t, 0.001, 4);
    for (int i = 0; i < runs; ++i) {
        const Vector<double, 3> n = draw.normal<double, 3>();
        const Pose<double> truth(0.25 * n[0], 0.25 * n[1], 0.1 * n[2]);
        Ekf<TypeParam, 3> filter(
            Pose<TypeParam>::Zero(),
            Matrix<TypeParam, 3>(
                Pose<TypeParam>(TypeParam(0.0625), TypeParam(0.0625), TypeParam(0.01))
                    .asDiagonal()));
        const Vector<double, 3> point = in_sensor(truth, near.markers()[0], kCamera);
        const auto pixel = kCamera.camera.project(point);
        ASSERT_TRUE(pixel.defined);
        const Vector<double, 2> noisy = pixel.value + 0.5 * draw.normal<double, 2>();
        (void)fuse_pixel(filter, pixel_at(9, 1, noisy), near, kCamera, policy, false);
        squares += contradiction(filter.state().template cast<double>(),
                                 filter.covariance().template cast<double>(), truth);
    }
    EXPECT_LT(squares / runs, 3 * 1.5) << "the mean of chi-square of three";
}

TYPED_TEST(FusePixelTest, ALeaningBodyTakesTheBlame) {
    if constexpr (std::is_same_v<TypeParam, double>) {
        auto filter = near_truth<double, kTiltedStates>(1e-5);
        const auto held = hold_pixel_against<double>(kTruth, *kAheadAndBehind.find(5),
                                                     seen_at(kTruth, 5).payload.sighting, kCamera);
        const Vector<double, 2> off = held.by_tilt * Vector<double, 2>(0.004, 0);
        (void)fuse_pixel(filter, seen_at(kTruth, 5, off), kAheadAndBehind, kCamera, Policy{},
                         false);
        EXPECT_NEAR(filter.state()[kPitch], 0.004, 4e-4);
        EXPECT_NEAR((filter.state().head<3>() - kTruth).norm(), 0, 1e-5);
    }
}

}  // namespace
}  // namespace pilotage::test
