#include "pilotage/motion/skid_steer.hpp"

#include "support/jacobians.hpp"
#include "support/points.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(SkidSteerTest);

template <typename Scalar>
using Wheels = Vector<Scalar, 2>;  // right, left [m/s]
template <typename Scalar>
using Body = Vector<Scalar, 3>;  // forward, leftward [m/s], yaw rate [rad/s]

template <typename Scalar>
Matrix<Scalar, 3, 2> coefficients(double forward, double lateral, double by_track) {
    Matrix<Scalar, 3, 2> result;
    result << Scalar(forward), Scalar(forward), Scalar(lateral), Scalar(-lateral), Scalar(by_track),
        Scalar(-by_track);
    return result;
}

// The runnable example: a robot whose tail swings out to the right while it turns left.
TEST(SkidSteer, WheelsDecideForwardLateralAndYawRate) {
    const SkidSteer<double> robot{coefficients<double>(0.5, -0.02, 2.0), 0.1};
    const auto slow_turn = robot.linearize({0, 0, 0}, Wheels<double>(1.05, 0.95));
    const auto same = PlanarVelocity<double>{0.1}.linearize({0, 0, 0}, {1.0, -0.002, 0.2});
    EXPECT_TRUE(same_pose<double>(slow_turn.next, same.next, 1e-15));
}

TYPED_TEST(SkidSteerTest, SymmetricCoefficientsAreADifferentialDriveOnItsExactArc) {
    const double track_width = 0.4;
    const SkidSteer<TypeParam> skid{coefficients<TypeParam>(0.5, 0, 1 / track_width), 2};
    const auto left = TypeParam(0.3), right = TypeParam(0.5);
    const Vector<TypeParam, 2> driven(right + left, (right - left) / TypeParam(track_width) * 2);
    for (const auto& x : poses<TypeParam>())
        EXPECT_TRUE(same_pose<TypeParam>(
            skid.linearize(x, {right, left}).next,
            Unicycle<TypeParam, Chord::arc>{}.linearize(x, driven).next, 20 * kTight<TypeParam>));
}

TYPED_TEST(SkidSteerTest, LeftwardVelocityMovesTheRobotToItsLeft) {
    const auto north =
        PlanarVelocity<TypeParam>{2}.linearize({1, 2, kPi<TypeParam> / 2}, {0, 3, 0});
    EXPECT_TRUE(same_pose<TypeParam>(north.next, {-5, 2, kPi<TypeParam> / 2}, kTight<TypeParam>));
}

// Facing the centre of a circle of 2 m radius all the way round.
TYPED_TEST(SkidSteerTest, DrivingSidewaysRoundAPointKeepsFacingIt) {
    const PlanarVelocity<TypeParam> quarter{kPi<TypeParam> / 2};
    const auto next = quarter.linearize({-2, 0, 0}, {0, -2, 1}).next;
    EXPECT_TRUE(same_pose<TypeParam>(next, {0, -2, kPi<TypeParam> / 2}, kTight<TypeParam>));
}

TYPED_TEST(SkidSteerTest, StepCutInTwoEndsWhereTheWholeStepEnds) {
    const Pose<TypeParam> start(1, 2, 3);
    for (const auto& u : travels<TypeParam>()) {
        const Body<TypeParam> body(u[0], TypeParam(0.4), u[1]);
        const auto middle = PlanarVelocity<TypeParam>{TypeParam(0.3)}.linearize(start, body).next;
        EXPECT_TRUE(same_pose<TypeParam>(
            PlanarVelocity<TypeParam>{TypeParam(0.7)}.linearize(middle, body).next,
            PlanarVelocity<TypeParam>{1}.linearize(start, body).next, kTight<TypeParam>));
    }
}

TYPED_TEST(SkidSteerTest, JacobiansAreDerivatives) {
    Draw draw(3);
    for (const auto& x : poses<TypeParam>())
        for (const auto& u : travels<TypeParam>()) {
            const auto lateral = draw.uniform<TypeParam>(-1, 1);
            expect_jacobians(PlanarVelocity<TypeParam>{TypeParam(0.1)}, x,
                             Body<TypeParam>(u[0], lateral, u[1]));
            expect_jacobians(SkidSteer<TypeParam>{draw.normal<TypeParam, 3, 2>(), TypeParam(0.1)},
                             x, u);
        }
}

}  // namespace
}  // namespace pilotage::test
