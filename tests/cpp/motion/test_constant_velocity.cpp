#include "pilotage/motion/constant_velocity.hpp"

#include "pilotage/filter/ekf.hpp"
#include "pilotage/sensing/direct.hpp"
#include "pilotage/sensing/wheel_travel.hpp"
#include "support/jacobians.hpp"
#include "support/points.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(ConstantVelocityTest);

template <typename Scalar>
using State = Vector<Scalar, kVelocityStates>;

template <typename Scalar>
State<Scalar> moving_state(const Pose<Scalar>& pose, const Vector<Scalar, 2>& velocity) {
    State<Scalar> x;
    x << pose, velocity;
    return x;
}

// The runnable example: a filter that knows nothing of its velocities learns them from encoders and
// gyro, and drives the arc with what it learnt.
TEST(ConstantVelocity, VelocitiesAreLearntFromEncodersAndGyro) {
    Vector<double, kVelocityStates> variances;
    variances << 0, 0, 0, 4, 1;
    Ekf<double, kVelocityStates> filter(State<double>::Zero(), diagonal(variances));
    const Vector<double, 2> accelerations(0, 0), variance_of_them(1e-4, 1e-4);
    const double dt = 0.02;
    for (int i = 0; i < 500; ++i) {
        filter.predict(ConstantVelocity<double>{dt}, accelerations, diagonal(variance_of_them),
                       State<double>::Zero());
        EXPECT_TRUE(
            filter.update(Speed<double>{}, Vector<double, 1>(0.8), Matrix<double, 1>(1e-4), {})
                .accepted());
        EXPECT_TRUE(
            filter.update(YawRate<double>{}, Vector<double, 1>(-0.3), Matrix<double, 1>(1e-6), {})
                .accepted());
    }
    EXPECT_NEAR(filter.state()[kSpeed], 0.8, 1e-3);
    EXPECT_NEAR(filter.state()[kYawRate], -0.3, 1e-4);
    const auto driven = Velocity<double, Chord::arc>{10}.linearize({0, 0, 0}, {0.8, -0.3}).next;
    EXPECT_TRUE(same_pose<double>(filter.state().head<3>(), driven, 0.03));
}

TYPED_TEST(ConstantVelocityTest, WithoutAccelerationItIsTheExactArc) {
    for (const auto& pose : poses<TypeParam>())
        for (const auto& velocity : travels<TypeParam>()) {
            const auto step = ConstantVelocity<TypeParam>{TypeParam(0.1)}.linearize(
                moving_state(pose, velocity), {0, 0});
            const auto drive =
                Velocity<TypeParam, Chord::arc>{TypeParam(0.1)}.linearize(pose, velocity);
            EXPECT_EQ((Pose<TypeParam>(step.next.template head<3>())), drive.next);
            EXPECT_EQ((Vector<TypeParam, 2>(step.next.template tail<2>())), velocity);
        }
}

TYPED_TEST(ConstantVelocityTest, StepCutInTwoEndsWhereTheWholeStepEnds) {
    for (const auto& velocity : travels<TypeParam>()) {
        const auto start = moving_state<TypeParam>({1, 2, 3}, velocity);
        const auto middle =
            ConstantVelocity<TypeParam>{TypeParam(0.3)}.linearize(start, {0, 0}).next;
        EXPECT_TRUE(same_pose<TypeParam>(
            ConstantVelocity<TypeParam>{TypeParam(0.7)}
                .linearize(middle, {0, 0})
                .next.template head<3>(),
            ConstantVelocity<TypeParam>{1}.linearize(start, {0, 0}).next.template head<3>(),
            kTight<TypeParam>));
    }
}

TYPED_TEST(ConstantVelocityTest, StraightAccelerationAddsHalfOfItTimesTheTimeSquared) {
    const auto next =
        ConstantVelocity<TypeParam>{2}
            .linearize(moving_state<TypeParam>({0, 0, 0}, {1, 0}), {TypeParam(0.5), 0})
            .next;
    EXPECT_TRUE(close(next, moving_state<TypeParam>({3, 0, 0}, {2, 0}), kTight<TypeParam>));
}

TYPED_TEST(ConstantVelocityTest, JacobiansAreDerivatives) {
    Draw draw(4);
    for (const auto& pose : poses<TypeParam>())
        for (const auto& velocity : travels<TypeParam>())
            for (const auto& u : {Vector<TypeParam, 2>(0, 0), draw.normal<TypeParam, 2>()})
                expect_jacobians(ConstantVelocity<TypeParam>{TypeParam(0.1)},
                                 moving_state(pose, velocity), u);
}

TYPED_TEST(ConstantVelocityTest, WheelsTravelBySpeedAndTurn) {
    const WheelTravel<TypeParam> wheels{TypeParam(0.5), 2};
    const auto left_turn = moving_state<TypeParam>({1, 2, 3}, {1, TypeParam(0.4)});
    const Vector<TypeParam, 2> travel(TypeParam(1.8), TypeParam(2.2));  // left, right
    EXPECT_TRUE(close(wheels.linearize(left_turn).value, travel, kTight<TypeParam>));
    expect_jacobians(wheels, left_turn);
}

TYPED_TEST(ConstantVelocityTest, SensorsOfTheVelocitiesSeeThemAsTheyAre) {
    const auto x = moving_state<TypeParam>({1, 2, 3}, {4, 5});
    const Speed<TypeParam> encoders;
    const YawRate<TypeParam> gyro;
    EXPECT_EQ(encoders.linearize(x.template head<4>()).value[0], 4);
    EXPECT_EQ(gyro.linearize(x).value[0], 5);
    const Vector<TypeParam, 1> fast(9), slow(-9);
    EXPECT_EQ(gyro.minus(fast, slow)[0], 18);  // a rate is no angle
    expect_jacobians(encoders, Vector<TypeParam, 4>(x.template head<4>()));
    expect_jacobians(gyro, x);
}

}  // namespace
}  // namespace pilotage::test
