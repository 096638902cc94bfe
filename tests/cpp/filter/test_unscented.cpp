// The unscented transformation: exact where it must be, and against moments known in closed form.

#include "pilotage/filter/unscented.hpp"

#include <Eigen/Cholesky>
#include <limits>
#include <vector>

#include "support/matchers.hpp"
#include "support/random.hpp"
#include "support/scalars.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(UnscentedTest);

const std::vector<Unscented> kSets = {{},          {1, 0, 1},    {1, 2, 0},
                                      {0.5, 2, 0}, {1e-2, 2, 0}, {1, 1, 3}};

/// Eqs. 14 to 17 as they stand, the weights of alpha and beta included; in double.
template <int N, int M, typename F>
Transformed<double, M, N> by_weights(const Vector<double, N>& x, const Matrix<double, N>& p,
                                     const F& f, const Unscented& set) {
    const double lambda = set.alpha * set.alpha * (N + set.kappa) - N;
    const Matrix<double, N> root = p.llt().matrixL();
    std::vector<Vector<double, N>> points = {x};
    for (int i = 0; i < N; ++i)
        for (const int sign : {1, -1})
            points.push_back(x + sign * std::sqrt(N + lambda) * root.col(i));
    std::vector<double> mean_weights(points.size(), 1 / (2 * (N + lambda)));
    mean_weights[0] = lambda / (N + lambda);
    auto covariance_weights = mean_weights;
    covariance_weights[0] += 1 - set.alpha * set.alpha + set.beta;
    Vector<double, M> mean = Vector<double, M>::Zero();
    Transformed<double, M, N> result{mean, Matrix<double, M>::Zero(), Matrix<double, N, M>::Zero()};
    for (std::size_t i = 0; i < points.size(); ++i) result.mean += mean_weights[i] * f(points[i]);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vector<double, M> off = f(points[i]) - result.mean;
        result.covariance += covariance_weights[i] * off * off.transpose();
        result.cross += covariance_weights[i] * (points[i] - x) * off.transpose();
    }
    return result;
}

template <typename Scalar>
Vector<Scalar, 2> to_cartesian(const Vector<Scalar, 2>& polar) {
    return {polar[0] * std::cos(polar[1]), polar[0] * std::sin(polar[1])};
}

TEST(UnscentedWeightsTest, SlopeAndBendAreTheWeightedSums) {
    Draw draw(1);
    for (const Unscented& set : kSets)
        for (int i = 0; i < 100; ++i) {
            const Vector<double, 2> x = draw.normal<double, 2>();
            const auto p = draw.covariance<double, 2>(0.1);
            const auto ours = unscented_transform(x, p, to_cartesian<double>, set);
            const auto theirs = by_weights<2, 2>(x, p, to_cartesian<double>, set);
            // The textbook's weights of 1e4 with either sign cost it four digits.
            const double tolerance = set.alpha < 0.1 ? 1e-8 : 1e-12;
            EXPECT_TRUE(close(ours.mean, theirs.mean, tolerance));
            EXPECT_TRUE(close(ours.covariance, theirs.covariance, tolerance));
            EXPECT_TRUE(close(ours.cross, theirs.cross, tolerance));
        }
}

TYPED_TEST(UnscentedTest, LinearFunctionIsExactWhateverTheSet) {
    using S = TypeParam;
    Draw draw(2);
    for (const Unscented& set : kSets) {
        if (set.alpha < 0.1) continue;  // its differences are of 1 % of a sigma
        for (int i = 0; i < 100; ++i) {
            const Matrix<S, 2, 4> a = draw.normal<S, 2, 4>();
            const Vector<S, 4> x = draw.normal<S, 4>();
            const auto p = draw.covariance<S, 4>(1);
            const auto y = unscented_transform(
                x, p, [&](const Vector<S, 4>& at) { return Vector<S, 2>(a * at); }, set);
            EXPECT_TRUE(close(y.mean, a * x, 10 * kTight<S>));
            EXPECT_TRUE(close(y.covariance, a * p * a.transpose(), 10 * kTight<S>));
            EXPECT_TRUE(close(y.cross, p * a.transpose(), 10 * kTight<S>));
        }
    }
}

