#include "pilotage/sensing/direct.hpp"

#include "pilotage/sensing/mounted.hpp"
#include "support/jacobians.hpp"
#include "support/points.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(DirectTest);

// The runnable example: an antenna 0.5 m ahead of the axis and 0.2 m to the left of it.
TEST(Direct, AntennaIsWhereItsLeverArmReaches) {
    const Mounted<PositionFix<double>, double> antenna{{}, {0.5, 0.2, 0}};
    const auto h = antenna.linearize({10, 20, kPi<double> / 2});
    EXPECT_TRUE(close(h.value, Vector<double, 2>(9.8, 20.5), 1e-15));
}

TYPED_TEST(DirectTest, FixesAreTheStatesThemselves) {
    const Pose<TypeParam> x(1, 2, 3);
    EXPECT_EQ(PoseFix<TypeParam>{}.linearize(x).value, x);
    EXPECT_EQ(PositionFix<TypeParam>{}.linearize(x).value, (Vector<TypeParam, 2>(1, 2)));
    EXPECT_EQ(HeadingFix<TypeParam>{}.linearize(x).value[0], 3);
}

TYPED_TEST(DirectTest, CompassMountedAskewReadsItsOffsetMore) {
    const Mounted<HeadingFix<TypeParam>, TypeParam> compass{{}, {0, 0, TypeParam(0.25)}};
    EXPECT_NEAR(compass.linearize({1, 2, 3}).value[0], 3.25, kTight<TypeParam>);
}

TYPED_TEST(DirectTest, OnlyTheHeadingsDifferenceWraps) {
    const auto difference = PoseFix<TypeParam>{}.minus({4, 4, 3}, {-4, -4, -3});
    const Vector<TypeParam, 3> expected(8, 8, 6 - 2 * kPi<TypeParam>);
    EXPECT_TRUE(close(difference, expected, kTight<TypeParam>));
    const Vector<TypeParam, 1> north_west(3), south_west(-3);
    EXPECT_NEAR(HeadingFix<TypeParam>{}.minus(north_west, south_west)[0], 6 - 2 * kPi<TypeParam>,
                kTight<TypeParam>);
}

TYPED_TEST(DirectTest, JacobiansAreDerivatives) {
    const PlanarMounting<TypeParam> at{TypeParam(0.4), TypeParam(-1.1), TypeParam(0.3)};
    for (const auto& x : poses<TypeParam>()) {
        expect_jacobians(Mounted<PositionFix<TypeParam>, TypeParam>{{}, at}, x);
        expect_jacobians(Mounted<HeadingFix<TypeParam>, TypeParam>{{}, at}, x);
        expect_jacobians(Mounted<PoseFix<TypeParam>, TypeParam>{{}, at}, x);
    }
}

}  // namespace
}  // namespace pilotage::test
