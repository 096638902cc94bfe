// The time update: start, calibration by state or by configuration, and the
// noise of eqs. 21 and 22.

#include "pilotage/dead_reckoning.hpp"

#include "support/matchers.hpp"
#include "support/random.hpp"
#include "support/robots.hpp"
#include "support/scalars.hpp"
#include "support/textbook_ekf.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(DeadReckoningTest);

Params calibrated_params() {
    Params params;
    params.gyro_bias = {0.02, 0.01, 0};
    params.distance_scale = {1.1, 0.05, 0};
    params.rotation_scale = {0.9, 0.02, 0};
    return params;
}

template <typename Scalar>
Increment<Scalar> some_motion(const NoiseParams& noise) {
    auto u = from_wheels(Scalar(0.2), Scalar(0.3), Scalar(0.5), Scalar(0.5), noise);
    take_turn(u, Scalar(0.15), HeadingSource::both, noise);
    u.process_noise = pose_process_noise(u, noise);
    return u;
}

template <typename Scalar>
double tolerance() {
    return std::is_same_v<Scalar, double> ? 1e-12 : 1e-5;
}

TYPED_TEST(DeadReckoningTest, StartsAtThePoseWithTheConfiguredCalibration) {
    using Scalar = TypeParam;
    const Pose<Scalar> pose(1, 2, Scalar(0.5));
    const Matrix<Scalar, 3> p = Pose<Scalar>(Scalar(0.1), Scalar(0.2), Scalar(0.3)).asDiagonal();
    const auto six = start_filter<Scalar, 6>(pose, p, calibrated_params());
    Vector<double, 6> x, variances;
    x << 1, 2, 0.5, 0.02, 1.1, 0.9;
    variances << 0.1, 0.2, 0.3, 1e-4, 0.0025, 4e-4;
    EXPECT_TRUE(close(six.state(), x, 1e-7));
    EXPECT_TRUE(close(six.covariance(), Matrix<double, 6>(variances.asDiagonal()), 1e-7));
    const auto three = start_filter<Scalar, 3>(pose, p, calibrated_params());
    EXPECT_TRUE(close(three.state(), pose, 0));
    EXPECT_TRUE(close(three.covariance(), p, 0));
}

TYPED_TEST(DeadReckoningTest, DrivesTheCalibratedArc) {
    using Scalar = TypeParam;
    const Params params = calibrated_params();
    const auto u = some_motion<Scalar>(params.noise);
    const Pose<Scalar> start(1, 2, Scalar(0.5));
    const double distance = 1.1 * 0.25;
    const double turn = 0.9 * (double(u.turn_rad) - 0.02 * 0.5 * double(u.gyro_share));
    const Pose<double> end = after_arc(start.template cast<double>(), distance, turn);
    auto three = start_filter<Scalar, 3>(start, Matrix<Scalar, 3>::Zero(), params);
    auto six = start_filter<Scalar, 6>(start, Matrix<Scalar, 3>::Zero(), params);
    dead_reckon(three, u, params);
    dead_reckon(six, u, params);
    const double close_enough = tolerance<Scalar>();
    EXPECT_TRUE(same_pose(three.state(), Pose<Scalar>(end.template cast<Scalar>()), close_enough));
    EXPECT_TRUE(same_pose(Pose<Scalar>(six.state().template head<3>()),
                          Pose<Scalar>(end.template cast<Scalar>()), close_enough));
    const auto driven = calibrated_motion(six.state(), u, params);
    EXPECT_NEAR(driven[0], distance, close_enough);
    EXPECT_NEAR(driven[1], turn, close_enough);
}

TYPED_TEST(DeadReckoningTest, FrozenStatesAreTheThreeStateFilter) {
    using Scalar = TypeParam;
    Params params = calibrated_params();
    params.gyro_bias.sigma = params.distance_scale.sigma = params.rotation_scale.sigma = 0;
    const Pose<Scalar> start(1, 2, Scalar(0.5));
    const Matrix<Scalar, 3> p = Pose<Scalar>(Scalar(0.1), Scalar(0.2), Scalar(0.3)).asDiagonal();
    auto three = start_filter<Scalar, 3>(start, p, params);
    auto six = start_filter<Scalar, 6>(start, p, params);
    for (int i = 0; i < 50; ++i) {
        dead_reckon(three, some_motion<Scalar>(params.noise), params);
        dead_reckon(six, some_motion<Scalar>(params.noise), params);
    }
    EXPECT_TRUE(close(six.state().template head<3>(), three.state(), 50 * tolerance<Scalar>()));
    EXPECT_TRUE(close(six.covariance().template topLeftCorner<3, 3>(), three.covariance(),
                      50 * tolerance<Scalar>()));
    EXPECT_TRUE((six.covariance().template rightCols<3>().array() == 0).all());
}

/// A metre straight ahead in direction 0.7, from a certain pose: P = B Gamma
/// B'.
template <typename Scalar>
Matrix<double, 3> after_a_metre(HeadingSource source) {
    Params params;
    params.noise = {};
    params.noise.wheel_m_per_sqrt_m = 0.1;
    params.noise.gyro_rad_per_sqrt_s = 0.02;
    params.noise.position_m_per_sqrt_m = 0;
    auto u = from_wheels(Scalar(1), Scalar(1), Scalar(2), Scalar(0.5), params.noise);
    if (source != HeadingSource::wheels) take_turn(u, Scalar(0), source, params.noise);
    auto filter = start_filter<Scalar, 3>({0, 0, Scalar(0.7)}, Matrix<Scalar, 3>::Zero(), params);
    dead_reckon(filter, u, params);
    return filter.covariance().template cast<double>();
}

