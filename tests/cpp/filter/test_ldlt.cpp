#include "pilotage/filter/ldlt.hpp"

#include <Eigen/LU>

#include "support/matchers.hpp"
#include "support/random.hpp"
#include "support/scalars.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(LdltTest);

template <typename Scalar, int M>
void expect_solves(Draw& draw) {
    const auto a = draw.covariance<Scalar, M>();
    const auto b = draw.normal<Scalar, M>();
    const Ldlt<Scalar, M> factor(a);
    EXPECT_TRUE(factor.positive());
    EXPECT_TRUE(factor.semidefinite());
    const Vector<double, M> oracle =
        a.template cast<double>().inverse() * b.template cast<double>();
    EXPECT_TRUE(close(factor.solve(b), oracle, 10 * kTight<Scalar>));
}

TYPED_TEST(LdltTest, SolvesAsTheInverseDoes) {
    Draw draw(1);
    for (int i = 0; i < 100; ++i) {
        expect_solves<TypeParam, 1>(draw);
        expect_solves<TypeParam, 2>(draw);
        expect_solves<TypeParam, 3>(draw);
        expect_solves<TypeParam, 6>(draw);
    }
}

TYPED_TEST(LdltTest, UpperTriangleIsNotRead) {
    Draw draw(2);
    const auto a = draw.covariance<TypeParam, 3>();
    Matrix<TypeParam, 3> lower = a;
    lower.template triangularView<Eigen::StrictlyUpper>().setConstant(NAN);
    const Vector<TypeParam, 3> b(1, 2, 3);
    EXPECT_EQ((Ldlt<TypeParam, 3>(lower).solve(b)), (Ldlt<TypeParam, 3>(a).solve(b)));
}

TYPED_TEST(LdltTest, IndefiniteMatrixIsNeitherPositiveNorSemidefinite) {
    Matrix<TypeParam, 2> a;
    a << 1, 2, 2, 1;  // eigenvalues 3 and -1
    const Ldlt<TypeParam, 2> factor(a);
    EXPECT_FALSE(factor.positive());
    EXPECT_FALSE(factor.semidefinite());
    const Ldlt<TypeParam, 2> negative(-Matrix<TypeParam, 2>::Identity());
    EXPECT_FALSE(negative.semidefinite());
}

TYPED_TEST(LdltTest, CovarianceWithoutVarianceIsIndefinite) {
    Matrix<TypeParam, 3> a;
    a << 0, -3, 0, -3, 0, 4, 0, 4, 5;
    EXPECT_FALSE((Ldlt<TypeParam, 3>(a, TypeParam(1e-4)).semidefinite()));
    EXPECT_FALSE((Ldlt<TypeParam, 3>(a).semidefinite()));
    // Only after the first column it shows that nothing is left of the second variance.
    a << 1, 1, 0, 1, 1, TypeParam(0.5), 0, TypeParam(0.5), 1;
    EXPECT_FALSE((Ldlt<TypeParam, 3>(a, TypeParam(1e-4)).semidefinite()));
}

TYPED_TEST(LdltTest, SingularCovarianceIsSemidefiniteButNotPositive) {
    const Vector<TypeParam, 3> direction(1, 2, -1);
    const Matrix<TypeParam, 3> a = direction * direction.transpose();
    EXPECT_FALSE((Ldlt<TypeParam, 3>(a, TypeParam(1e-4)).positive()));
    EXPECT_TRUE((Ldlt<TypeParam, 3>(a, TypeParam(1e-4)).semidefinite()));
    const Ldlt<TypeParam, 3> zero(Matrix<TypeParam, 3>::Zero());
    EXPECT_FALSE(zero.positive());
    EXPECT_TRUE(zero.semidefinite());
}

TYPED_TEST(LdltTest, PivotsWithinTheToleranceCountAsZeroOnBothSides) {
    Matrix<TypeParam, 2> a;
    a << 1, 1, 1, TypeParam(0.99);  // the second pivot is -0.01
    EXPECT_FALSE((Ldlt<TypeParam, 2>(a, TypeParam(0.001)).semidefinite()));
    EXPECT_TRUE((Ldlt<TypeParam, 2>(a, TypeParam(0.1)).semidefinite()));
    a(1, 1) = TypeParam(1.01);
    EXPECT_TRUE((Ldlt<TypeParam, 2>(a, TypeParam(0.001)).positive()));
    EXPECT_FALSE((Ldlt<TypeParam, 2>(a, TypeParam(0.1)).positive()));
}

TYPED_TEST(LdltTest, FrozenRowIsLeftOut) {
    Draw draw(3);
    Matrix<TypeParam, 3> a = draw.covariance<TypeParam, 3>();
    a.row(1).setZero();
    a.col(1).setZero();
    const Ldlt<TypeParam, 3> factor(a, TypeParam(1e-4));
    EXPECT_FALSE(factor.positive());
    EXPECT_TRUE(factor.semidefinite());
    const Vector<TypeParam, 3> x = factor.solve(Vector<TypeParam, 3>(1, 0, 2));
    EXPECT_EQ(x[1], 0);
    EXPECT_TRUE(close(a * x, Vector<TypeParam, 3>(1, 0, 2), 10 * kTight<TypeParam>));
}

TYPED_TEST(LdltTest, NotANumberAnywhereBelowIsNoCovariance) {
    for (int j = 0; j < 3; ++j)
        for (int i = j; i < 3; ++i) {
            Matrix<TypeParam, 3> a = Matrix<TypeParam, 3>::Identity();
            a(i, j) = NAN;
            EXPECT_FALSE((Ldlt<TypeParam, 3>(a).positive())) << i << ", " << j;
            EXPECT_FALSE((Ldlt<TypeParam, 3>(a).semidefinite())) << i << ", " << j;
        }
}

TYPED_TEST(LdltTest, AVarianceBelowZeroIsNoRounding) {
    Matrix<TypeParam, 2> a = Matrix<TypeParam, 2>::Identity();
    a(0, 0) = TypeParam(-1e-6);
    Vector<TypeParam, 2> before(1e6, 1);
    EXPECT_FALSE((Ldlt<TypeParam, 2>(a, TypeParam(1e-4), before).semidefinite()));
}

}  // namespace
}  // namespace pilotage::test
