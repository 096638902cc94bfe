#pragma once
/// \file
/// What a pose pays for being one of many.

#include <algorithm>
#include <cmath>

#include "pilotage/filter/ldlt.hpp"
#include "pilotage/search/site.hpp"

namespace pilotage {

/// Of a pose that sightings alone have told, as surely as the covariance says, with any pose of the
/// site as likely before: the logarithm of the part of all poses that it takes.
[[nodiscard]] inline double log_occam(const Matrix<double, 3>& covariance,
                                      const Site& site) noexcept {
    const double log_det = std::log(Ldlt<double, 3>(covariance).determinant());
    return (3 * std::log(2 * kPi<double>) + log_det) / 2 - site.log_volume();
}

}  // namespace pilotage
