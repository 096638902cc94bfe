// What stays true of Ukf however long it runs, and what it refuses.

#include <limits>

#include "pilotage/filter/ukf.hpp"
#include "support/filters.hpp"
#include "support/linear_measurement.hpp"
#include "support/matchers.hpp"
#include "support/scalars.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(UkfInvariantsTest);

template <typename Scalar, int N>
Ukf<Scalar, N> start(Draw& draw, int frozen = 0) {
    const auto filter = random_filter<Scalar, N>(draw);
    Matrix<Scalar, N> p = filter.covariance();
    for (int i = 0; i < 3; ++i)
        if (frozen & (1 << i)) {
            p.row(3 + i).setZero();
            p.col(3 + i).setZero();
        }
    return {filter.state(), p};
}

template <typename Scalar, int N>
void expect_ukf_covariance_through(int steps) {
    Draw draw(N);
    auto filter = start<Scalar, N>(draw);
    const auto policy = Policy::make(Fusion::student_t, 0.001, 4);
    constexpr double rounding = 10 * std::numeric_limits<Scalar>::epsilon();
    int refused = 0;
    for (int i = 0; i < steps; ++i) {
        if (draw.uniform(0, 1) < 0.5)
            refused += !update_randomly<BearingElevationRange<Scalar>>(draw, filter, policy);
        else
            predict_randomly(draw, filter);
        const auto& p = filter.covariance();
        ASSERT_TRUE(filter.state().allFinite() && p.allFinite()) << "step " << i;
        ASSERT_EQ(p, (Matrix<Scalar, N>(p.transpose()))) << "step " << i;
        ASSERT_GE(smallest_eigenvalue_ratio(p.template cast<double>()), -rounding) << "step " << i;
    }
    EXPECT_EQ(refused, 0);
}

TYPED_TEST(UkfInvariantsTest, CovarianceStaysSymmetricAndSemidefinite) {
    expect_ukf_covariance_through<TypeParam, 3>(20000);
    expect_ukf_covariance_through<TypeParam, 6>(20000);
}

/// Every subset of the calibration states, frozen by zero variance.
TYPED_TEST(UkfInvariantsTest, FrozenStatesStayExactlyFrozen) {
    for (int frozen = 0; frozen < 8; ++frozen) {
        Draw draw(static_cast<unsigned>(frozen));
        auto filter = start<TypeParam, 6>(draw, frozen);
        const auto before = filter.state();
        for (int step = 0; step < 500; ++step) {
            predict_randomly(draw, filter);
            update_randomly<BearingElevationRange<TypeParam>>(draw, filter, Policy{});
        }
        for (int i = 3; i < 6; ++i) {
            if (frozen & (1 << (i - 3))) {
                EXPECT_EQ(filter.state()[i], before[i]);
                EXPECT_TRUE((filter.covariance().row(i).array() == 0).all());
            } else {
                EXPECT_NE(filter.state()[i], before[i]);
                EXPECT_GT(filter.covariance()(i, i), 0);
            }
        }
    }
}

// All three calibration states frozen at their nominal values: the six states are three.
TYPED_TEST(UkfInvariantsTest, FilterWithFrozenCalibrationIsTheOneWithout) {
    using S = TypeParam;
    Draw draw(11);
    auto six = start<S, 6>(draw, 7);
    Vector<S, 6> x = six.state();
    x.template tail<3>() << 0, 1, 1;
    six = {x, six.covariance()};
    Ukf<S, 3> three(x.template head<3>(),
                    Matrix<S, 3>(six.covariance().template topLeftCorner<3, 3>()));
    Draw same_draw = draw;
    for (int i = 0; i < 200; ++i) {
        predict_randomly(draw, six);
        predict_randomly(same_draw, three);
        update_randomly<BearingElevationRange<S>>(draw, six, Policy{});
        update_randomly<BearingElevationRange<S>>(same_draw, three, Policy{});
    }
    EXPECT_TRUE(close(six.state().template head<3>(), three.state(), 1e3 * kTight<S>));
}

