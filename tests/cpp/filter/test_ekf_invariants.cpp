// What stays true however long the filter runs and whatever it sees.

#include <Eigen/LU>

#include "support/filters.hpp"
#include "support/matchers.hpp"
#include "support/scalars.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(EkfInvariantsTest);

template <typename Scalar, int N>
void expect_ekf_covariance_through(int steps) {
    Draw draw(N);
    auto filter = random_filter<Scalar, N>(draw);
    const auto policy = Policy::make(Fusion::student_t, 0.001, 4);
    constexpr double rounding = 10 * std::numeric_limits<Scalar>::epsilon();
    int refused = 0;
    for (int i = 0; i < steps; ++i) {
        const int rows = static_cast<int>(draw.uniform(0, 5));
        if (rows == 1)
            refused += !update_randomly<BearingOnly<Scalar>>(draw, filter, policy);
        else if (rows == 2)
            refused += !update_randomly<BearingElevation<Scalar>>(draw, filter, policy);
        else if (rows == 3)
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

TYPED_TEST(EkfInvariantsTest, CovarianceStaysSymmetricAndSemidefinite) {
    expect_ekf_covariance_through<TypeParam, 3>(100000);
    expect_ekf_covariance_through<TypeParam, 6>(100000);
}

/// Every subset of the calibration states, frozen by zero variance.
TYPED_TEST(EkfInvariantsTest, FrozenStatesStayExactlyFrozen) {
    for (int frozen = 0; frozen < 8; ++frozen) {
        Draw draw(static_cast<unsigned>(frozen));
        auto filter = random_filter<TypeParam, 6>(draw);
        Matrix<TypeParam, 6> p = filter.covariance();
        for (int i = 0; i < 3; ++i)
            if (frozen & (1 << i)) p.row(3 + i) = p.col(3 + i) = Vector<TypeParam, 6>::Zero();
        filter = {filter.state(), p};
        const auto start = filter.state();
        for (int step = 0; step < 1000; ++step) {
            predict_randomly(draw, filter);
            update_randomly<BearingElevationRange<TypeParam>>(draw, filter, Policy{});
        }
        for (int i = 0; i < 3; ++i) {
            if (frozen & (1 << i)) {
                EXPECT_EQ(filter.state()[3 + i], start[3 + i]);
                EXPECT_TRUE((filter.covariance().row(3 + i).array() == 0).all());
            } else {
                EXPECT_NE(filter.state()[3 + i], start[3 + i]);
                EXPECT_GT(filter.covariance()(3 + i, 3 + i), 0);
            }
        }
    }
}

TYPED_TEST(EkfInvariantsTest, CovarianceGrowsWhileNothingIsSeen) {
    Draw draw(4);
    auto filter = random_filter<TypeParam, 3>(draw, 1e-3);
    TypeParam volume = filter.covariance().determinant();
    for (int i = 0; i < 100; ++i) {
        predict_randomly(draw, filter);
        const TypeParam now = filter.covariance().determinant();
        if (i % 20 == 0) {
            EXPECT_GT(now, volume);
            volume = now;
        }
    }
}

}  // namespace
}  // namespace pilotage::test
