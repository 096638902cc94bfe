#include "pilotage/sensing/mounted.hpp"

#include "support/jacobians.hpp"
#include "support/points.hpp"
#include "support/sightings.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(MountedTest);

template <typename Scalar>
using Camera = Mounted<BearingElevationRange<Scalar>, Scalar>;

template <typename Scalar>
PlanarMounting<Scalar> mounting(double x, double y, double yaw) {
    return {Scalar(x), Scalar(y), Scalar(yaw)};
}

TYPED_TEST(MountedTest, SensorAtTheOriginOfTheRobotIsTheSensorAlone) {
    const BearingElevationRange<TypeParam> sighting{{5, 6, -1}};
    const auto bare = sighting.linearize({1, 2, 3});
    const auto mounted = Camera<TypeParam>{sighting}.linearize({1, 2, 3});
    EXPECT_EQ(mounted.value, bare.value);
    EXPECT_EQ(mounted.jacobian, bare.jacobian);
}

// A robot at (10, 20) that looks along (3, 4), a camera 5 m ahead and 10 m to the left: at (5, 30).
TYPED_TEST(MountedTest, OffsetsPointForwardAndLeft) {
    const TypeParam heading = std::atan2(TypeParam(4), TypeParam(3));
    const Camera<TypeParam> camera{{{8, 34, 12}}, mounting<TypeParam>(5, 10, 0)};
    const auto h =
        camera.linearize({10, 20, heading});  // the marker is straight ahead of the camera
    EXPECT_NEAR(h.value[0], 0, 10 * kTight<TypeParam>);
    EXPECT_NEAR(h.value[1], std::atan2(12, 5), 10 * kTight<TypeParam>);
    EXPECT_NEAR(h.value[2], 13, 10 * kTight<TypeParam>);
}

TYPED_TEST(MountedTest, CameraTurnedLeftSeesTheMarkerFurtherRight) {
    const BearingElevationRange<TypeParam> sighting{{15, 20, 0}};
    const Camera<TypeParam> camera{sighting, mounting<TypeParam>(0, 0, 0.5)};
    EXPECT_NEAR(camera.linearize({10, 20, 0}).value[0], -0.5, kTight<TypeParam>);
}

TYPED_TEST(MountedTest, InnovationsWrapAsWithoutMounting) {
    const Camera<TypeParam> camera{{{5, 6, -1}}, mounting<TypeParam>(1, 2, 3)};
    const Vector<TypeParam, 3> z(3, 1, 2), predicted(-3, 0, 0);
    EXPECT_EQ(camera.minus(z, predicted), camera.model.minus(z, predicted));
}

TYPED_TEST(MountedTest, SensorAtTheMarkerIsUndefinedThoughTheRobotIsElsewhere) {
    const Camera<TypeParam> camera{{{3, 0, 0}}, mounting<TypeParam>(2, 0, 0)};
    EXPECT_FALSE(camera.linearize({1, 0, 0}).defined);
    EXPECT_TRUE(camera.linearize({3, 0, 0}).defined);
}

TYPED_TEST(MountedTest, JacobianIsTheDerivative) {
    for (const auto& at : {mounting<TypeParam>(0.4, 0, 0), mounting<TypeParam>(-0.3, 0.8, 0),
                           mounting<TypeParam>(1.5, -0.2, 2.5), mounting<TypeParam>(0, 0, -0.1)})
        for (const auto& robot : poses<TypeParam>()) {
            const TypeParam c = std::cos(robot[kHeading]), s = std::sin(robot[kHeading]);
            const Pose<TypeParam> sensor(robot[kX] + c * at.x_m - s * at.y_m,
                                         robot[kY] + s * at.x_m + c * at.y_m, 0);
            for (const auto& marker : markers_around(sensor))
                expect_jacobians(Camera<TypeParam>{{marker}, at}, robot);
        }
}

}  // namespace
}  // namespace pilotage::test
