#include "pilotage/sensing/relative_position.hpp"

#include <Eigen/Eigenvalues>

#include "pilotage/sensing/mounted.hpp"
#include "support/jacobians.hpp"
#include "support/points.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(RelativePositionTest);

constexpr double kSigmaDistance = 0.1, kSigmaBearing = 0.06;  // of the paper

// The runnable example: looking north, a pole 3 m to the east is 3 m to the right.
TEST(RelativePosition, PoleIsSeenInTheFrameOfTheRobot) {
    const RelativePosition<double> pole{{13, 24}};
    const auto h = pole.linearize({10, 20, kPi<double> / 2});
    EXPECT_TRUE(close(h.value, Vector<double, 2>(4, -3), 1e-12));
}

TYPED_TEST(RelativePositionTest, PoleAtTheRobotIsDefined) {
    const auto h = RelativePosition<TypeParam>{{1, 2}}.linearize({1, 2, 3});
    EXPECT_TRUE(h.defined);
    EXPECT_EQ(h.value, (Vector<TypeParam, 2>(0, 0)));
}

TYPED_TEST(RelativePositionTest, JacobianIsTheDerivative) {
    const PlanarMounting<TypeParam> at{TypeParam(0.4), TypeParam(-0.1), TypeParam(0.3)};
    for (const auto& x : poses<TypeParam>())
        for (const auto& marker : markers_around(x)) {
            const RelativePosition<TypeParam> pole{marker.template head<2>()};
            expect_jacobians(pole, x);
            expect_jacobians(Mounted<RelativePosition<TypeParam>, TypeParam>{pole, at}, x);
        }
}

TYPED_TEST(RelativePositionTest, NoiseHasTheLineOfSightAsAxisAndGrowsWithDistance) {
    const TypeParam along = TypeParam(kSigmaDistance), angle = TypeParam(kSigmaBearing);
    const auto ahead = relative_position_noise<TypeParam>({5, 0}, along, angle);
    EXPECT_TRUE(close(ahead, diagonal<TypeParam, 2>({TypeParam(0.25), TypeParam(0.09)}),
                      kTight<TypeParam>));
    const auto left = relative_position_noise<TypeParam>({0, 10}, along, angle);
    EXPECT_TRUE(close(left, diagonal<TypeParam, 2>({TypeParam(0.36), 1}), kTight<TypeParam>));
}

// Eqs. 13, 14 and 16 with the rotation of eq. 15, and with its transpose.
Matrix<double, 2> by_rotation(const Vector<double, 2>& relative, bool as_printed) {
    const double distance = relative.norm();
    const double angle = std::atan2(relative[1], relative[0]) * (as_printed ? -1 : 1);
    Matrix<double, 2> rotation;
    rotation << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    const Vector<double, 2> sigmas(kSigmaDistance * distance, kSigmaBearing * distance);
    return rotation * diagonal<double, 2>(sigmas.cwiseAbs2()) * rotation.transpose();
}

// Erratum: printed transposed, which mirrors the ellipse.
TEST(RelativePosition, NoiseIsEquation16WithTheRotationTransposed) {
    Draw draw(5);
    for (int i = 0; i < 100; ++i) {
        const Vector<double, 2> relative = 5 * draw.normal<double, 2>();
        const auto noise = relative_position_noise(relative, kSigmaDistance, kSigmaBearing);
        EXPECT_TRUE(close(noise, by_rotation(relative, false), 1e-14));
        EXPECT_NEAR(noise(0, 1), -by_rotation(relative, true)(0, 1), 1e-14);
    }
}

// Monte Carlo, seeded: distance and angle of what is measured scatter by themselves.
TEST(RelativePosition, NoiseIsTheCovarianceOfMeasuredPoles) {
    const double distance = 5, bearing = 0.8;
    const Vector<double, 2> pole(distance * std::cos(bearing), distance * std::sin(bearing));
    Draw draw(6);
    Matrix<double, 2> sum = Matrix<double, 2>::Zero();
    const int draws = 200000;
    for (int i = 0; i < draws; ++i) {
        const auto error = draw.normal<double, 2>();
        const double d = distance * (1 + kSigmaDistance * error[0]);
        const double angle = bearing + kSigmaBearing * error[1];
        const Vector<double, 2> off =
            Vector<double, 2>(std::cos(angle), std::sin(angle)) * d - pole;
        sum += off * off.transpose();
    }
    const auto noise = relative_position_noise(pole, kSigmaDistance, kSigmaBearing);
    EXPECT_GT(noise(0, 1), 0.07);
    EXPECT_TRUE(close(sum / draws, noise, 0.01)) << noise;
}

}  // namespace
}  // namespace pilotage::test
