#include "pilotage/state.hpp"

#include "support/matchers.hpp"
#include "support/random.hpp"
#include "support/scalars.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(StateTest);

TYPED_TEST(StateTest, DifferenceAcrossTheWrapIsTheShortWay) {
    using P = Pose<TypeParam>;
    const TypeParam near_pi = kPi<TypeParam> - TypeParam(0.1);
    const P difference = minus(P(0, 0, -near_pi), P(0, 0, near_pi));
    EXPECT_NEAR(difference[kHeading], 0.2, kTight<TypeParam>);
}

TYPED_TEST(StateTest, SumAcrossTheWrapIsAHeadingAgain) {
    using P = Pose<TypeParam>;
    const P sum = plus(P(1, 2, TypeParam(3)), P(10, 20, TypeParam(0.5)));
    EXPECT_TRUE(close(sum, P(11, 22, TypeParam(3.5) - 2 * kPi<TypeParam>), kTight<TypeParam>));
}

TYPED_TEST(StateTest, OnlyTheHeadingWraps) {
    Vector<TypeParam, 6> x, dx;
    x << 4, -5, 1, 6, 7, -8;
    dx << 1, -1, 0, 1, 1, -1;
    Vector<TypeParam, 6> expected;
    expected << 5, -6, 1, 7, 8, -9;
    EXPECT_EQ((plus<TypeParam, 6>(x, dx)), expected);
    EXPECT_EQ((minus<TypeParam, 6>(expected, dx)), x);
}

TYPED_TEST(StateTest, PlusUndoesMinus) {
    Draw draw(1);
    for (int i = 0; i < 1000; ++i) {
        const auto a = draw.pose<TypeParam>(), b = draw.pose<TypeParam>();
        EXPECT_TRUE(same_pose<TypeParam>(plus<TypeParam, 3>(b, minus<TypeParam, 3>(a, b)), a,
                                         50 * kTight<TypeParam>));
    }
}

}  // namespace
}  // namespace pilotage::test
