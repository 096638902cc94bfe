// Pixels held against markers, and turned into angles.

#include "pilotage/held_pixel.hpp"

#include <Eigen/Geometry>

#include "support/images.hpp"
#include "support/scalars.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(HeldPixelTest);

const Marker kHeldMarker{1, 5, 3, 0.5, 0.1};
const Pose<double> kOnlooker(1, 2, 0.1);

Vector<double, 2> marker_pixel() {
    return kCamera.camera.project(in_sensor(kOnlooker, kHeldMarker, kCamera)).value;
}

Sighting pixel(const Vector<double, 2>& at, double sigma = kNan) {
    return {{at[0], at[1], kNan}, {sigma, sigma, kNan}, 1, -1};
}

TYPED_TEST(HeldPixelTest, InnovationIsMeasuredLessPredicted) {
    const Pose<TypeParam> robot = kOnlooker.cast<TypeParam>();
    const auto held = hold_pixel_against(robot, kHeldMarker,
                                         pixel(marker_pixel() + Vector<double, 2>(2, -3)), kCamera);
    ASSERT_TRUE(held.defined);
    EXPECT_NEAR(held.innovation[0], 2, 1e-3);
    EXPECT_NEAR(held.innovation[1], -3, 1e-3);
    EXPECT_EQ(held.variances[0], TypeParam(0.25)) << "as configured";
    const auto stated = hold_pixel_against(robot, kHeldMarker, pixel(marker_pixel(), 2), kCamera);
    EXPECT_EQ(stated.variances[1], 4);
    const TypeParam least =
        held.jacobian.template leftCols<2>().row(0).squaredNorm() * TypeParam(0.01);
    EXPECT_NEAR(held.noise()(0, 0), TypeParam(0.25) + least, 1e-3 * least) << "with the survey's";
}

/// The body is turned about the sensor by small angles, as tilt.hpp has them.
TYPED_TEST(HeldPixelTest, TiltMovesThePixelAsATurnOfTheBodyDoes) {
    const auto held =
        hold_pixel_against(Pose<double>(kOnlooker), kHeldMarker, pixel(marker_pixel()), kCamera);
    const Vector<double, 3> point = in_sensor(kOnlooker, kHeldMarker, kCamera);
    const double step = 1e-6, c = std::cos(kCamera.yaw_rad), s = std::sin(kCamera.yaw_rad);
    const Vector<double, 3> forward(c, -s, 0), left(s, c, 0);  // of the robot
    // Nose up: about the left axis, backwards; left side up: about the forward axis.
    const Vector<double, 3> axes[] = {-left, forward};
    for (int i = 0; i < 2; ++i) {
        const Vector<double, 3> turned = point - step * axes[i].cross(point);
        const Vector<double, 2> slope =
            (kCamera.camera.project(turned).value - marker_pixel()) / step;
        EXPECT_NEAR((slope - held.by_tilt.col(i)).norm(), 0, 1e-3 * slope.norm());
    }
    EXPECT_GT(held.by_tilt(1, 0), 100) << "nose up lowers what is ahead: v grows";
}

TEST(AnglesOfPixelTest, AreBearingAndElevationWithTheirSpread) {
    const Vector<double, 3> expected = view(kOnlooker, kHeldMarker, kCamera);
    const Sighting angles = angles_of(pixel(marker_pixel()), kCamera);
    EXPECT_NEAR(angles.value[kBearing], expected[0], 1e-9);
    EXPECT_NEAR(angles.value[kElevation], expected[1], 1e-9);
    EXPECT_TRUE(std::isnan(angles.value[kRange]));
    Draw draw(3);
    Vector<double, 2> sum(0, 0);
    constexpr int count = 20'000;
    for (int i = 0; i < count; ++i) {
        const Sighting noisy =
            angles_of(pixel(marker_pixel() + 0.5 * draw.normal<double, 2>()), kCamera);
        for (int k = 0; k < 2; ++k)
            sum[k] += (noisy.value[k] - expected[k]) * (noisy.value[k] - expected[k]) / count;
    }
    for (int k = 0; k < 2; ++k)
        EXPECT_NEAR(std::sqrt(sum[k]), angles.sigma[k], 0.03 * angles.sigma[k]);
}

}  // namespace
}  // namespace pilotage::test
