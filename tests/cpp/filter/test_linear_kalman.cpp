// LinearKalman against the equations as a textbook prints them.

#include "pilotage/filter/linear_kalman.hpp"

#include <Eigen/LU>

#include "support/matchers.hpp"
#include "support/random.hpp"
#include "support/scalars.hpp"
#include "support/textbook_ekf.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(LinearKalmanTest);

/// Eqs. 7 to 11 of Tamas et al. 2008 as they stand.
struct Textbook {
    Eigen::VectorXd x;
    Eigen::MatrixXd p;

    void predict(const Eigen::MatrixXd& a, const Eigen::VectorXd& bu, const Eigen::MatrixXd& q) {
        x = a * x + bu;
        p = a * p * a.transpose() + q;
    }
    void update(const Eigen::VectorXd& z, const Eigen::MatrixXd& h, const Eigen::MatrixXd& r) {
        const Eigen::MatrixXd k = p * h.transpose() * (h * p * h.transpose() + r).inverse();
        x += k * (z - h * x);
        p = (Eigen::MatrixXd::Identity(x.size(), x.size()) - k * h) * p;
    }
};

template <typename Scalar, int N, int M>
void expect_textbook() {
    Draw draw(10 * N + M);
    LinearKalman<Scalar, N> filter(draw.normal<Scalar, N>(), draw.covariance<Scalar, N>());
    for (int i = 0; i < 200; ++i) {
        Textbook textbook{wide(filter.state()), wide(filter.covariance())};
        const Matrix<Scalar, N> a = draw.normal<Scalar, N, N>() / 2;
        const Vector<Scalar, N> bu = draw.normal<Scalar, N, 2>() * draw.normal<Scalar, 2>();
        const auto q = draw.covariance<Scalar, N>(0.1);
        textbook.predict(wide(a), wide(bu), wide(q));
        filter.predict(a, bu, q);
        EXPECT_TRUE(close(filter.state(), textbook.x, kTight<Scalar>));
        EXPECT_TRUE(close(filter.covariance(), textbook.p, kTight<Scalar>));

        textbook = {wide(filter.state()), wide(filter.covariance())};
        const Matrix<Scalar, M, N> h = draw.normal<Scalar, M, N>();
        const auto r = draw.covariance<Scalar, M>();
        const Vector<Scalar, M> z = draw.normal<Scalar, M>();
        textbook.update(wide(z), wide(h), wide(r));
        ASSERT_TRUE(filter.update(z, h, r, Policy{}).accepted());
        EXPECT_TRUE(close(filter.state(), textbook.x, kTight<Scalar>));
        EXPECT_TRUE(close(filter.covariance(), textbook.p, kTight<Scalar>));
    }
}

TYPED_TEST(LinearKalmanTest, StepsAreTheTextbooks) {
    expect_textbook<TypeParam, 1, 1>();
    expect_textbook<TypeParam, 2, 1>();
    expect_textbook<TypeParam, 3, 2>();
    expect_textbook<TypeParam, 4, 3>();
}

TYPED_TEST(LinearKalmanTest, NoStateIsTakenForAnAngle) {
    using S = TypeParam;
    LinearKalman<S, 3> filter(Vector<S, 3>(1, 2, 10), Matrix<S, 3>::Identity());
    filter.predict(Matrix<S, 3>::Identity(), Vector<S, 3>(0, 0, 90), Matrix<S, 3>::Zero());
    EXPECT_EQ(filter.state()[2], 100);
    const Matrix<S, 1, 3> h(0, 0, 1);
    filter.update(Vector<S, 1>(110), h, Matrix<S, 1>(S(1)), Policy{});
    EXPECT_NEAR(filter.state()[2], 105, 100 * kTight<S>);
}

/// A cart at constant velocity whose position is measured: the steady state of the
/// alpha-beta filter (Kalata 1984) for a tracking index of 1, alpha = 3/4 and beta = 1/2.
TYPED_TEST(LinearKalmanTest, GainOfACartSettlesAtKalatas) {
    using S = TypeParam;
    LinearKalman<S, 2> filter(Vector<S, 2>(0, 0), Matrix<S, 2>::Identity());
    Matrix<S, 2> a, q;
    a << 1, 1, 0, 1;
    q << S(0.25), S(0.5), S(0.5), 1;
    const Matrix<S, 1, 2> h(1, 0);
    Vector<S, 2> before, after;
    for (int i = 0; i < 100; ++i) {
        filter.predict(a, Vector<S, 2>(0, 0), q);
        before = filter.state();
        filter.update(Vector<S, 1>(before[0] + 1), h, Matrix<S, 1>(S(1)), Policy{});
        after = filter.state();
    }
    EXPECT_NEAR(after[0] - before[0], 0.75, 100 * kTight<S>);
    EXPECT_NEAR(after[1] - before[1], 0.5, 100 * kTight<S>);
}

TYPED_TEST(LinearKalmanTest, RefusedMeasurementLeavesEverything) {
    using S = TypeParam;
    LinearKalman<S, 2> filter(Vector<S, 2>(1, 2), Matrix<S, 2>::Identity());
    const auto before = filter;
    const Matrix<S, 1, 2> h(1, 0);
    const auto far = filter.update(Vector<S, 1>(100), h, Matrix<S, 1>(S(1)),
                                   Policy::make(Fusion::gate, 0.001, 4));
    EXPECT_EQ(far.fault, UpdateFault::gated);
    const auto bad = filter.update(Vector<S, 1>(1), h, Matrix<S, 1>(S(-1)), Policy{});
    EXPECT_EQ(bad.fault, UpdateFault::numeric);
    EXPECT_TRUE(same_bits(filter.state(), before.state()));
    EXPECT_TRUE(same_bits(filter.covariance(), before.covariance()));
}

}  // namespace
}  // namespace pilotage::test
