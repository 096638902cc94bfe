#include "support/jacobians.hpp"
#include "support/points.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(MoveAndTurnTest);

template <typename Scalar>
Pose<Scalar> moved(const Pose<Scalar>& start, double distance, double turn) {
    return MoveAndTurn<Scalar>{}.linearize(start, {Scalar(distance), Scalar(turn)}).next;
}

// The runnable example: a square of 2 m, a side and a corner at a time.
TEST(MoveAndTurn, FourSidesAndCornersEndWhereTheyBegan) {
    Pose<double> x(1, 2, 0.3);
    for (int side = 0; side < 4; ++side) x = moved(x, 2, kPi<double> / 2);
    EXPECT_TRUE(same_pose<double>(x, {1, 2, 0.3}, 1e-12));
}

TYPED_TEST(MoveAndTurnTest, TheTurnComesAfterTheMove) {
    const auto next = moved<TypeParam>({1, 2, 0}, 3, 0.5);
    EXPECT_TRUE(same_pose<TypeParam>(next, {4, 2, TypeParam(0.5)}, kTight<TypeParam>));
}

TYPED_TEST(MoveAndTurnTest, ErrorOfTheTurnDoesNotMoveTheRobot) {
    const auto b = MoveAndTurn<TypeParam>{}.linearize({1, 2, TypeParam(0.3)}, {2, 1}).b;
    EXPECT_EQ((Vector<TypeParam, 3>(b.col(1))), (Vector<TypeParam, 3>(0, 0, 1)));
}

// The worked example's new state. It follows from the distance and turn that the robot really made,
// not from the commanded 1.75 m and 90 degrees.
TEST(MoveAndTurn, ReachesTheStateOfTheAssignmentsExample) {
    const double degree = kPi<double> / 180;
    const auto next = moved<double>({1.10114, -1.25, 86.0965 * degree}, 1.7599, 95.87 * degree);
    EXPECT_NEAR(next[kX], 1.22095, 1e-5);
    EXPECT_NEAR(next[kY], 0.505793, 5e-5);
    EXPECT_NEAR(next[kHeading], wrap(181.969 * degree), 5e-3 * degree);
}

TYPED_TEST(MoveAndTurnTest, JacobiansAreDerivatives) {
    for (const auto& x : poses<TypeParam>())
        for (const auto& u : travels<TypeParam>()) expect_jacobians(MoveAndTurn<TypeParam>{}, x, u);
}

}  // namespace
}  // namespace pilotage::test
