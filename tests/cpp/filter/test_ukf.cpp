// Ukf where the answer is known: linear models, the equations as printed, angles at the wrap.

#include "pilotage/filter/ukf.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "pilotage/filter/linear_kalman.hpp"
#include "support/filters.hpp"
#include "support/linear_measurement.hpp"
#include "support/matchers.hpp"
#include "support/scalars.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(UkfTest);

template <typename Scalar, int N>
Ukf<Scalar, N> random_ukf(Draw& draw, double variance = 0.1) {
    const auto filter = random_filter<Scalar, N>(draw, variance);
    return {filter.state(), filter.covariance()};
}

/// x = A x + B u.
template <typename Scalar, int N, int Inputs>
struct LinearMotion {
    Matrix<Scalar, N> a;
    Matrix<Scalar, N, Inputs> b;

    struct Step {
        Vector<Scalar, N> next;
    };
    [[nodiscard]] Step linearize(const Vector<Scalar, N>& x,
                                 const Vector<Scalar, Inputs>& u) const noexcept {
        return {a * x + b * u};
    }
};

TYPED_TEST(UkfTest, IsTheKalmanFilterOnLinearModels) {
    using S = TypeParam;
    Draw draw(1);
    for (const Unscented& set : {Unscented{}, Unscented{1, 2, 0}, Unscented{1, 0, 1}})
        for (int i = 0; i < 100; ++i) {
            const Vector<S, 4> x = draw.normal<S, 4>();
            const auto p = draw.covariance<S, 4>();
            Ukf<S, 4, PlainSpace> unscented(x, p, set);
            LinearKalman<S, 4> linear(x, p);
            const LinearMotion<S, 4, 2> motion{draw.normal<S, 4, 4>() / 2, draw.normal<S, 4, 2>()};
            const Vector<S, 2> u = draw.normal<S, 2>();
            const auto gamma = draw.covariance<S, 2>();
            const Vector<S, 4> q = draw.normal<S, 4>().cwiseAbs2();
            unscented.predict(motion, u, gamma, q);
            Matrix<S, 4> noise = motion.b * gamma * motion.b.transpose();
            noise.diagonal() += q;
            linear.predict(motion.a, Vector<S, 4>(motion.b * u), noise);
            EXPECT_TRUE(close(unscented.state(), linear.state(), 10 * kTight<S>));
            EXPECT_TRUE(close(unscented.covariance(), linear.covariance(), 10 * kTight<S>));

            const LinearMeasurement<S, 2, 4> model{draw.normal<S, 2, 4>()};
            const auto r = draw.covariance<S, 2>();
            const Vector<S, 2> z = draw.normal<S, 2>();
            ASSERT_TRUE(unscented.update(model, z, r, Policy{}).accepted());
            ASSERT_TRUE(linear.update(z, model.h, r, Policy{}).accepted());
            EXPECT_TRUE(close(unscented.state(), linear.state(), 100 * kTight<S>));
            EXPECT_TRUE(close(unscented.covariance(), linear.covariance(), 100 * kTight<S>));
        }
}

/// Eqs. 24 to 28 of Tamas et al. 2008 with +R, from their own sigma points.
TEST(UkfEquationsTest, UpdateIsThePapers) {
    Draw draw(2);
    for (int i = 0; i < 200; ++i) {
        auto filter = random_ukf<double, 3>(draw, 0.02);
        const BearingElevationRange<double> model{
            marker_in_sight(draw, Ekf<double, 3>(filter.state(), filter.covariance()))};
        const Matrix<double, 3> root = filter.covariance().llt().matrixL();
        const auto h0 = model.linearize(filter.state()).value;
        Matrix<double, 3, 6> x, y;  // off the mean, and their images off its image
        for (int k = 0; k < 6; ++k) {
            x.col(k) = (k < 3 ? 1 : -1) * std::sqrt(3) * root.col(k % 3);
            const Pose<double> at = filter.state() + x.col(k);
            y.col(k) = model.minus(model.linearize(at).value, h0);
        }
        const Vector<double, 3> shift = y.rowwise().mean();
        y.colwise() -= shift;
        const auto r = draw.covariance<double, 3>(0.01);
        const Matrix<double, 3> p_yy = y * y.transpose() / 6 + r, p_xy = x * y.transpose() / 6;
        const Matrix<double, 3> k = p_xy * p_yy.inverse();
        const Vector<double, 3> z = h0 + draw.normal<double, 3>() * 0.1;
        const Vector<double, 3> innovation = model.minus(z, h0 + shift);
        const Pose<double> state = plus<double, 3>(filter.state(), k * innovation);
        const Matrix<double, 3> p = filter.covariance() - k * p_yy * k.transpose();
        const auto report = filter.update(model, z, r, Policy{});
        ASSERT_TRUE(report.accepted());
        EXPECT_TRUE(close(report.innovation, innovation, 1e-12));
        EXPECT_TRUE(close(report.s, p_yy, 1e-12));
        EXPECT_TRUE(same_pose<double>(filter.state(), state, 1e-11));
        EXPECT_TRUE(close(filter.covariance(), p, 1e-12));
    }
}

