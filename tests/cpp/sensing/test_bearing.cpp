#include "pilotage/sensing/bearing.hpp"

#include "support/jacobians.hpp"
#include "support/points.hpp"
#include "support/sightings.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(BearingTest);

template <typename Scalar>
Scalar bearing(const Pose<Scalar>& from, double marker_x, double marker_y) {
    const BearingOnly<Scalar> sighting{{Scalar(marker_x), Scalar(marker_y), 0}};
    return sighting.minus(sighting.linearize(from).value, Vector<Scalar, 1>(Scalar(0)))[0];
}

TYPED_TEST(BearingTest, MarkerAheadIsAtZeroAndMarkersToTheLeftArePositive) {
    constexpr TypeParam pi = kPi<TypeParam>;
    const Pose<TypeParam> looking_north(1, 2, pi / 2);
    EXPECT_NEAR(bearing(looking_north, 1, 9), 0, kTight<TypeParam>);
    EXPECT_NEAR(bearing(looking_north, -4, 2), pi / 2, kTight<TypeParam>);
    EXPECT_NEAR(bearing(looking_north, 6, 2), -pi / 2, kTight<TypeParam>);
    EXPECT_NEAR(std::abs(bearing(looking_north, 1, -9)), pi, kTight<TypeParam>);
}

TYPED_TEST(BearingTest, EveryQuadrantIsTold) {  // eq. 23 with atan2, where arctan tells two only
    const Pose<TypeParam> x(0, 0, 0);
    EXPECT_NEAR(bearing(x, 1, 1), 0.25 * kPi<double>, kTight<TypeParam>);
    EXPECT_NEAR(bearing(x, -1, 1), 0.75 * kPi<double>, kTight<TypeParam>);
    EXPECT_NEAR(bearing(x, -1, -1), -0.75 * kPi<double>, kTight<TypeParam>);
    EXPECT_NEAR(bearing(x, 1, -1), -0.25 * kPi<double>, kTight<TypeParam>);
}

TYPED_TEST(BearingTest, InnovationBehindTheRobotIsTheShortWay) {
    const BearingOnly<TypeParam> sighting{{-5, 0, 0}};
    const auto predicted = sighting.linearize({0, 0, TypeParam(0.01)}).value;  // just short of pi
    const Vector<TypeParam, 1> measured(TypeParam(0.01) - kPi<TypeParam>);
    EXPECT_NEAR(sighting.minus(measured, predicted)[0], 0.02, kTight<TypeParam>);
}

TYPED_TEST(BearingTest, HeightDoesNotMatter) {
    const Pose<TypeParam> x(1, 2, 3);
    const auto low = BearingOnly<TypeParam>{{4, 6, -1}}.linearize(x).value;
    EXPECT_EQ(low, (BearingOnly<TypeParam>{{4, 6, 9}}.linearize(x).value));
}

TYPED_TEST(BearingTest, JacobianIsTheDerivative) {
    for (const auto& x : poses<TypeParam>())
        for (const auto& marker : markers_around(x))
            expect_jacobians(BearingOnly<TypeParam>{marker}, x);
}

}  // namespace
}  // namespace pilotage::test
