#pragma once
/// \file
/// Comparisons that say what differs: `EXPECT_TRUE(same_pose(actual, expected, tolerance))`.

#include <gtest/gtest.h>

#include <cstring>

#include "pilotage/state.hpp"

namespace pilotage::test {

inline const Eigen::IOFormat kDigits(Eigen::FullPrecision, 0, ", ", "\n", "  [", "]");

/// The comparison behind close() and same_pose(), compiled once.
[[nodiscard]] ::testing::AssertionResult close_in_double(const Eigen::MatrixXd& actual,
                                                         const Eigen::MatrixXd& expected,
                                                         double tolerance);
[[nodiscard]] ::testing::AssertionResult same_pose_in_double(const Pose<double>& actual,
                                                             const Pose<double>& expected,
                                                             double tolerance);

/// Every entry within `tolerance` times the largest entry of `expected`, or times 1 where that is
/// smaller than 1.
template <typename A, typename B>
[[nodiscard]] ::testing::AssertionResult close(const Eigen::MatrixBase<A>& actual,
                                               const Eigen::MatrixBase<B>& expected,
                                               double tolerance) {
    return close_in_double(actual.template cast<double>(), expected.template cast<double>(),
                           tolerance);
}

/// The pose as a point of the plane and a direction: headings of -pi and pi are the same.
template <typename Scalar>
[[nodiscard]] ::testing::AssertionResult same_pose(const Pose<Scalar>& actual,
                                                   const Pose<Scalar>& expected, double tolerance) {
    return same_pose_in_double(actual.template cast<double>(), expected.template cast<double>(),
                               tolerance);
}

/// The smallest eigenvalue of a symmetric matrix over its largest one: a covariance has none below
/// zero.
[[nodiscard]] double smallest_eigenvalue_ratio(const Eigen::MatrixXd& symmetric);

/// Not a bit of it has changed.
template <typename Scalar, int Rows, int Cols>
[[nodiscard]] bool same_bits(const Matrix<Scalar, Rows, Cols>& a,
                             const Matrix<Scalar, Rows, Cols>& b) {
    return std::memcmp(a.data(), b.data(), sizeof(Scalar) * Rows * Cols) == 0;
}

}  // namespace pilotage::test
