// Ekf where the answer is known without another filter.

#include "pilotage/filter/ekf.hpp"

#include <limits>

#include "support/filters.hpp"
#include "support/linear_measurement.hpp"
#include "support/matchers.hpp"
#include "support/scalars.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(EkfTest);

// Erratum: eqs. 13 and 14 print the Jacobians at the state after the step. Here the robot drives
// north, turning from north-west to north-east: its uncertain heading makes x uncertain, y not.
TYPED_TEST(EkfTest, PredictionIsLinearisedAtTheStateBeforeTheStep) {
    using S = TypeParam;
    const Vector<S, 3> variances(0, 0, S(0.01));
    Ekf<S, 3> filter({0, 0, S(0.75) * kPi<S>}, variances.asDiagonal());
    filter.predict(Unicycle<S, Chord::midpoint>{}, Vector<S, 2>(1, -kPi<S> / 2),
                   Matrix<S, 2>(Matrix<S, 2>::Zero()), Vector<S, 3>(0, 0, 0));
    EXPECT_NEAR(filter.covariance()(kX, kHeading), -0.01, kTight<S>);
    EXPECT_NEAR(filter.covariance()(kY, kHeading), 0, kTight<S>);
}

TYPED_TEST(EkfTest, ReportHoldsInnovationAndItsCovariance) {
    Draw draw(1);
    auto filter = random_filter<TypeParam, 3>(draw);
    const BearingElevationRange<TypeParam> sighting{marker_in_sight(draw, filter)};
    const auto h = sighting.linearize(filter.state());
    const Vector<TypeParam, 3> innovation(TypeParam(0.1), TypeParam(-0.2), TypeParam(0.3));
    const auto r = draw.covariance<TypeParam, 3>(0.05);
    const Matrix<TypeParam, 3> s = h.jacobian * filter.covariance() * h.jacobian.transpose() + r;
    const Vector<TypeParam, 3> z = h.value + innovation;
    const auto report = filter.update(sighting, z, r, Policy{});
    EXPECT_EQ(report.fault, UpdateFault::none);
    EXPECT_TRUE(close(report.innovation, innovation, 50 * kTight<TypeParam>));
    EXPECT_TRUE(close(Matrix<TypeParam, 3>(report.s.template selfadjointView<Eigen::Lower>()), s,
                      kTight<TypeParam>));
}

TYPED_TEST(EkfTest, NoiselessMeasurementLeavesTheStateAndShrinksTheCovariance) {
    Draw draw(2);
    auto filter = random_filter<TypeParam, 6>(draw);
    const auto before = filter;
    const BearingElevationRange<TypeParam> sighting{marker_in_sight(draw, filter)};
    const auto z = sighting.linearize(filter.state().template head<3>()).value;
    const Matrix<TypeParam, 3> r = Matrix<TypeParam, 3>::Identity() * TypeParam(1e-2);
    EXPECT_EQ(filter.update(sighting, z, r, Policy{}).nis, 0);
    EXPECT_EQ(filter.state(), before.state());
    for (int i = 0; i < 6; ++i) EXPECT_LT(filter.covariance()(i, i), before.covariance()(i, i));
}

// What the Joseph form is for: 1 - K loses all its digits, the covariance does not.
TYPED_TEST(EkfTest, PreciseMeasurementLeavesItsOwnVariance) {
    using S = TypeParam;
    const S variance = std::numeric_limits<S>::epsilon() / 1000;
    Draw draw(4);
    for (int i = 0; i < 100; ++i) {
        auto filter = random_filter<S, 3>(draw);
        const LinearMeasurement<S, 1, 3> position{Matrix<S, 1, 3>(1, 0, 0)};
        const Vector<S, 1> z(filter.state()[kX]);
        ASSERT_TRUE(filter.update(position, z, Matrix<S, 1>(variance), Policy{}).accepted());
        EXPECT_NEAR(filter.covariance()(kX, kX) / variance, 1, 0.01);
    }
}