TYPED_TEST(UkfTest, IsTheEkfWhereTheGaussianIsNarrow) {
    using S = TypeParam;
    Draw draw(3);
    const S narrow = std::is_same_v<S, float> ? S(1e-2) : S(1e-4);
    for (int i = 0; i < 100; ++i) {
        auto ekf = random_filter<S, 6>(draw, 1);
        ekf = {ekf.state(), Matrix<S, 6>(ekf.covariance() * (narrow * narrow))};
        Ukf<S, 6> ukf(ekf.state(), ekf.covariance());
        const Vector<S, 2> u(draw.uniform<S>(-1, 1), draw.uniform<S>(-1, 1));
        const Matrix<S, 2> gamma = draw.covariance<S, 2>() * (narrow * narrow);
        const Vector<S, 6> q = Vector<S, 6>::Constant(narrow * narrow);
        const BearingElevationRange<S> sighting{marker_in_sight(draw, ekf)};
        ekf.predict(motion<S, 6>(), u, gamma, q);
        ukf.predict(motion<S, 6>(), u, gamma, q);
        const double tolerance = 100 * narrow * narrow;  // what the second order amounts to
        EXPECT_TRUE(close(ukf.state(), ekf.state(), tolerance));
        const Matrix<S, 3> r = Matrix<S, 3>::Identity() * narrow * narrow;
        const Vector<S, 3> z =
            sighting.linearize(ekf.state().template head<3>()).value + draw.normal<S, 3>() * narrow;
        ASSERT_TRUE(ekf.update(sighting, z, r, Policy{}).accepted());
        ASSERT_TRUE(ukf.update(sighting, z, r, Policy{}).accepted());
        EXPECT_TRUE(close(ukf.state(), ekf.state(), tolerance));
        EXPECT_TRUE(close(ukf.covariance() / (narrow * narrow),
                          ekf.covariance() / (narrow * narrow), 1000 * narrow));
    }
}

// An uncertain heading makes the robot's mean step shorter: E cos = exp(-v/2).
TYPED_TEST(UkfTest, PredictionKnowsThatTheMeanIsNoPointOfTheArc) {
    using S = TypeParam;
    const S variance = S(0.09);
    Ukf<S, 3> filter({0, 0, 0}, Vector<S, 3>(0, 0, variance).asDiagonal(), {1, 0, 2});
    filter.predict(Unicycle<S, Chord::midpoint>{}, Vector<S, 2>(1, 0),
                   Matrix<S, 2>(Matrix<S, 2>::Zero()), Vector<S, 3>(0, 0, 0));
    EXPECT_NEAR(filter.state()[kX], std::exp(-variance / 2), 1e-4);
    EXPECT_NEAR(filter.state()[kY], 0, kTight<S>);
    EXPECT_NEAR(filter.covariance()(kY, kHeading), variance * std::exp(-variance / 2), 1e-4);
}

TYPED_TEST(UkfTest, WithoutInputNoiseThePointsAreTheStatesAlone) {
    using S = TypeParam;
    Draw draw(4);
    auto filter = random_ukf<S, 3>(draw);
    const Vector<S, 2> u(S(0.5), S(0.3));
    const Unicycle<S, Chord::arc> model{};
    const auto alone = unscented_transform(
        filter.state(), filter.covariance(),
        [&](const Pose<S>& x) { return Pose<S>(model.linearize(x, u).next); },
        [](const Pose<S>& a, const Pose<S>& b) { return minus<S, 3>(a, b); });
    filter.predict(model, u, Matrix<S, 2>(Matrix<S, 2>::Zero()), Vector<S, 3>(0, 0, 0));
    EXPECT_TRUE(same_pose<S>(filter.state(), alone.mean, 50 * kTight<S>));
    EXPECT_TRUE(close(filter.covariance(), alone.covariance, kTight<S>));
}

/// The same drive and sighting, seen with the map turned until the robot looks along -x. The
/// points lie along the axes of the map, so the results differ a little; a slip is of whole
/// radians.
TYPED_TEST(UkfTest, NothingHappensAtTheWrap) {
    using S = TypeParam;
    const Vector<S, 3> variances(S(0.01), S(0.02), S(0.2));
    const Vector<S, 2> u(S(0.1), S(0.02));
    const Matrix<S, 2> gamma = Vector<S, 2>(S(1e-3), S(1e-2)).asDiagonal();
    const Vector<S, 3> q(0, 0, S(1e-3));
    const Matrix<S, 2> r = Matrix<S, 2>::Identity() * S(0.01);
    const auto drive = [&](S heading) {
        const Matrix<S, 2> turned = Eigen::Rotation2D<S>(heading).toRotationMatrix();
        Matrix<S, 3> p = variances.asDiagonal();
        p.template topLeftCorner<2, 2>() =
            turned * p.template topLeftCorner<2, 2>() * turned.transpose();
        Ukf<S, 3> filter({0, 0, heading}, p);
        Vector<S, 3> marker(-4, S(0.5), -1);  // behind: its bearing is at the wrap as well
        marker.template head<2>() = turned * marker.template head<2>();
        for (int i = 0; i < 5; ++i) {
            filter.predict(motion<S, 3>(), u, gamma, q);
            const BearingElevation<S> sighting{marker};
            const Vector<S, 2> z(-kPi<S> + S(0.05), S(-0.24));
            EXPECT_TRUE(filter.update(sighting, z, r, Policy{}).accepted());
        }
        Pose<S> pose = filter.state();
        pose.template head<2>() = turned.transpose() * pose.template head<2>();
        pose[kHeading] = wrap(pose[kHeading] - heading);
        return pose;
    };
    const Pose<S> away = drive(0);
    for (const S heading : {kPi<S>, S(3), S(-3), -kPi<S> + S(1e-3)})
        EXPECT_TRUE(same_pose<S>(drive(heading), away, 1e-4)) << heading;
}

}  // namespace
}  // namespace pilotage::test
