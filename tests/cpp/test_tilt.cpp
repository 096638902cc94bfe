// What a tilt does to a sighting, and how the filter carries it from frame to frame.

#include "pilotage/tilt.hpp"

#include "pilotage/dead_reckoning.hpp"
#include "support/matchers.hpp"
#include "support/random.hpp"
#include "support/robots.hpp"
#include "support/scalars.hpp"
#include "support/textbook_ekf.hpp"
#include "support/tilted.hpp"

namespace pilotage::test {
namespace {

TEST(TiltTest, NoseUpLowersWhatIsAheadAndLeftSideUpWhatIsOnTheLeft) {
    EXPECT_NEAR(tilted({0, 0.1, 1}, 0.02, 0)[1], 0.08, 1e-12);
    EXPECT_NEAR(tilted({kPi<double> / 2, 0.1, 1}, 0, 0.02)[1], 0.08, 1e-12);
}

const Marker kCeilingMarker{1, 3, -2, 2.5, 0};

SensorParams sensor_on_a_mast() {
    SensorParams sensor;
    sensor.x_m = 0.3;
    sensor.y_m = 0.1;
    sensor.z_m = 0.8;
    sensor.yaw_rad = 0.7;
    return sensor;
}

/// With the tilt that the state has.
template <typename... Components>
TiltedSighting<double, int(sizeof...(Components))> held(const Vector<double, 8>& x,
                                                        const Point3& seen,
                                                        const Components&... components) {
    const Sighting sighting{{seen[0], seen[1], seen[2]}, {kNan, kNan, kNan}, 1, -1};
    const auto level = hold_against<double>(x.head<3>(), kCeilingMarker, sighting,
                                            sensor_on_a_mast(), components...);
    return with_tilt<double, Components...>(level, x);
}

/// A robot level_somewhere on level ground.
Vector<double, 8> level_somewhere(Draw& draw) {
    Vector<double, 8> x = Vector<double, 8>::Zero();
    x << draw.uniform(-4, 0), draw.uniform(1, 5), draw.uniform(-3, 3), 0, 1, 1, 0, 0;
    return x;
}

/// The sensor's own yaw does not matter to pitch and roll.
Point3 seen_from(const Vector<double, 8>& x, double pitch, double roll) {
    const SensorParams sensor = sensor_on_a_mast();
    Point3 level = view(x.head<3>(), kCeilingMarker, sensor);
    level[0] += sensor.yaw_rad;
    Point3 seen = tilted(level, pitch, roll);
    seen[0] = wrap(seen[0] - sensor.yaw_rad);
    return seen;
}

TEST(TiltTest, JacobianIsTheDerivativeOfTheTurnedLineOfSight) {
    Draw draw(1);
    constexpr double step = 1e-5;
    for (int i = 0; i < 50; ++i) {
        const Vector<double, 8> x = level_somewhere(draw);
        const auto j =
            held(x, seen_from(x, 0, 0), Bearing<double>{}, Elevation<double>{}, Range<double>{})
                .jacobian;
        const auto slope = [&](double pitch, double roll) -> Point3 {
            Point3 rise = seen_from(x, pitch, roll) - seen_from(x, -pitch, -roll);
            rise[0] = wrap(rise[0]);
            return rise / (2 * step);
        };
        EXPECT_TRUE(close(j.col(kPitch), slope(step, 0), 1e-8));
        EXPECT_TRUE(close(j.col(kRoll), slope(0, step), 1e-8));
        EXPECT_EQ(j(2, kPitch), 0) << "a turn changes no range";
        EXPECT_EQ((j.block<3, 3>(0, 3)), (Matrix<double, 3>::Zero())) << "nor does the calibration";
    }
}

TEST(TiltTest, TheTiltOfTheStateExplainsWhatItDoes) {
    Draw draw(2);
    for (int i = 0; i < 50; ++i) {
        Vector<double, 8> x = level_somewhere(draw);
        x[kPitch] = 0.002;
        x[kRoll] = -0.001;
        const auto innovation = held(x, seen_from(x, x[kPitch], x[kRoll]), Bearing<double>{},
                                     Elevation<double>{}, Range<double>{})
                                    .innovation;
        EXPECT_LT(innovation.norm(), 1e-5) << innovation.transpose();
        const auto alone = held(x, seen_from(x, x[kPitch], x[kRoll]), Elevation<double>{});
        EXPECT_LT(std::abs(alone.innovation[0]), 1e-5) << "whichever components there are";
    }
}

TiltParams tilt(double tau_s) {
    return {0.02, 0.03, tau_s};
}

PILOTAGE_SUITE(SettleTiltTest);

template <typename Scalar>
Ekf<Scalar, 8> random_tilted(Draw& draw) {
    Vector<Scalar, 8> x = draw.normal<Scalar, 8>();
    return {x, draw.covariance<Scalar, 8>()};
}

TYPED_TEST(SettleTiltTest, IsTheTextbookGaussMarkovProcess) {
    using Scalar = TypeParam;
    Draw draw(3);
    for (const double dt_s : {0.01, 0.3, 5.0}) {
        auto filter = random_tilted<Scalar>(draw);
        auto textbook = TextbookEkf::of(filter);
        settle_tilt(filter, Scalar(dt_s), tilt(3));
        const double keep = std::exp(-dt_s / 3), fresh = 1 - std::exp(-2 * dt_s / 3);
        Eigen::MatrixXd a = Eigen::MatrixXd::Identity(8, 8);
        a(kPitch, kPitch) = a(kRoll, kRoll) = keep;
        Eigen::VectorXd q = Eigen::VectorXd::Zero(8);
        q[kPitch] = 4e-4 * fresh;
        q[kRoll] = 9e-4 * fresh;
        textbook.predict(a * textbook.x, a, Eigen::MatrixXd::Zero(8, 1),
                         Eigen::MatrixXd::Zero(1, 1), q);
        EXPECT_TRUE(close(filter.state(), textbook.x, kTight<Scalar>));
        EXPECT_TRUE(close(filter.covariance(), textbook.p, kTight<Scalar>));
    }
}

TYPED_TEST(SettleTiltTest, KeepsTheVarianceItHasOnAverage) {
    using Scalar = TypeParam;
    for (const double tau_s : {0.0, 3.0}) {
        Params params;
        params.tilt = tilt(tau_s);
        auto filter = start_filter<Scalar, 8>({0, 0, 0}, Matrix<Scalar, 3>::Identity(), params);
        for (int i = 0; i < 1000; ++i) settle_tilt(filter, Scalar(0.1), params.tilt);
        EXPECT_NEAR(filter.covariance()(kPitch, kPitch), 4e-4, 1e-7);
        EXPECT_NEAR(filter.covariance()(kRoll, kRoll), 9e-4, 1e-7);
    }
}

TYPED_TEST(SettleTiltTest, ForgetsAllWithoutACorrelationTime) {
    using Scalar = TypeParam;
    Draw draw(4);
    auto filter = random_tilted<Scalar>(draw);
    const auto before = filter;
    settle_tilt(filter, Scalar(1e-3), tilt(0));
    Matrix<double, 8> expected = before.covariance().template cast<double>();
    expected.bottomRows<2>().setZero();
    expected.rightCols<2>().setZero();
    expected(kPitch, kPitch) = 4e-4;
    expected(kRoll, kRoll) = 9e-4;
    EXPECT_TRUE(close(filter.covariance(), expected, kTight<Scalar>));
    EXPECT_EQ((filter.state().template head<6>()), (before.state().template head<6>()));
    EXPECT_EQ((filter.state().template tail<2>()), (Vector<Scalar, 2>::Zero()));
}

TYPED_TEST(SettleTiltTest, IsOneAndTheSameWithinAFrame) {
    using Scalar = TypeParam;
    Draw draw(5);
    for (const double tau_s : {0.0, 3.0})
        for (const double dt_s : {0.0, -1.0}) {
            auto filter = random_tilted<Scalar>(draw);
            const auto before = filter;
            settle_tilt(filter, Scalar(dt_s), tilt(tau_s));
            EXPECT_TRUE(same_bits(filter.state(), before.state()));
            EXPECT_TRUE(same_bits(filter.covariance(), before.covariance()));
        }
}

}  // namespace
}  // namespace pilotage::test
