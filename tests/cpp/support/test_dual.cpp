#include "support/dual.hpp"

#include <gtest/gtest.h>

#include "support/jacobians.hpp"

namespace pilotage::test {
namespace {

// An oracle needs one of its own: derivatives known from school, at a point of no symmetry.
TEST(Dual, KnowsTheDerivativesOfSchool) {
    const Dual<double> x(0.7, 1.0);
    EXPECT_DOUBLE_EQ((x * x * x).slope, 3 * 0.7 * 0.7);
    EXPECT_DOUBLE_EQ((2 / x).slope, -2 / (0.7 * 0.7));
    EXPECT_DOUBLE_EQ((1 - x).slope, -1);
    EXPECT_DOUBLE_EQ(sin(x).slope, std::cos(0.7));
    EXPECT_DOUBLE_EQ(cos(x).slope, -std::sin(0.7));
    EXPECT_DOUBLE_EQ(sqrt(x).slope, 0.5 / std::sqrt(0.7));
    EXPECT_DOUBLE_EQ(exp(x).slope, std::exp(0.7));
    EXPECT_DOUBLE_EQ(log(x).slope, 1 / 0.7);
    EXPECT_DOUBLE_EQ(abs(-x).slope, 1);
    EXPECT_DOUBLE_EQ(atan(x).slope, 1 / (1 + 0.49));
    EXPECT_DOUBLE_EQ(atan2(x, Dual<double>(2)).slope, 2 / (4 + 0.49));
    EXPECT_DOUBLE_EQ(atan2(Dual<double>(2), x).slope, -2 / (4 + 0.49));
}

TEST(Dual, AngleKeepsItsSlopeThroughAWrap) {
    EXPECT_EQ(wrap(Dual<double>(4, 3)).slope, 3);
    EXPECT_EQ(wrap(Dual<double>(100, 3)).slope, 3);
}

TEST(Dual, DerivativeOfALinearMapIsItsMatrix) {
    Matrix<double, 2, 3> map;
    map << 1, 2, 3, -4, 5, -6;
    const auto jacobian = derivative(
        [&](const Vector<Dual<double>, 3>& at) {
            return Vector<Dual<double>, 2>(map.cast<Dual<double>>() * at);
        },
        Vector<double, 3>(7, 8, 9));
    EXPECT_EQ(jacobian, map);
}

}  // namespace
}  // namespace pilotage::test