template <typename Scalar>
struct UkfScene {
    Draw draw{7};
    Ukf<Scalar, 6> filter = start<Scalar, 6>(draw);
    BearingElevationRange<Scalar> sighting{
        {filter.state()[kX] + 5, filter.state()[kY] - 7, Scalar(-1)}};
    Vector<Scalar, 3> z = sighting.linearize(filter.state().template head<3>()).value +
                          Vector<Scalar, 3>::Constant(Scalar(0.01));
    Matrix<Scalar, 3> r = Matrix<Scalar, 3>::Identity() * Scalar(0.01);

    void expect_refused_as(UpdateFault reason, Fusion fusion = Fusion::plain) const {
        auto after = filter;
        const auto report = after.update(sighting, z, r, Policy::make(fusion, 0.001, 4));
        EXPECT_EQ(report.fault, reason);
        EXPECT_EQ(report.weight, 0);
        EXPECT_TRUE(same_bits(after.state(), filter.state()));
        EXPECT_TRUE(same_bits(after.covariance(), filter.covariance()));
    }
};

TYPED_TEST(UkfInvariantsTest, RefusalsNameTheirReasonAndChangeNothing) {
    const UkfScene<TypeParam> good;
    EXPECT_TRUE(Ukf(good.filter).update(good.sighting, good.z, good.r, Policy{}).accepted());
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        for (int i = 0; i < 3; ++i) {
            auto scene = good;
            scene.z[i] = TypeParam(bad);
            scene.expect_refused_as(UpdateFault::numeric);
            scene = good;
            scene.r(i, i) = TypeParam(bad);
            scene.expect_refused_as(UpdateFault::numeric);
            auto p = good.filter.covariance();
            p(i, i) = TypeParam(bad);
            scene = good;
            scene.filter = {good.filter.state(), p};
            scene.expect_refused_as(UpdateFault::numeric);
        }
    for (const double variance : {0.0, -1e-9, -1e6}) {
        auto scene = good;
        scene.r(1, 1) = TypeParam(variance);
        scene.expect_refused_as(UpdateFault::numeric);
    }
    auto scene = good;
    scene.sighting.marker_above_sensor.template head<2>() = good.filter.state().template head<2>();
    scene.expect_refused_as(UpdateFault::undefined);
    scene = good;
    scene.z[2] += 1000;
    scene.expect_refused_as(UpdateFault::gated, Fusion::gate);
}

TYPED_TEST(UkfInvariantsTest, ModelThatIsUndefinedAtOnePointIsUndefined) {
    auto scene = UkfScene<TypeParam>();
    // A root's last column is the heading's alone, so make one of x: its point is the marker.
    const Vector<TypeParam, 3> variances(TypeParam(0.25), 0, 0);
    Ukf<TypeParam, 3> filter({0, 0, 0}, variances.asDiagonal());
    scene.sighting.marker_above_sensor << TypeParam(0.5), 0, -1;
    const auto report = filter.update(scene.sighting, scene.z, scene.r, Policy{});
    EXPECT_EQ(report.fault, UpdateFault::undefined);
}

TYPED_TEST(UkfInvariantsTest, OutlierIsWeighedAsTheEkfWeighsIt) {
    using S = TypeParam;
    const auto policy = Policy::make(Fusion::student_t, 0.001, 4);
    UkfScene<S> scene;
    auto plain = scene.filter, weighted = scene.filter;
    scene.z[0] += 2;
    const auto without = plain.update(scene.sighting, scene.z, scene.r, Policy{});
    const auto with = weighted.update(scene.sighting, scene.z, scene.r, policy);
    ASSERT_TRUE(with.accepted());
    EXPECT_EQ(with.nis, without.nis);
    EXPECT_NEAR(with.weight, (4 + 3) / (4 + with.nis), kTight<S>);
    EXPECT_LT(with.weight, 1);
    EXPECT_GT(weighted.covariance().trace(), plain.covariance().trace());
}

}  // namespace
}  // namespace pilotage::test
