#include "pilotage/congruence.hpp"

#include "support/matchers.hpp"
#include "support/random.hpp"
#include "support/scalars.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(CongruenceTest);

template <typename Scalar>
HeadingShear<Scalar> random_shear(Draw& draw) {
    return {draw.uniform<Scalar>(-3, 3), draw.uniform<Scalar>(-3, 3)};
}

template <typename Scalar, int N>
Matrix<Scalar, N> mirrored(Matrix<Scalar, N> p) {
    mirror_lower(p);
    return p;
}

TYPED_TEST(CongruenceTest, ShearIsEquation21) {
    Matrix<TypeParam, 3> a;
    a << 1, 0, -7, 0, 1, 5, 0, 0, 1;
    EXPECT_EQ((HeadingShear<TypeParam>{5, 7}.dense()), a);
}

TYPED_TEST(CongruenceTest, ShearedCovarianceIsTheDenseProduct) {
    Draw draw(1);
    for (int i = 0; i < 100; ++i) {
        const auto a = random_shear<TypeParam>(draw);
        const auto p = draw.covariance<TypeParam, 3>();
        const Matrix<TypeParam, 3> dense = a.dense() * p * a.dense().transpose();
        EXPECT_TRUE(close(mirrored<TypeParam>(congruence(a, p)), dense, kTight<TypeParam>));
        EXPECT_TRUE(close(congruence(a.dense(), p), dense, kTight<TypeParam>));
    }
}

TYPED_TEST(CongruenceTest, CalibratedCovarianceIsTheDenseProduct) {
    Draw draw(2);
    for (int i = 0; i < 100; ++i) {
        const CalibratedTransition<TypeParam> a{random_shear<TypeParam>(draw),
                                                draw.normal<TypeParam, 3, 3>()};
        const auto p = draw.covariance<TypeParam, 6>();
        const Matrix<TypeParam, 6> dense = a.dense() * p * a.dense().transpose();
        EXPECT_TRUE(close(mirrored<TypeParam>(congruence(a, p)), dense, kTight<TypeParam>));
        EXPECT_TRUE(close(congruence(a.dense(), p), dense, kTight<TypeParam>));
    }
}

TYPED_TEST(CongruenceTest, FurtherStatesStayAndMoveWithThePoseTheyAreTiedTo) {
    Draw draw(6);
    for (int i = 0; i < 100; ++i) {
        const CalibratedTransition<TypeParam> a{random_shear<TypeParam>(draw),
                                                draw.normal<TypeParam, 3, 3>()};
        const auto p = draw.covariance<TypeParam, 8>();
        Matrix<TypeParam, 8> whole = Matrix<TypeParam, 8>::Identity();
        whole.template topLeftCorner<6, 6>() = a.dense();
        const Matrix<TypeParam, 8> dense = whole * p * whole.transpose();
        EXPECT_TRUE(close(mirrored<TypeParam>(congruence(a, p)), dense, kTight<TypeParam>));
    }
}

TYPED_TEST(CongruenceTest, CertainCalibrationLeavesThePlainShear) {
    Draw draw(3);
    const CalibratedTransition<TypeParam> a{random_shear<TypeParam>(draw),
                                            draw.normal<TypeParam, 3, 3>()};
    Matrix<TypeParam, 6> p = Matrix<TypeParam, 6>::Zero();
    p.template topLeftCorner<3, 3>() = draw.covariance<TypeParam, 3>();
    Matrix<TypeParam, 6> expected = Matrix<TypeParam, 6>::Zero();
    expected.template topLeftCorner<3, 3>() = mirrored<TypeParam>(
        congruence<TypeParam>(a.shear, Matrix<TypeParam, 3>(p.template topLeftCorner<3, 3>())));
    EXPECT_EQ((mirrored<TypeParam>(congruence(a, p))), expected);
}

TYPED_TEST(CongruenceTest, InputNoiseEntersThroughB) {
    Draw draw(4);
    for (int i = 0; i < 100; ++i) {
        const auto b = draw.normal<TypeParam, 3, 2>();
        const auto gamma = draw.covariance<TypeParam, 2>();
        const auto p = draw.covariance<TypeParam, 6>();
        Matrix<TypeParam, 6> actual = p, expected = p;
        add_input_noise(b, gamma, actual);
        expected.template topLeftCorner<3, 3>() += b * gamma * b.transpose();
        EXPECT_TRUE(close(mirrored<TypeParam>(actual), expected, kTight<TypeParam>));
    }
}

TYPED_TEST(CongruenceTest, MirroringMakesTheMatrixSymmetricFromBelow) {
    Draw draw(5);
    const auto p = draw.normal<TypeParam, 6, 6>();
    const auto result = mirrored<TypeParam, 6>(p);
    EXPECT_EQ(result, (Matrix<TypeParam, 6>(result.transpose())));
    EXPECT_EQ((Matrix<TypeParam, 6>(result.template triangularView<Eigen::Lower>())),
              (Matrix<TypeParam, 6>(p.template triangularView<Eigen::Lower>())));
}

}  // namespace
}  // namespace pilotage::test
