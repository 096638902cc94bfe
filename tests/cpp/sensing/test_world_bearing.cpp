#include "pilotage/sensing/world_bearing.hpp"

#include "support/jacobians.hpp"
#include "support/points.hpp"
#include "support/sightings.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(WorldBearingTest);

// The runnable example: a robot 1 m south of a marker.
TEST(WorldBearing, IsTheDirectionFromTheMarkerToTheRobot) {
    const WorldBearingOnly<double> sighting{{4, 6, 0}};
    EXPECT_DOUBLE_EQ(sighting.linearize({4, 5, 0.3}).value[0], -kPi<double> / 2);
}

TYPED_TEST(WorldBearingTest, HeadingIsNotSeen) {
    const WorldBearingOnly<TypeParam> sighting{{4, 6, 0}};
    const auto h = sighting.linearize({1, 2, TypeParam(0.3)});
    EXPECT_EQ(h.value, sighting.linearize({1, 2, -2}).value);
    EXPECT_EQ(h.jacobian(0, kHeading), 0);
}

// Erratum: looking towards +x the angle sits at pi, and the innovation has to wrap.
TYPED_TEST(WorldBearingTest, InnovationBeforeAMarkerToTheEastIsTheShortWay) {
    const WorldBearingOnly<TypeParam> sighting{{5, 0, 0}};
    const auto predicted = sighting.linearize({0, TypeParam(0.1), 0}).value;
    const auto measured = sighting.linearize({0, TypeParam(-0.1), 0}).value;
    EXPECT_GT(std::abs(measured[0] - predicted[0]), 6);
    EXPECT_NEAR(sighting.minus(measured, predicted)[0], 2 * std::atan(0.02), kTight<TypeParam>);
}

TYPED_TEST(WorldBearingTest, JacobianIsTheDerivative) {
    for (const auto& x : poses<TypeParam>())
        for (const auto& marker : markers_around(x))
            expect_jacobians(WorldBearingOnly<TypeParam>{marker}, x);
}

}  // namespace
}  // namespace pilotage::test
