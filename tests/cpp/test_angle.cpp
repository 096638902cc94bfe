#include "pilotage/angle.hpp"

#include <limits>

#include "support/scalars.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(AngleTest);

TYPED_TEST(AngleTest, HalfATurnIsPlusPiFromBothSides) {
    constexpr TypeParam pi = kPi<TypeParam>;
    EXPECT_EQ(wrap(pi), pi);
    EXPECT_EQ(wrap(-pi), pi);
}

TYPED_TEST(AngleTest, AngleInsideIsLeftAsItIs) {
    const TypeParam just_below = std::nextafter(kPi<TypeParam>, TypeParam(0));
    for (const TypeParam angle :
         {TypeParam(0), TypeParam(1e-8), TypeParam(-3), just_below, -just_below})
        EXPECT_EQ(wrap(angle), angle);
}

TYPED_TEST(AngleTest, JustPastHalfATurnComesOutOnTheOtherSide) {
    const TypeParam past = kPi<TypeParam> + TypeParam(1e-3);
    EXPECT_NEAR(wrap(past), TypeParam(1e-3) - kPi<TypeParam>, kTight<TypeParam>);
    EXPECT_NEAR(wrap(-past), kPi<TypeParam> - TypeParam(1e-3), kTight<TypeParam>);
}

TYPED_TEST(AngleTest, WholeTurnsDoNotMatter) {
    for (const int turns : {-1000, -3, -2, -1, 1, 2, 3, 1000})
        for (const TypeParam angle : {TypeParam(-3), TypeParam(0), TypeParam(0.1), TypeParam(3)}) {
            const TypeParam turned = angle + TypeParam(turns) * 2 * kPi<TypeParam>;
            const TypeParam rounding = std::abs(turned) * std::numeric_limits<TypeParam>::epsilon();
            EXPECT_NEAR(wrap(turned), angle, kTight<TypeParam> + rounding) << turns << " turns";
        }
}

TYPED_TEST(AngleTest, EveryAngleEndsInTheHalfOpenInterval) {
    for (TypeParam angle = -40; angle < 40; angle += TypeParam(0.0137)) {
        const TypeParam wrapped = wrap(angle);
        EXPECT_GT(wrapped, -kPi<TypeParam>);
        EXPECT_LE(wrapped, kPi<TypeParam>);
        EXPECT_EQ(wrap(wrapped), wrapped);
        EXPECT_NEAR(std::cos(wrapped), std::cos(angle), 1e-5);
        EXPECT_NEAR(std::sin(wrapped), std::sin(angle), 1e-5);
    }
}

TYPED_TEST(AngleTest, OddHalfTurnsEndInTheHalfOpenInterval) {
    for (int half_turns = -99; half_turns < 100; half_turns += 2) {
        const TypeParam wrapped = wrap(TypeParam(half_turns) * kPi<TypeParam>);
        EXPECT_GT(wrapped, -kPi<TypeParam>) << half_turns;
        EXPECT_LE(wrapped, kPi<TypeParam>) << half_turns;
        EXPECT_NEAR(std::abs(wrapped), kPi<TypeParam>, 100 * kTight<TypeParam>) << half_turns;
    }
}

TYPED_TEST(AngleTest, NotANumberStaysNotANumber) {
    EXPECT_TRUE(std::isnan(wrap(std::numeric_limits<TypeParam>::quiet_NaN())));
    EXPECT_TRUE(std::isnan(wrap(std::numeric_limits<TypeParam>::infinity())));
    EXPECT_TRUE(std::isnan(wrap(-std::numeric_limits<TypeParam>::infinity())));
}

}  // namespace
}  // namespace pilotage::test
