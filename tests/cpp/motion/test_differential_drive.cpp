#include "pilotage/motion/differential_drive.hpp"

#include "support/jacobians.hpp"
#include "support/points.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(DifferentialDriveTest);

constexpr double kTrackWidth = 1.041;  // m

template <typename Scalar>
DifferentialDrive<Scalar> mower() {
    return {Scalar(kTrackWidth)};
}

TYPED_TEST(DifferentialDriveTest, EqualWheelsDriveStraight) {
    const auto next = mower<TypeParam>().linearize({1, 2, 0}, {3, 3}).next;
    EXPECT_TRUE(same_pose<TypeParam>(next, {4, 2, 0}, kTight<TypeParam>));
}

TYPED_TEST(DifferentialDriveTest, OppositeWheelsTurnOnTheSpotTowardsTheSlowerOne) {
    const TypeParam travel = TypeParam(0.1);
    const auto next = mower<TypeParam>().linearize({1, 2, 0}, {-travel, travel}).next;
    const TypeParam left_turn = TypeParam(0.2 / kTrackWidth);
    EXPECT_TRUE(same_pose<TypeParam>(next, {1, 2, left_turn}, kTight<TypeParam>));
}

TYPED_TEST(DifferentialDriveTest, GyroDecidesTheTurnWhateverTheWheelsSay) {
    const TypeParam turn = TypeParam(0.25);
    const auto next =
        GyroDrive<TypeParam>{}.linearize({0, 0, 0}, {TypeParam(0.9), TypeParam(1.1), turn}).next;
    EXPECT_TRUE(same_pose<TypeParam>(next, {std::cos(turn / 2), std::sin(turn / 2), turn},
                                     kTight<TypeParam>));
}

TYPED_TEST(DifferentialDriveTest, BothAgreeWhenTheGyroReadsWhatTheWheelsSay) {
    for (const auto& x : poses<TypeParam>()) {
        const Vector<TypeParam, 2> wheels(TypeParam(0.3), TypeParam(0.5));
        const TypeParam turn = (wheels[1] - wheels[0]) / TypeParam(kTrackWidth);
        EXPECT_TRUE(same_pose<TypeParam>(
            GyroDrive<TypeParam>{}.linearize(x, {wheels[0], wheels[1], turn}).next,
            mower<TypeParam>().linearize(x, wheels).next, kTight<TypeParam>));
    }
}

TYPED_TEST(DifferentialDriveTest, JacobiansAreDerivatives) {
    for (const auto& x : poses<TypeParam>())
        for (const auto& u : travels<TypeParam>()) {  // as left and right, then as wheels and gyro
            expect_jacobians(mower<TypeParam>(), x, u);
            expect_jacobians(GyroDrive<TypeParam>{}, x, Vector<TypeParam, 3>(u[0], u[0] / 2, u[1]));
        }
}

/// B as the paper prints it: it takes the turn to come from the wheels.
template <typename Scalar>
Matrix<Scalar, 3, 2> printed_equation_22(const Pose<Scalar>& x, const Vector<Scalar, 2>& wheels,
                                         Scalar turn) {
    const Scalar c = std::cos(x[kHeading] + turn / 2), s = std::sin(x[kHeading] + turn / 2);
    const Scalar b = Scalar(kTrackWidth), by_turn = wheels.mean() / (2 * b);
    Matrix<Scalar, 3, 2> result;
    result << c / 2 + by_turn * s, c / 2 - by_turn * s,  //
        s / 2 - by_turn * c, s / 2 + by_turn * c,        //
        -1 / b, 1 / b;
    return result;
}

TYPED_TEST(DifferentialDriveTest, PrintedEquation22HoldsForHeadingFromTheWheels) {
    const Pose<TypeParam> x(1, 2, TypeParam(0.4));
    const Vector<TypeParam, 2> wheels(TypeParam(0.9), TypeParam(1.1));
    const TypeParam turn = (wheels[1] - wheels[0]) / TypeParam(kTrackWidth);
    EXPECT_TRUE(close(mower<TypeParam>().linearize(x, wheels).b,
                      printed_equation_22(x, wheels, turn), kTight<TypeParam>));
}

// Erratum: with the gyro the wheels do not turn the robot, and the gyro has a column of its own.
TYPED_TEST(DifferentialDriveTest, PrintedEquation22FailsForHeadingFromTheGyro) {
    const Pose<TypeParam> x(1, 2, TypeParam(0.4));
    const Vector<TypeParam, 3> u(TypeParam(0.9), TypeParam(1.1), TypeParam(0.2));
    const auto b = GyroDrive<TypeParam>{}.linearize(x, u).b;
    const auto printed = printed_equation_22<TypeParam>(x, u.template head<2>(), u[2]);
    EXPECT_FALSE(close(b.template leftCols<2>(), printed, 0.1));
    const TypeParam c = std::cos(TypeParam(0.5)), s = std::sin(TypeParam(0.5));
    Matrix<TypeParam, 3, 3> corrected;  // the distance is 1 m
    corrected << c / 2, c / 2, -s / 2, s / 2, s / 2, c / 2, 0, 0, 1;
    EXPECT_TRUE(close(b, corrected, kTight<TypeParam>));
}

}  // namespace
}  // namespace pilotage::test