TYPED_TEST(UnscentedTest, MeanOfAQuadraticIsExactWhateverTheSet) {
    using S = TypeParam;
    Draw draw(3);
    for (const Unscented& set : kSets) {
        if (set.alpha < 0.1) continue;
        const auto q = draw.covariance<S, 3>();
        const Vector<S, 3> x = draw.normal<S, 3>();
        const auto p = draw.covariance<S, 3>();
        const auto y = unscented_transform(
            x, p, [&](const Vector<S, 3>& at) { return Vector<S, 1>(at.dot(q * at)); }, set);
        EXPECT_NEAR(y.mean[0] / (x.dot(q * x) + (q * p).trace()), 1, 10 * kTight<S>);
    }
}

/// With n + kappa = 3 the points have the fourth moments of a Gaussian.
TYPED_TEST(UnscentedTest, VarianceOfASquareIsExactWhereFourthMomentsAre) {
    using S = TypeParam;
    const auto square = [](const Vector<S, 1>& x) { return Vector<S, 1>(x[0] * x[0]); };
    const auto y = unscented_transform(Vector<S, 1>(S(0.5)), Matrix<S, 1>(S(4)), square, {1, 0, 2});
    EXPECT_NEAR(y.mean[0], 0.25 + 4, 10 * kTight<S>);
    EXPECT_NEAR(y.covariance(0, 0), 2 * 16 + 4 * 0.25 * 4, 100 * kTight<S>);
}

/// Tamas et al. 2008, figure 2, whose true mean is (0, 0.966), not (0, 1) (erratum).
TYPED_TEST(UnscentedTest, PolarToCartesianIsThePapersWithinItsBars) {
    using S = TypeParam;
    const double angle = 15 * kPi<double> / 180, variance = angle * angle, range = 0.02 * 0.02;
    // E cos(a) = exp(-v/2), E cos(2a) = exp(-2v) for a ~ N(0, v), and r independent of it.
    const double mean_y = std::exp(-variance / 2), square = 1 + range;
    const double true_xx = square * (1 - std::exp(-2 * variance)) / 2;
    const double true_yy = square * (1 + std::exp(-2 * variance)) / 2 - mean_y * mean_y;
    const Vector<S, 2> polar(1, kPi<S> / 2);
    const Matrix<S, 2> p = Vector<S, 2>(S(range), S(variance)).asDiagonal();
    const auto y = unscented_transform(polar, p, to_cartesian<S>, {1, 0, 1});
    EXPECT_NEAR(y.mean[0], 0, kTight<S>);
    EXPECT_NEAR(y.mean[1] / mean_y, 1, 1e-3);
    EXPECT_NEAR(y.covariance(0, 0) / true_xx, 1 - 0.002, 0.001);
    EXPECT_NEAR(y.covariance(1, 1) / true_yy, 1.04, 0.006);
    EXPECT_NEAR(y.covariance(0, 1), 0, kTight<S>);
    // What a linearisation says of the range's direction is 84 % too small.
    EXPECT_LT(range, 0.2 * true_yy);
}

TYPED_TEST(UnscentedTest, PlainSetIsOfTwoPointsADimensionWithEqualWeights) {
    using S = TypeParam;
    Draw draw(4);
    const Vector<S, 3> x = draw.normal<S, 3>();
    const auto p = draw.covariance<S, 3>();
    std::vector<Vector<S, 3>> points;
    const auto y = unscented_transform(x, p, [&](const Vector<S, 3>& at) {
        points.push_back(at);
        return Vector<S, 1>(at.squaredNorm());
    });
    ASSERT_EQ(points.size(), 7u);
    EXPECT_EQ(points[0], x) << "looked at for the differences";
    S mean = 0, square = 0;
    for (std::size_t i = 1; i < 7; ++i) mean += points[i].squaredNorm() / 6;
    for (std::size_t i = 1; i < 7; ++i)
        square += (points[i].squaredNorm() - mean) * (points[i].squaredNorm() - mean) / 6;
    EXPECT_NEAR(y.mean[0] / mean, 1, 10 * kTight<S>);
    EXPECT_NEAR(y.covariance(0, 0) / square, 1, 50 * kTight<S>);
}

