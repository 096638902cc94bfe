// How an unlikely innovation is treated: by the gate, by the Student-t weight.

#include <Eigen/Cholesky>

#include "support/filters.hpp"
#include "support/linear_measurement.hpp"
#include "support/matchers.hpp"
#include "support/scalars.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(EkfRobustTest);

/// The share of good measurements that the gate rejects: innovations drawn from N(0, S).
template <typename Scalar, int M>
double rejected_share(const Policy& policy, int draws) {
    Draw draw(100 + M);
    const auto filter = random_filter<Scalar, 3>(draw);
    const LinearMeasurement<Scalar, M, 3> model{draw.normal<Scalar, M, 3>()};
    const auto r = draw.covariance<Scalar, M>(0.1);
    const Matrix<Scalar, M> s = model.h * filter.covariance() * model.h.transpose() + r;
    const Matrix<Scalar, M> root =
        Eigen::MatrixXd(s.template cast<double>().llt().matrixL()).template cast<Scalar>();
    int rejected = 0;
    for (int i = 0; i < draws; ++i) {
        auto one = filter;
        const Vector<Scalar, M> z = model.h * filter.state() + root * draw.normal<Scalar, M>();
        rejected += one.update(model, z, r, policy).fault == UpdateFault::gated;
    }
    return double(rejected) / draws;
}

TYPED_TEST(EkfRobustTest, GateRejectsGoodMeasurementsAtTheStatedRate) {
    constexpr int kDraws = 20000;
    for (const double rate : {0.3, 0.01}) {
        const auto policy = Policy::make(Fusion::gate, rate, 4);
        const double five_sigma = 5 * std::sqrt(rate * (1 - rate) / kDraws);
        EXPECT_NEAR((rejected_share<TypeParam, 1>(policy, kDraws)), rate, five_sigma);
        EXPECT_NEAR((rejected_share<TypeParam, 2>(policy, kDraws)), rate, five_sigma);
        EXPECT_NEAR((rejected_share<TypeParam, 3>(policy, kDraws)), rate, five_sigma);
    }
}

template <typename Scalar>
struct Outlier {
    Draw draw{1};
    Ekf<Scalar, 6> filter = random_filter<Scalar, 6>(draw);
    BearingElevation<Scalar> sighting{marker_in_sight(draw, filter)};
    Matrix<Scalar, 2> r = draw.covariance<Scalar, 2>(1e-3);

    [[nodiscard]] Vector<Scalar, 2> measured(double error) const {
        return sighting.linearize(filter.state().template head<3>()).value +
               Vector<Scalar, 2>(Scalar(error), Scalar(-error));
    }
};

TYPED_TEST(EkfRobustTest, WeightBelowOneIsAnUpdateWithNoiseOverWeight) {
    const Outlier<TypeParam> outlier;
    const auto z = outlier.measured(1);
    auto weighted = outlier.filter, scaled = outlier.filter;
    const auto report =
        weighted.update(outlier.sighting, z, outlier.r, Policy::make(Fusion::student_t, 0.001, 4));
    ASSERT_TRUE(report.accepted());
    ASSERT_LT(report.weight, 1);
    EXPECT_NEAR(report.weight, (4 + 2) / (4 + report.nis), kTight<TypeParam>);
    const Matrix<TypeParam, 2> r = outlier.r / report.weight;
    ASSERT_TRUE(scaled.update(outlier.sighting, z, r, Policy{}).accepted());
    EXPECT_TRUE(close(weighted.state(), scaled.state(), kTight<TypeParam>));
    EXPECT_TRUE(close(weighted.covariance(), scaled.covariance(), kTight<TypeParam>));
}

TYPED_TEST(EkfRobustTest, LikelyInnovationIsFusedAsWithoutWeight) {
    const Outlier<TypeParam> outlier;
    auto weighted = outlier.filter, plain = outlier.filter;
    const auto z = outlier.measured(1e-3);
    const auto report =
        weighted.update(outlier.sighting, z, outlier.r, Policy::make(Fusion::student_t, 0.001, 4));
    plain.update(outlier.sighting, z, outlier.r, Policy{});
    EXPECT_EQ(report.weight, 1);
    EXPECT_TRUE(same_bits(weighted.state(), plain.state()));
    EXPECT_TRUE(same_bits(weighted.covariance(), plain.covariance()));
}

TYPED_TEST(EkfRobustTest, HeldBackBeyondTheGateIsOnlyReported) {
    const Outlier<TypeParam> outlier;
    const auto h = outlier.sighting.linearize(outlier.filter.state().template head<3>());
    for (const Fusion fusion : {Fusion::gate, Fusion::student_t}) {
        const auto policy = Policy::make(fusion, 0.001, 4);
        auto held = outlier.filter, fused = outlier.filter;
        const Vector<TypeParam, 2> far(1, -1), near(TypeParam(0.01), TypeParam(0.01));
        const auto report = held.correct(far, h.jacobian, outlier.r, policy, true);
        EXPECT_EQ(report.fault, UpdateFault::gated);
        EXPECT_EQ(report.weight, 0);
        EXPECT_GT(report.nis, policy.gate_nis[1]);
        EXPECT_TRUE(same_bits(held.state(), outlier.filter.state()));
        EXPECT_TRUE(same_bits(held.covariance(), outlier.filter.covariance()));
        EXPECT_TRUE(held.correct(near, h.jacobian, outlier.r, policy, true).accepted());
        EXPECT_TRUE(fused.correct(near, h.jacobian, outlier.r, policy).accepted());
        EXPECT_TRUE(same_bits(held.state(), fused.state())) << "within it there is no difference";
    }
}

// The report's NIS and S are those of the stated noise, so that consistency is judged by them.
TYPED_TEST(EkfRobustTest, ReportSpeaksOfTheStatedNoiseWhateverTheWeight) {
    const Outlier<TypeParam> outlier;
    auto weighted = outlier.filter, plain = outlier.filter;
    const auto z = outlier.measured(1);
    const auto with =
        weighted.update(outlier.sighting, z, outlier.r, Policy::make(Fusion::student_t, 0.001, 4));
    const auto without = plain.update(outlier.sighting, z, outlier.r, Policy{});
    EXPECT_EQ(with.nis, without.nis);
    EXPECT_EQ(with.s, without.s);
}

}  // namespace
}  // namespace pilotage::test
