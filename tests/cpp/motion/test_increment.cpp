// From wheel travel, speeds and the gyro's turn to (distance, turn) with its
// covariance.

#include "pilotage/motion/increment.hpp"

#include "support/matchers.hpp"
#include "support/scalars.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(IncrementTest);

NoiseParams noise() {
    NoiseParams n;
    n.wheel_m_per_sqrt_m = 0.1;
    n.gyro_rad_per_sqrt_s = 0.02;
    return n;
}

template <typename Scalar>
Increment<Scalar> wheels(double left, double right) {
    return from_wheels(Scalar(left), Scalar(right), Scalar(0.25), Scalar(0.5), noise());
}

template <typename Scalar>
Increment<Scalar> with_gyro(Increment<Scalar> u, double turn_rad, HeadingSource source,
                            const NoiseParams& noise) {
    take_turn(u, Scalar(turn_rad), source, noise);
    return u;
}

template <typename Scalar>
Matrix<Scalar, 2> covariance(double distance, double cross, double turn) {
    Matrix<Scalar, 2> m;
    m << Scalar(distance), Scalar(cross), Scalar(cross), Scalar(turn);
    return m;
}

TYPED_TEST(IncrementTest, OfWheelsIsTheirMeanAndTheirDifferenceOverTheTrack) {
    const auto u = wheels<TypeParam>(0.4, 0.6);
    EXPECT_NEAR(u.distance_m, 0.5, 1e-6);
    EXPECT_NEAR(u.turn_rad, 0.4, 1e-6);
    EXPECT_EQ(u.gyro_share, 0);
    EXPECT_NEAR(u.dt_s, 0.25, 1e-6);
}

TYPED_TEST(IncrementTest, OfWheelsIsAsUnsureAsTheTravelOfEachWheel) {
    // J diag(vl, vr) J' with J = [1/2 1/2; -1/b 1/b], vl = 0.01 * 0.4, vr = 0.01
    // * 0.6.
    const auto expected = covariance<TypeParam>(0.01 / 4, 0.002, 0.01 / 0.25);
    EXPECT_TRUE(close(wheels<TypeParam>(0.4, 0.6).covariance, expected, 1e-7));
    EXPECT_TRUE(close(wheels<TypeParam>(-0.4, -0.6).covariance, expected, 1e-7))
        << "driving backwards is no surer";
    EXPECT_TRUE(close(wheels<TypeParam>(0, 0).covariance, covariance<TypeParam>(0, 0, 0), 0))
        << "wheels that stand know it";
}

TYPED_TEST(IncrementTest, OfSpeedsHoldsThemOverTheInterval) {
    using Scalar = TypeParam;
    const auto u = from_velocity(Scalar(-2), Scalar(0.3), Scalar(0.5), noise());
    EXPECT_NEAR(u.distance_m, -1, 1e-6);
    EXPECT_NEAR(u.turn_rad, 0.15, 1e-6);
    EXPECT_EQ(u.gyro_share, 1) << "the message's yaw rate has a rate sensor's bias";
    EXPECT_TRUE(close(u.covariance, covariance<Scalar>(0.005, 0, 0.0002), 1e-7));
}

TYPED_TEST(IncrementTest, WithTheGyroTakesTurnAndNoiseFromIt) {
    using Scalar = TypeParam;
    const auto u = with_gyro(wheels<Scalar>(0.4, 0.6), 0.1, HeadingSource::gyro, noise());
    EXPECT_NEAR(u.turn_rad, 0.1, 1e-6);
    EXPECT_NEAR(u.distance_m, 0.5, 1e-6);
    EXPECT_EQ(u.gyro_share, 1);
    EXPECT_TRUE(close(u.covariance, covariance<Scalar>(0.0025, 0, 0.0001), 1e-7))
        << "the turn no longer goes with the wheels' noise";
}

