#include "pilotage/sensing/marker_sighting.hpp"

#include "support/jacobians.hpp"
#include "support/points.hpp"
#include "support/sightings.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(MarkerSightingTest);

// The runnable example: bearing and range of a marker 3 m ahead and 4 m to the left.
TEST(MarkerSighting, BearingAndRangeAreMeasuredTogether) {
    const MarkerSighting<double, Bearing<double>, Range<double>> sighting{{13, 24, 0}};
    const auto h = sighting.linearize({10, 20, 0});
    EXPECT_TRUE(h.defined);
    EXPECT_TRUE(close(h.value, Vector<double, 2>(std::atan2(4, 3), 5), 1e-12));
}

TYPED_TEST(MarkerSightingTest, StackedRowsAreTheComponentsInTheirOrder) {
    using S = TypeParam;
    const Pose<S> x(1, 2, 3);
    const Vector<S, 3> marker(5, -2, S(0.5));
    const Range<S> range{S(1.1), S(0.2)};
    const auto stacked = MarkerSighting<S, Range<S>, Bearing<S>>{marker, {range, {}}}.linearize(x);
    const auto first = MarkerSighting<S, Range<S>>{marker, {range}}.linearize(x);
    const auto second = MarkerSighting<S, Bearing<S>>{marker}.linearize(x);
    EXPECT_EQ(stacked.value, (Vector<S, 2>(first.value[0], second.value[0])));
    EXPECT_EQ((Matrix<S, 1, 3>(stacked.jacobian.row(0))), first.jacobian);
    EXPECT_EQ((Matrix<S, 1, 3>(stacked.jacobian.row(1))), second.jacobian);
}

TYPED_TEST(MarkerSightingTest, OnlyTheBearingsDifferenceWraps) {
    const BearingElevationRange<TypeParam> sighting{{1, 0, 0}};
    const Vector<TypeParam, 3> difference = sighting.minus({4, 4, 4}, {-1, -1, -1});
    const Vector<TypeParam, 3> expected(5 - 2 * kPi<TypeParam>, 5, 5);
    EXPECT_TRUE(close(difference, expected, kTight<TypeParam>));
}

TYPED_TEST(MarkerSightingTest, AtTheMarkerThereIsNoDirection) {
    const BearingElevationRange<TypeParam> sighting{{1, 2, 3}};
    EXPECT_FALSE(sighting.linearize({1, 2, 0}).defined);
    EXPECT_TRUE(sighting.linearize({TypeParam(1.001), 2, 0}).defined);
    EXPECT_FALSE(sighting.linearize({NAN, 2, 0}).defined);
}

TYPED_TEST(MarkerSightingTest, NearestUsableDistanceIsOverGround) {
    const BearingElevationRange<TypeParam> sighting{{1, 2, 3}, {}, TypeParam(0.5)};
    EXPECT_FALSE(sighting.linearize({TypeParam(1.49), 2, 0}).defined);
    EXPECT_TRUE(sighting.linearize({TypeParam(1.51), 2, 0}).defined);
}

TYPED_TEST(MarkerSightingTest, JacobianOfEveryMixIsTheDerivative) {
    using S = TypeParam;
    using B = Bearing<S>;
    using E = Elevation<S>;
    using R = Range<S>;
    for (const auto& x : poses<S>())
        for (const auto& marker : markers_around(x)) {
            expect_jacobians(MarkerSighting<S, B, E>{marker}, x);
            expect_jacobians(MarkerSighting<S, B, R>{marker}, x);
            expect_jacobians(MarkerSighting<S, E, R>{marker}, x);
            expect_jacobians(BearingElevationRange<S>{marker, {{}, {}, {S(1.069), S(0.12)}}}, x);
        }
}

}  // namespace
}  // namespace pilotage::test