constexpr double kCos = 0.764842187284489, kSin = 0.644217687237691;  // of 0.7

TYPED_TEST(DeadReckoningTest, WheelsThatGiveTheHeadingHaveTheColumnsOfEq22) {
    constexpr double b = 0.5;
    Matrix<double, 3, 2> columns;  // by the right and the left wheel
    columns << kCos / 2 - kSin / (2 * b), kCos / 2 + kSin / (2 * b),  //
        kSin / 2 + kCos / (2 * b), kSin / 2 - kCos / (2 * b),         //
        1 / b, -1 / b;
    EXPECT_TRUE(close(after_a_metre<TypeParam>(HeadingSource::wheels),
                      columns * 0.01 * columns.transpose(), tolerance<TypeParam>()));
}

TYPED_TEST(DeadReckoningTest, WheelsBesideAGyroMoveThePoseAlongItsHeadingOnly) {
    Matrix<double, 3, 2> wheels;
    wheels << kCos / 2, kCos / 2, kSin / 2, kSin / 2, 0, 0;
    const Pose<double> gyro(-kSin / 2, kCos / 2, 1);  // by the turn
    EXPECT_TRUE(close(after_a_metre<TypeParam>(HeadingSource::gyro),
                      wheels * 0.01 * wheels.transpose() + gyro * 0.0008 * gyro.transpose(),
                      tolerance<TypeParam>()));
}

/// All that may move, and a tilt.
Params tilted_params() {
    Params params = calibrated_params();
    params.gyro_bias.walk = 0.001;
    params.distance_scale.walk = 0.002;
    params.rotation_scale.walk = 0.003;
    params.noise.heading_rad_per_sqrt_m = 0.01;
    params.tilt = {0.02, 0.03, 3};
    return params;
}

template <typename Scalar>
Increment<Scalar> random_motion(Draw& draw, const NoiseParams& noise) {
    const Scalar left = draw.uniform<Scalar>(-0.1, 0.3), right = draw.uniform<Scalar>(-0.1, 0.3);
    auto u = from_wheels(left, right, Scalar(0.5), Scalar(0.5), noise);
    take_turn(u, draw.uniform<Scalar>(-0.3, 0.3), HeadingSource::both, noise);
    u.process_noise = pose_process_noise(u, noise);
    return u;
}

TYPED_TEST(DeadReckoningTest, OfATiltedBodyIsThatOfALevelOne) {
    using Scalar = TypeParam;
    const Params params = tilted_params();
    Draw draw(7);
    const Matrix<Scalar, 3> p = draw.covariance<Scalar, 3>(0.01);
    auto six = start_filter<Scalar, 6>({1, 2, 3}, p, params);
    auto eight = start_filter<Scalar, 8>({1, 2, 3}, p, params);
    for (int i = 0; i < 50; ++i) {
        const auto u = random_motion<Scalar>(draw, params.noise);
        dead_reckon(six, u, params);
        dead_reckon(eight, u, params);
    }
    EXPECT_TRUE(close(eight.state().template head<6>(), six.state(), kTight<Scalar>));
    EXPECT_TRUE(
        close(eight.covariance().template topLeftCorner<6, 6>(), six.covariance(), kTight<Scalar>));
    EXPECT_NEAR(eight.covariance()(kPitch, kPitch), 4e-4, 1e-9);
    EXPECT_NEAR(eight.covariance()(kRoll, kRoll), 9e-4, 1e-9);
    EXPECT_EQ((eight.covariance().template bottomLeftCorner<2, 6>()),
              (Matrix<Scalar, 2, 6>::Zero()));
}

/// Once a sighting has tied the tilt to the pose.
TYPED_TEST(DeadReckoningTest, MovesWhatTiesATiltToThePoseAsATextbookDoes) {
    using Scalar = TypeParam;
    const Params params = tilted_params();
    Draw draw(8);
    for (int i = 0; i < 20; ++i) {
        Ekf<Scalar, 8> filter{draw.normal<Scalar, 8>(), draw.covariance<Scalar, 8>()};
        const auto u = random_motion<Scalar>(draw, params.noise);
        const Calibrated<RobotMotion<Scalar>, Scalar> model{{Scalar(params.motion.slip_angle_rad)},
                                                            u.dt_s * u.gyro_share};
        const auto step = model.linearize(filter.state().template head<6>(),
                                          Vector<Scalar, 2>(u.distance_m, u.turn_rad));
        auto textbook = TextbookEkf::of(filter);
        Eigen::MatrixXd a = Eigen::MatrixXd::Identity(8, 8);
        a.topLeftCorner(6, 6) = wide(step.a.dense());
        Eigen::VectorXd next = textbook.x, q = Eigen::VectorXd::Zero(8);
        next.head(6) = wide(step.next);
        q.head(3) = wide(u.process_noise);
        q.segment(3, 3) = wide(calibration_process_noise(u, params));
        textbook.predict(next, a, wide(step.b), wide(u.covariance), q);
        dead_reckon(filter, u, params);
        EXPECT_TRUE(close(filter.state(), textbook.x, kTight<Scalar>));
        EXPECT_TRUE(close(filter.covariance(), textbook.p, kTight<Scalar>));
    }
}

}  // namespace
}  // namespace pilotage::test
