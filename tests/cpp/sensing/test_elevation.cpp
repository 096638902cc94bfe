#include "pilotage/sensing/elevation.hpp"

#include "support/jacobians.hpp"
#include "support/points.hpp"
#include "support/sightings.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(ElevationTest);

template <typename Scalar>
Scalar elevation(const Pose<Scalar>& from, double x, double y, double above_sensor) {
    const Vector<Scalar, 3> marker{Scalar(x), Scalar(y), Scalar(above_sensor)};
    return ElevationOnly<Scalar>{marker}.linearize(from).value[0];
}

TYPED_TEST(ElevationTest, LevelMarkerIsAtZeroAndUpIsPositive) {
    const Pose<TypeParam> x(1, 2, 3);
    EXPECT_EQ(elevation(x, 4, 6, 0), 0);
    EXPECT_NEAR(elevation(x, 4, 6, 5), kPi<double> / 4, kTight<TypeParam>);
    EXPECT_NEAR(elevation(x, 4, 6, -5), -kPi<double> / 4, kTight<TypeParam>);
}

TYPED_TEST(ElevationTest, GroundMarkerIsEquation24) {
    const Pose<TypeParam> x(1, 2, 3);
    EXPECT_NEAR(elevation(x, 4, 6, -1.2), -std::atan(1.2 / 5), kTight<TypeParam>);
}

TYPED_TEST(ElevationTest, HeadingDoesNotMatter) {
    EXPECT_EQ(elevation<TypeParam>({1, 2, 3}, 4, 6, -1),
              elevation<TypeParam>({1, 2, -1}, 4, 6, -1));
}

TYPED_TEST(ElevationTest, JacobianIsTheDerivative) {
    for (const auto& x : poses<TypeParam>())
        for (const auto& marker : markers_around(x))
            expect_jacobians(ElevationOnly<TypeParam>{marker}, x);
}

// Erratum: driving towards a ground marker lowers it, so with Delta = marker - robot the derivative
// is -mu Delta / (d (mu^2 + d^2)); it is printed without the minus.
TYPED_TEST(ElevationTest, PrintedSignsOfEquation25AreTheWrongWayRound) {
    const Pose<TypeParam> x(1, 2, 3);
    const TypeParam mu = TypeParam(1.2), dx = 3, dy = 4, d = 5;
    const Matrix<TypeParam, 1, 3> printed(mu * dx / (d * (mu * mu + d * d)),
                                          mu * dy / (d * (mu * mu + d * d)), 0);
    const auto h = ElevationOnly<TypeParam>{{4, 6, -mu}}.linearize(x).jacobian;
    EXPECT_TRUE(close(h, -printed, kTight<TypeParam>));
    EXPECT_FALSE(close(h, printed, 0.1 * printed.norm()));
    EXPECT_LT(elevation(x, 4, 6, -1.2), elevation<TypeParam>({0, 2, 3}, 4, 6, -1.2));
}

}  // namespace
}  // namespace pilotage::test
