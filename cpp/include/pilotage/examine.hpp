#pragma once
/// \file
/// What is wrong with a sample by itself, before it meets the estimate.

#include "pilotage/filter/ldlt.hpp"
#include "pilotage/params.hpp"
#include "pilotage/samples.hpp"
#include "pilotage/state.hpp"
#include "pilotage/verdict.hpp"

namespace pilotage {

inline constexpr double kFarthest = 1e7;  ///< m or rad: no pose is farther off
/// m^2 and rad^2: of more, rounding would leave negative variances behind.
inline constexpr double kUnsurest = 1e9, kUnsurestHeading = 100;
/// The covariance of (x, y, heading) that a sample states as (xx, yx, yy, hx, hy, hh).
[[nodiscard]] Matrix<double, 3> symmetric_of(const double (&lower)[6]) noexcept;

/// Whether a symmetric matrix from outside can be a covariance, but for rounding.
template <int N>
[[nodiscard]] bool is_covariance(const Matrix<double, N>& p) noexcept {
    constexpr double rounding = 1e-12;
    for (int i = 0; i < N; ++i)
        for (int j = 0; j < i; ++j)
            if (!(p(i, j) * p(i, j) <= p(i, i) * p(j, j) * (1 + rounding))) return false;
    return Ldlt<double, N>(p, rounding).semidefinite();
}

/// `pending` if nothing is wrong, else bad_value or implausible.
[[nodiscard]] Verdict examine(const Sample& sample, const Params& params) noexcept;

}  // namespace pilotage
