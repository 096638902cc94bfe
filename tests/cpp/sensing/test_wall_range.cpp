#include "pilotage/sensing/wall_range.hpp"

#include <Eigen/Eigenvalues>

#include "pilotage/filter/ekf.hpp"
#include "pilotage/sensing/mounted.hpp"
#include "support/jacobians.hpp"
#include "support/points.hpp"
#include "support/units.hpp"
#include "support/worlds.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_SUITE(WallRangeTest);

// The runnable example: a scanner looks left at a wall 2 m beside the robot.
TEST(WallRange, BeamToTheLeftMeasuresTheWallThere) {
    const WallMap walls({{0, 2, 10, 2}});
    const WallRange<double> left{&walls, kPi<double> / 2};
    const auto h = left.linearize({5, 0, 0});
    EXPECT_DOUBLE_EQ(h.value[0], 2);
    EXPECT_TRUE(close(h.jacobian, Matrix<double, 1, 3>(0, -1, 0), 1e-15));
}

TYPED_TEST(WallRangeTest, NothingAheadIsNotDefined) {
    const WallMap walls({{0, 2, 10, 2}});
    EXPECT_FALSE((WallRange<TypeParam>{&walls, 0}.linearize({5, 0, -1}).defined));
    EXPECT_FALSE((WallRange<TypeParam>{&walls, 0}.linearize({NAN, 0, 1}).defined));
}

TYPED_TEST(WallRangeTest, GrazingBeamIsNotDefined) {
    const WallMap walls({{-1000, 2, 1000, 2}});
    const auto at = [&](double degrees) {
        return WallRange<TypeParam>{&walls, TypeParam(degrees * kDegree)}.linearize({0, 0, 0});
    };
    EXPECT_FALSE(at(2.5).defined);
    EXPECT_TRUE(at(3.5).defined);
    EXPECT_TRUE(at(176.5).defined);
    EXPECT_FALSE(at(177.5).defined);
}

TYPED_TEST(WallRangeTest, JacobianIsTheDerivative) {
    const WallMap hall(ring({{-9, -8}, {8, -9}, {9, 1}, {6, 2}, {8, 6}, {-7, 9}}));
    const PlanarMounting<TypeParam> at{TypeParam(0.4), TypeParam(-0.1), TypeParam(0.3)};
    int defined = 0;
    for (auto x : poses<TypeParam>()) {
        x.template head<2>() /= 10;
        for (int beam = -3; beam <= 3; ++beam) {
            // Rounding of the slope to a wall grows as the beam flattens.
            const WallRange<TypeParam> range{&hall, TypeParam(beam), TypeParam(0.3)};
            const Mounted<WallRange<TypeParam>, TypeParam> scanner{range, at};
            if (range.linearize(x).defined) expect_jacobians(range, x);
            if (!scanner.linearize(x).defined) continue;
            expect_jacobians(scanner, x);
            ++defined;
        }
    }
    EXPECT_GT(defined, 300);
}

// The usable part of the assignment's worked numbers: printed with the wall y = -1.5, the beam at
// 90 degrees to the left and a range sigma of 0.01 of the range.
class AssignmentExample : public ::testing::Test {
   protected:
    AssignmentExample() {
        prior << 0.0200199, -0.000998142, -0.00991148,  //
            -0.000998142, 0.00285555, 0.000676311,      //
            -0.00991148, 0.000676311, 0.0126447;
        filter = {estimate, prior};
    }

    /// Half axes of the ellipse that holds 95.4 % of a plane Gaussian.
    [[nodiscard]] Vector<double, 2> radii() const {
        const Matrix<double, 2> plane = filter.covariance().topLeftCorner<2, 2>();
        return 2.4816 *
               Eigen::SelfAdjointEigenSolver<Matrix<double, 2>>(plane).eigenvalues().cwiseSqrt();
    }

    const Pose<double> estimate{1.22095, 0.505793, 181.969 * kDegree};
    const double measured_m = 2.00572;
    Matrix<double, 3> prior;
    Ekf<double, 3> filter;
    const WallMap walls{{{-9, -1.5, 9, -1.5}}};
    const WallRange<double> beam{&walls, 90 * kDegree};
};

TEST_F(AssignmentExample, PredictedRangeAndDerivatives) {
    const auto h = beam.linearize(estimate);
    EXPECT_NEAR(h.value[0], 2.00698, 1e-5);
    EXPECT_TRUE(close(h.jacobian, Matrix<double, 1, 3>(0, 1.00059, 0.0689879), 2e-5));
}

TEST_F(AssignmentExample, RevisedStateAndEllipses) {
    EXPECT_TRUE(close(radii(), Vector<double, 2>(0.131259, 0.35163), 1e-5));
    const double sigma = 0.01 * measured_m;
    ASSERT_TRUE(
        filter.update(beam, Vector<double, 1>(measured_m), Matrix<double, 1>(sigma * sigma), {})
            .accepted());
    EXPECT_NEAR(filter.state()[kX], 1.22157, 1e-5);
    EXPECT_NEAR(filter.state()[kY], 0.504722, 1e-5);
    EXPECT_NEAR(filter.state()[kHeading], wrap(181.936 * kDegree), 1e-3 * kDegree);
    EXPECT_TRUE(close(radii(), Vector<double, 2>(0.0481291, 0.343865), 2e-5));
}

// Erratum: the printed one has larger variances than the prior.
TEST_F(AssignmentExample, RevisedCovarianceIsSmallerThanThePrior) {
    const double sigma = 0.01 * measured_m;
    (void)filter.update(beam, Vector<double, 1>(measured_m), Matrix<double, 1>(sigma * sigma), {});
    Matrix<double, 3> revised;
    revised << 0.019191, 0.000433, -0.009148,  //
        0.000433, 0.000386, -0.000641,         //
        -0.009148, -0.000641, 0.011942;
    EXPECT_TRUE((filter.covariance() - revised).cwiseAbs().maxCoeff() < 1e-6);
    const Vector<double, 3> sigmas = filter.covariance().diagonal().cwiseSqrt();
    EXPECT_NEAR(2 * std::sqrt(prior(2, 2)) / kDegree, 12.886, 1e-3);
    EXPECT_NEAR(2 * sigmas[kHeading] / kDegree, 12.523, 1e-3);
}

}  // namespace
}  // namespace pilotage::test
