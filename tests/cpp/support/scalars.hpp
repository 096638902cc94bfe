#pragma once
/// \file
/// The core serves double and float; every test of it runs for both, each at its own tolerance.

#include <gtest/gtest.h>

#include <string>
#include <type_traits>

namespace pilotage::test {

using Scalars = ::testing::Types<double, float>;

/// Names the instances of a typed suite: `UnicycleTest/float`.
struct ScalarNames {
    template <typename Scalar>
    static std::string GetName(int) {
        return std::is_same_v<Scalar, float> ? "float" : "double";
    }
};

/// Relative difference of two ways to compute the same thing.
template <typename Scalar>
inline constexpr Scalar kTight = std::is_same_v<Scalar, float> ? Scalar(2e-5) : Scalar(1e-12);

/// Difference of a Jacobian's row from its oracle, relative to the row's norm.
template <typename Scalar>
inline constexpr Scalar kJacobian = std::is_same_v<Scalar, float> ? Scalar(1e-5) : Scalar(1e-9);

}  // namespace pilotage::test

/// Declares a suite that runs for every scalar.
#define PILOTAGE_SUITE(Suite)                \
    template <typename Scalar>               \
    class Suite : public ::testing::Test {}; \
    TYPED_TEST_SUITE(Suite, ::pilotage::test::Scalars, ::pilotage::test::ScalarNames)