TYPED_TEST(IncrementTest, OfBothIsTheirInverseVarianceMean) {
    using Scalar = TypeParam;
    const auto w = wheels<Scalar>(0.4, 0.6);
    const auto u = with_gyro(w, 0.1, HeadingSource::both, noise());
    const double gyro = 0.0001, wheel = 0.04, sum = 1 / gyro + 1 / wheel;
    EXPECT_NEAR(u.turn_rad, (0.1 / gyro + 0.4 / wheel) / sum, 1e-6);
    EXPECT_NEAR(u.covariance(1, 1), 1 / sum, 1e-9);
    EXPECT_NEAR(u.gyro_share, 1 / gyro / sum, 1e-6);
    // cov(distance, turn) of the wheels, as far as the turn is still theirs.
    EXPECT_NEAR(u.covariance(0, 1), 0.002 * (1 / wheel / sum), 1e-9);
    EXPECT_EQ(u.covariance(0, 1), u.covariance(1, 0));
}

TYPED_TEST(IncrementTest, OfBothTrustsTheSurerOne) {
    using Scalar = TypeParam;
    const auto standing = with_gyro(wheels<Scalar>(0, 0), 0.01, HeadingSource::both, noise());
    EXPECT_EQ(standing.turn_rad, 0) << "wheels that stand are sure";
    NoiseParams sure_gyro = noise();
    sure_gyro.gyro_rad_per_sqrt_s = 0;
    const auto driving = with_gyro(wheels<Scalar>(0.4, 0.6), 0.1, HeadingSource::both, sure_gyro);
    EXPECT_NEAR(driving.turn_rad, 0.1, 1e-7);
    const auto neither = with_gyro(wheels<Scalar>(0, 0), 0.2, HeadingSource::both, sure_gyro);
    EXPECT_NEAR(neither.turn_rad, 0.1, 1e-7) << "0/0 is the plain mean";
}

TYPED_TEST(IncrementTest, CutInPartsAddsUpToTheWhole) {
    using Scalar = TypeParam;
    const auto u = with_gyro(wheels<Scalar>(0.4, 0.6), 0.1, HeadingSource::both, noise());
    const auto a = u.part(Scalar(0.3)), b = u.part(Scalar(0.7));
    EXPECT_NEAR(a.distance_m + b.distance_m, u.distance_m, 1e-6);
    EXPECT_NEAR(a.turn_rad + b.turn_rad, u.turn_rad, 1e-6);
    EXPECT_NEAR(a.dt_s + b.dt_s, u.dt_s, 1e-6);
    EXPECT_TRUE(close(a.covariance + b.covariance, u.covariance, 1e-7));
    EXPECT_EQ(a.gyro_share, u.gyro_share);
}

TYPED_TEST(IncrementTest, ProcessNoiseGrowsWithDistanceTurnAndTime) {
    using Scalar = TypeParam;
    NoiseParams n;
    n.position_m_per_sqrt_m = 0.1;
    n.position_m_per_sqrt_s = 0.2;
    n.heading_rad_per_sqrt_m = 0.3;
    n.heading_rad_per_sqrt_rad = 0.4;
    n.heading_rad_per_sqrt_s = 0.5;
    Increment<Scalar> u;
    u.dt_s = Scalar(2);
    u.distance_m = Scalar(-3);
    u.turn_rad = Scalar(-0.5);
    const Pose<Scalar> q = pose_process_noise(u, n);
    const double position = 0.01 * 3 + 0.04 * 2, heading = 0.09 * 3 + 0.16 * 0.5 + 0.25 * 2;
    EXPECT_TRUE(close(q, Pose<double>(position, position, heading), 1e-6));
}

TYPED_TEST(IncrementTest, CalibrationWalksWithItsOwnUnit) {
    using Scalar = TypeParam;
    Params params;
    params.gyro_bias.walk = 0.1;
    params.distance_scale.walk = 0.2;
    params.rotation_scale.walk = 0.3;
    Increment<Scalar> u;
    u.dt_s = Scalar(2);
    u.distance_m = Scalar(-3);
    u.turn_rad = Scalar(-0.5);
    EXPECT_TRUE(close(calibration_process_noise(u, params),
                      Vector<double, 3>(0.01 * 2, 0.04 * 3, 0.09 * 0.5), 1e-7));
}

}  // namespace
}  // namespace pilotage::test
