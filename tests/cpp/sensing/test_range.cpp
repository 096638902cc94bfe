#include "pilotage/sensing/range.hpp"

#include "support/jacobians.hpp"
#include "support/points.hpp"
#include "support/sightings.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(RangeTest);

TYPED_TEST(RangeTest, RangeIsTheSlantDistance) {
    const RangeOnly<TypeParam> sighting{{4, 6, 12}};  // 3, 4 and 12 m away: 13 m
    EXPECT_NEAR(sighting.linearize({1, 2, 3}).value[0], 13, 13 * kTight<TypeParam>);
}

TYPED_TEST(RangeTest, SensorReportsScaledAndShiftedDistance) {
    const RangeOnly<TypeParam> sighting{{4, 6, 0}, {{TypeParam(1.1), TypeParam(0.25)}}};
    EXPECT_NEAR(sighting.linearize({1, 2, 3}).value[0], 5.75, 5 * kTight<TypeParam>);
}

TYPED_TEST(RangeTest, DrivingAtTheMarkerShortensItMetreByMetre) {
    const auto h = RangeOnly<TypeParam>{{9, 2, 0}}.linearize({1, 2, 3}).jacobian;
    EXPECT_TRUE(close(h, (Matrix<TypeParam, 1, 3>(-1, 0, 0)), kTight<TypeParam>));
}

TYPED_TEST(RangeTest, JacobianIsTheDerivative) {
    for (const auto& x : poses<TypeParam>())
        for (const auto& marker : markers_around(x)) {
            expect_jacobians(RangeOnly<TypeParam>{marker}, x);
            expect_jacobians(RangeOnly<TypeParam>{marker, {{TypeParam(1.069), TypeParam(0.12)}}},
                             x);
        }
}

}  // namespace
}  // namespace pilotage::test
