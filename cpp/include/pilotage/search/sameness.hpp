#pragma once
/// \file
/// When two poses are one.

#include <cmath>

#include "pilotage/filter/ldlt.hpp"
#include "pilotage/state.hpp"

namespace pilotage {

/// As far as the covariance of their difference can tell.
[[nodiscard]] inline bool same(const Pose<double>& a, const Pose<double>& b,
                               const Matrix<double, 3>& covariance,
                               double squared_sigmas) noexcept {
    return Ldlt<double, 3>(covariance).squared_norm(minus<double, 3>(a, b)) < squared_sigmas;
}

[[nodiscard]] inline bool within(const Pose<double>& a, const Pose<double>& b, double position_m,
                                 double heading_rad) noexcept {
    const Pose<double> apart = minus<double, 3>(a, b);
    return std::hypot(apart[kX], apart[kY]) < position_m && std::abs(apart[kHeading]) < heading_rad;
}

/// The same place for all practical purposes: a climb or the filter goes from one to the other by
/// itself.
[[nodiscard]] inline bool next_to(const Pose<double>& a, const Pose<double>& b) noexcept {
    return within(a, b, 0.2, 0.1);
}

}  // namespace pilotage