TYPED_TEST(UnscentedTest, AnglesAreAveragedTheShortWay) {
    using S = TypeParam;
    const auto turn = [](const Vector<S, 1>& x) { return Vector<S, 1>(wrap(kPi<S> + x[0])); };
    const auto minus = [](const Vector<S, 1>& a, const Vector<S, 1>& b) {
        return Vector<S, 1>(wrap(a[0] - b[0]));
    };
    const auto y =
        unscented_transform(Vector<S, 1>(S(0)), Matrix<S, 1>(S(0.04)), turn, minus, {1, 0, 2});
    EXPECT_NEAR(std::abs(y.mean[0]), kPi<S>, 10 * kTight<S>);
    EXPECT_NEAR(y.covariance(0, 0), 0.04, 10 * kTight<S>);
}

TYPED_TEST(UnscentedTest, WhatHasNoVarianceIsAsIfItWereNotThere) {
    using S = TypeParam;
    Draw draw(5);
    for (const Unscented& set : kSets) {
        const Vector<S, 2> x = draw.normal<S, 2>();
        const auto p = draw.covariance<S, 2>(0.1);
        const Vector<S, 4> more(S(7), x[0], S(-3), x[1]);
        Matrix<S, 4> more_p = Matrix<S, 4>::Zero();
        for (int i = 0; i < 2; ++i)
            for (int j = 0; j < 2; ++j) more_p(2 * i + 1, 2 * j + 1) = p(i, j);
        const auto alone = unscented_transform(x, p, to_cartesian<S>, set);
        const auto among = unscented_transform(
            more, more_p, [](const Vector<S, 4>& at) { return to_cartesian<S>({at[1], at[3]}); },
            set);
        EXPECT_TRUE(same_bits(among.mean, alone.mean));
        EXPECT_TRUE(same_bits(among.covariance, alone.covariance));
    }
    const auto certain = unscented_transform(Vector<S, 2>(1, 0), Matrix<S, 2>(Matrix<S, 2>::Zero()),
                                             to_cartesian<S>);
    EXPECT_EQ(certain.mean, (Vector<S, 2>(1, 0)));
    EXPECT_EQ(certain.covariance, (Matrix<S, 2>::Zero()));
}

TYPED_TEST(UnscentedTest, CovarianceIsSemidefiniteWhateverTheFunction) {
    using S = TypeParam;
    Draw draw(6);
    for (int i = 0; i < 2000; ++i) {
        const Unscented set{draw.uniform(0.3, 2), draw.uniform(0, 3), draw.uniform(0, 3)};
        const Matrix<S, 3> a = draw.normal<S, 3, 3>();
        const auto y = unscented_transform(
            Vector<S, 3>(draw.normal<S, 3>()), draw.covariance<S, 3>(10),
            [&](const Vector<S, 3>& x) { return Vector<S, 3>((a * x).array().square().sin()); },
            set);
        EXPECT_GE(smallest_eigenvalue_ratio(y.covariance.template cast<double>()),
                  -10 * std::numeric_limits<S>::epsilon());
    }
}

TYPED_TEST(UnscentedTest, WhatIsNotFiniteDoesNotPassForCertain) {
    using S = TypeParam;
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        Matrix<S, 2> p = Matrix<S, 2>::Identity();
        p(1, 1) = S(bad);
        const auto y = unscented_transform(Vector<S, 2>(1, 0), p, to_cartesian<S>);
        EXPECT_TRUE(y.covariance.hasNaN());
    }
}

}  // namespace
}  // namespace pilotage::test
