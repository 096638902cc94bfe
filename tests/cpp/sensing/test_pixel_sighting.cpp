#include "pilotage/sensing/pixel_sighting.hpp"

#include "support/images.hpp"
#include "support/jacobians.hpp"
#include "support/points.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(PixelSightingTest);

/// Markers in front of a sensor.
template <typename Scalar>
std::vector<Vector<Scalar, 3>> markers_before(const Pose<Scalar>& sensor) {
    std::vector<Vector<Scalar, 3>> result;
    for (const double distance : {0.5, 4.0, 60.0})
        for (const double aside : {-0.6, 0.0, 0.5})
            for (const double height : {-1.0, 0.3})
                result.emplace_back(
                    sensor[kX] + Scalar(distance * std::cos(double(sensor[kHeading]) + aside)),
                    sensor[kY] + Scalar(distance * std::sin(double(sensor[kHeading]) + aside)),
                    Scalar(0.3 * distance * height));
    return result;
}

TYPED_TEST(PixelSightingTest, JacobianIsTheDerivative) {
    for (const auto& x : poses<TypeParam>())
        for (const auto& marker : markers_before(x)) {
            const PixelSighting<TypeParam> sighting{marker, &kCamera.camera};
            expect_jacobians(sighting, x);
            const PlanarMounting<TypeParam> still{};
            expect_jacobians(Mounted<PixelSighting<TypeParam>, TypeParam>{sighting, still}, x);
        }
}

TYPED_TEST(PixelSightingTest, MountedItIsWhereGeometrySaysThatItIs) {
    const Marker marker{1, 5, 3, 0.5, 0};
    const Pose<double> robot(1, 2, 0.3);
    const Mounted<PixelSighting<TypeParam>, TypeParam> model{
        {{5, 3, TypeParam(0.5 - kCamera.z_m)}, &kCamera.camera},
        {TypeParam(kCamera.x_m), TypeParam(kCamera.y_m), TypeParam(kCamera.yaw_rad)}};
    const Vector<double, 2> expected =
        kCamera.camera.project(in_sensor(robot, marker, kCamera)).value;
    const Pose<TypeParam> x = robot.cast<TypeParam>();
    EXPECT_TRUE(close(model.linearize(x).value, Vector<TypeParam, 2>(expected.cast<TypeParam>()),
                      kTight<TypeParam>));
}

TYPED_TEST(PixelSightingTest, AMarkerBehindTheCameraIsNotDefined) {
    const PixelSighting<TypeParam> behind{{-3, 0, 0}, &kCamera.camera};
    EXPECT_FALSE(behind.linearize({0, 0, 0}).defined);
    EXPECT_TRUE(behind.linearize({0, 0, TypeParam(3.1)}).defined);
}

}  // namespace
}  // namespace pilotage::test
