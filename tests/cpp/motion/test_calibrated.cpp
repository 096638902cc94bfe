#include "pilotage/motion/calibrated.hpp"

#include "pilotage/motion/unicycle.hpp"
#include "support/jacobians.hpp"
#include "support/points.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(CalibratedTest);

template <typename Scalar>
Calibrated<Unicycle<Scalar, Chord::arc>, Scalar> calibrated(double gyro_time_s) {
    return {{Scalar(-0.08)}, Scalar(gyro_time_s)};
}

template <typename Scalar>
Vector<Scalar, 6> calibrated_state(const Pose<Scalar>& pose, double bias, double distance,
                                   double rotation) {
    Vector<Scalar, 6> x;
    x << pose, Scalar(bias), Scalar(distance), Scalar(rotation);
    return x;
}

TYPED_TEST(CalibratedTest, PerfectCalibrationIsThePlainModel) {
    const auto model = calibrated<TypeParam>(0.02);
    for (const auto& pose : poses<TypeParam>())
        for (const auto& u : travels<TypeParam>()) {
            const auto next = model.linearize(calibrated_state(pose, 0, 1, 1), u).next;
            EXPECT_EQ((Pose<TypeParam>(next.template head<3>())),
                      model.model.linearize(pose, u).next);
        }
}

TYPED_TEST(CalibratedTest, BiasOfAStandingRobotsGyroDoesNotTurnIt) {
    const double bias = 0.01, dt = 0.5;
    const Vector<TypeParam, 2> standing(0, TypeParam(bias * dt));
    const auto x = calibrated_state<TypeParam>({1, 2, 3}, bias, 1.02, 0.98);
    const auto next = calibrated<TypeParam>(dt).linearize(x, standing).next;
    EXPECT_TRUE(close(next, x, kTight<TypeParam>));
}

TYPED_TEST(CalibratedTest, ScalesStretchDistanceAndTurn) {
    const Pose<TypeParam> start(1, 2, 3);
    const auto model = calibrated<TypeParam>(0.02);
    const auto next =
        model.linearize(calibrated_state(start, 0, 1.5, 0.5), {2, TypeParam(0.4)}).next;
    EXPECT_TRUE(same_pose<TypeParam>(next.template head<3>(),
                                     model.model.linearize(start, {3, TypeParam(0.2)}).next,
                                     kTight<TypeParam>));
}

TYPED_TEST(CalibratedTest, CalibrationItselfDoesNotMove) {
    const auto x = calibrated_state<TypeParam>({1, 2, 3}, 0.01, 1.02, 0.98);
    const auto next = calibrated<TypeParam>(0.02).linearize(x, {2, TypeParam(0.4)}).next;
    EXPECT_EQ((Vector<TypeParam, 3>(next.template tail<3>())),
              (Vector<TypeParam, 3>(x.template tail<3>())));
}

TYPED_TEST(CalibratedTest, JacobiansByAllSixStatesAreDerivatives) {
    Draw draw(5);
    for (const auto& pose : poses<TypeParam>())
        for (const auto& u : travels<TypeParam>())
            for (const double gyro_time : {0.0, 0.01, 1.0}) {
                expect_jacobians(calibrated<TypeParam>(gyro_time), calibrated_state(pose, 0, 1, 1),
                                 u);
                const auto x = calibrated_state(pose, draw.uniform(-0.1, 0.1),
                                                draw.uniform(0.8, 1.2), draw.uniform(0.8, 1.2));
                expect_jacobians(calibrated<TypeParam>(gyro_time), x, u);
            }
}

}  // namespace
}  // namespace pilotage::test