// Only the heading was uncertain when a drive without noise began: position and heading now err
// together, P has one eigenvalue above zero. Rounding leaves the others a little off; that is no
// reason to refuse.
TYPED_TEST(EkfTest, PerfectlyCorrelatedStatesCanBeMeasured) {
    using S = TypeParam;
    const Vector<S, 3> variances(0, 0, S(0.01));
    Ekf<S, 3> driven({1, 2, S(0.5)}, variances.asDiagonal());
    for (int i = 0; i < 100; ++i)
        driven.predict(motion<S, 3>(), Vector<S, 2>(S(0.1), S(0.01)),
                       Matrix<S, 2>(Matrix<S, 2>::Zero()), Vector<S, 3>(0, 0, 0));
    Draw draw(5);
    for (int i = 0; i < 200; ++i) {
        auto filter = driven;
        const BearingOnly<S> sighting{marker_in_sight(draw, filter)};
        const auto z = sighting.linearize(filter.state()).value;
        const Matrix<S, 1> r(draw.log_uniform<S>(1e-6, 1e-2));  // 0.06 to 6 degrees
        EXPECT_TRUE(filter.update(sighting, z, r, Policy{}).accepted()) << "R = " << r;
    }
}

TYPED_TEST(EkfTest, UpdateAcrossTheWrapTurnsTheShortWay) {
    using S = TypeParam;
    const S near_pi = kPi<S> - S(0.01);
    Ekf<S, 3> filter({0, 0, near_pi}, Vector<S, 3>(0, 0, 1).asDiagonal());
    const BearingOnly<S> sighting{{-5, 0, 0}};  // straight ahead for a robot that looks west
    const Vector<S, 1> truth = sighting.linearize({0, 0, -near_pi}).value;
    filter.update(sighting, truth, Matrix<S, 1>(S(1e-6)), Policy{});
    EXPECT_TRUE(same_pose<S>(filter.state(), {0, 0, -near_pi}, 1e-5));
}

TYPED_TEST(EkfTest, CertainStateStaysCertain) {
    using S = TypeParam;
    Ekf<S, 3> filter({1, 2, 3}, Matrix<S, 3>::Zero());
    const auto before = filter.state();
    const BearingElevationRange<S> sighting{{5, 6, -1}};
    const auto report =
        filter.update(sighting, {0, 0, 0}, Matrix<S, 3>(Matrix<S, 3>::Identity()), Policy{});
    EXPECT_TRUE(report.accepted());
    EXPECT_EQ(filter.state(), before);
    EXPECT_EQ(filter.covariance(), (Matrix<S, 3>::Zero()));
    filter.predict(motion<S, 3>(), Vector<S, 2>(1, 1), Matrix<S, 2>(Matrix<S, 2>::Zero()),
                   Vector<S, 3>(0, 0, 0));
    EXPECT_EQ(filter.covariance(), (Matrix<S, 3>::Zero()));
}

TYPED_TEST(EkfTest, LinearMeasurementsOneByOneAreThoseTogether) {
    using S = TypeParam;
    Draw draw(3);
    for (int i = 0; i < 200; ++i) {
        Ekf<S, 6> together(Vector<S, 6>::Zero(), draw.covariance<S, 6>(0.1)), one_by_one = together;
        const LinearMeasurement<S, 3, 6> model{draw.normal<S, 3, 6>()};
        const Vector<S, 3> z = model.h * together.state() + draw.normal<S, 3>() * S(0.1);
        const Vector<S, 3> variances(S(0.1), S(0.2), S(0.3));
        together.update(model, z, Matrix<S, 3>(variances.asDiagonal()), Policy{});
        for (int row = 0; row < 3; ++row)
            one_by_one.update(LinearMeasurement<S, 1, 6>{model.h.row(row)}, Vector<S, 1>(z[row]),
                              Matrix<S, 1>(variances[row]), Policy{});
        EXPECT_TRUE(close(one_by_one.state(), together.state(), kTight<S>));
        EXPECT_TRUE(close(one_by_one.covariance(), together.covariance(), kTight<S>));
    }
}

}  // namespace
}  // namespace pilotage::test
