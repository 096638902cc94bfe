#include "pilotage/motion/velocity.hpp"

#include "support/jacobians.hpp"
#include "support/points.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(VelocityTest);

template <typename Scalar>
using EulerVelocity = Velocity<Scalar, Chord::tangent>;
template <typename Scalar>
using MidpointVelocity = Velocity<Scalar, Chord::midpoint>;
template <typename Scalar>
using ArcVelocity = Velocity<Scalar, Chord::arc>;

template <typename Scalar>
using Rates = Vector<Scalar, 2>;  // speed [m/s], yaw rate [rad/s]

// The runnable example: 1 m/s and a quarter turn a second for two seconds is a half circle.
TEST(Velocity, HalfCircleEndsBesideItsStartLookingBack) {
    const Velocity<double, Chord::arc> model{2.0};
    const auto step = model.linearize({10, 20, 0}, Rates<double>(1, kPi<double> / 2));
    EXPECT_TRUE(same_pose<double>(step.next, {10, 20 + 4 / kPi<double>, kPi<double>}, 1e-12));
}

TYPED_TEST(VelocityTest, EulerIsTheFormulaToTheLetter) {  // eqs. 5 and 6 of Kohler
    const TypeParam dt = TypeParam(0.033);
    for (const auto& x : poses<TypeParam>())
        for (const auto& u : travels<TypeParam>()) {
            const TypeParam c = std::cos(x[kHeading]), s = std::sin(x[kHeading]);
            const auto step = EulerVelocity<TypeParam>{dt}.linearize(x, u);
            const Pose<TypeParam> expected(x[kX] + u[0] * c * dt, x[kY] + u[0] * s * dt,
                                           x[kHeading] + u[1] * dt);
            EXPECT_TRUE(same_pose<TypeParam>(step.next, expected, 50 * kTight<TypeParam>));
            Matrix<TypeParam, 3> a = Matrix<TypeParam, 3>::Identity();
            a(kX, kHeading) = -s * u[0] * dt;
            a(kY, kHeading) = c * u[0] * dt;
            EXPECT_TRUE(close(step.a.dense(), a, kTight<TypeParam>));
        }
}

// Erratum: Kohler's Q forgets 1/b^2. Wheels of variance 0.01 give it by B Gamma B'.
TEST(Velocity, WheelNoiseGivesKohlersQAsItShouldRead) {
    const double dt = 0.033, b = 0.287, variance = 0.01, heading = 0.7;
    Matrix<double, 2> gamma;  // of ((right + left) / 2, (right - left) / b)
    gamma << variance / 2, 0, 0, 2 * variance / (b * b);
    const auto by_u = EulerVelocity<double>{dt}.linearize({1, 2, heading}, {0.2, 0.5}).b;
    const double c = std::cos(heading), s = std::sin(heading);
    Matrix<double, 3> q;
    q << c * c / 2, c * s / 2, 0, c * s / 2, s * s / 2, 0, 0, 0, 2 / (b * b);
    EXPECT_TRUE(close(by_u * gamma * by_u.transpose(), dt * dt * variance * q, 1e-15));
    EXPECT_NEAR(dt * dt * variance * q(2, 2), 2.64e-4, 1e-6);  // printed: 2.178e-5
}

double error_after_a_second(double dt_s, Chord chord) {
    const Rates<double> u(1, 2);
    Pose<double> x(0, 0, 0);
    const auto drive = [&](const auto& model) {
        for (int i = 0; i < std::lround(1 / dt_s); ++i) x = model.linearize(x, u).next;
    };
    chord == Chord::tangent ? drive(EulerVelocity<double>{dt_s})
                            : drive(MidpointVelocity<double>{dt_s});
    return (x - ArcVelocity<double>{1}.linearize({0, 0, 0}, u).next).head<2>().norm();
}

TEST(Velocity, EulersErrorIsOfFirstOrderAndTheMidpointsOfSecond) {
    EXPECT_NEAR(
        error_after_a_second(0.02, Chord::tangent) / error_after_a_second(0.01, Chord::tangent), 2,
        0.05);
    EXPECT_NEAR(
        error_after_a_second(0.02, Chord::midpoint) / error_after_a_second(0.01, Chord::midpoint),
        4, 0.05);
}

TYPED_TEST(VelocityTest, ArcCutInTwoEndsWhereTheWholeArcEnds) {
    const TypeParam slip = TypeParam(0.1);
    for (const auto& u : travels<TypeParam>()) {
        const Pose<TypeParam> start(1, 2, 3);
        const auto middle = ArcVelocity<TypeParam>{TypeParam(0.3), slip}.linearize(start, u).next;
        EXPECT_TRUE(same_pose<TypeParam>(
            ArcVelocity<TypeParam>{TypeParam(0.7), slip}.linearize(middle, u).next,
            ArcVelocity<TypeParam>{1, slip}.linearize(start, u).next, kTight<TypeParam>));
    }
}

// Eqs. 36 and 37 of Tamas et al. 2008, whose beta is minus the slip angle.
TEST(Velocity, CourseIsHeadingPlusSlipAngle) {
    const double heading = 0.4, beta = 0.15, t = 0.1, v = 1.2;
    const auto next = EulerVelocity<double>{t, -beta}.linearize({1, 2, heading}, {v, 0}).next;
    const Pose<double> expected(1 + t * v * std::cos(heading - beta),
                                2 + t * v * std::sin(heading - beta), heading);
    EXPECT_TRUE(same_pose<double>(next, expected, 1e-15));
}

TYPED_TEST(VelocityTest, JacobiansAreDerivatives) {
    for (const TypeParam dt : {TypeParam(0.04), TypeParam(1.5)})
        for (const auto& x : poses<TypeParam>())
            for (const auto& u : travels<TypeParam>()) {
                expect_jacobians(EulerVelocity<TypeParam>{dt}, x, u);
                expect_jacobians(MidpointVelocity<TypeParam>{dt}, x, u);
                expect_jacobians(ArcVelocity<TypeParam>{dt, TypeParam(0.1)}, x, u);
            }
}

/// exp(A) by its series.
Matrix<double, 3> exponential(const Matrix<double, 3>& a) {
    Matrix<double, 3> sum = Matrix<double, 3>::Identity(), term = sum;
    for (int n = 1; n < 30; ++n) sum += term = term * a / n;
    return sum;
}

TEST(LinearizedVelocity, MovesTheCovarianceByTheExponentialOfTheKinematics) {
    const double dt = 0.04;
    for (const auto& x : poses<double>())
        for (const auto& u : travels<double>()) {
            Matrix<double, 3> kinematics = Matrix<double, 3>::Zero();  // eq. 6, at the start
            kinematics(kX, kHeading) = -u[0] * std::sin(x[kHeading]);
            kinematics(kY, kHeading) = u[0] * std::cos(x[kHeading]);
            const auto step = LinearizedVelocity<double>{dt}.linearize(x, u);
            EXPECT_TRUE(close(step.a.dense(), exponential(kinematics * dt), 1e-15));
            const auto exact = ArcVelocity<double>{dt}.linearize(x, u);
            EXPECT_EQ(step.next, exact.next);
            EXPECT_EQ(step.b, exact.b);
        }
}

}  // namespace
}  // namespace pilotage::test
