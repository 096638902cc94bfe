#pragma once
/// \file
/// What linearising leaves out: close to a marker the measurement bends within the pose's own
/// uncertainty. The second-order term dx' H dx / 2 of a Gaussian dx has variance tr((H P)^2) / 2
/// (Bar-Shalom, Li and Kirubarajan, Estimation with Applications to Tracking and Navigation, 2001,
/// second-order EKF, section 10.3.2).

#include "pilotage/state.hpp"

namespace pilotage {

/// Second derivatives of a component by the sensor's place, along the line of sight over ground and
/// across it, left of it positive.
template <typename Scalar>
struct Bend {
    Scalar along, mixed, across;
};

/// Variance of the second-order term.
/// \param to_marker (dx, dy) over ground [m], not zero
/// \param p covariance of the place, its lower triangle
template <typename Scalar, typename Covariance>
[[nodiscard]] Scalar curvature_variance(const Bend<Scalar>& h, Scalar dx, Scalar dy,
                                        const Covariance& p) noexcept {
    const Scalar per_square = 1 / (dx * dx + dy * dy);
    const Scalar xx = p(kX, kX), xy = p(kY, kX), yy = p(kY, kY);
    const Scalar a = (dx * dx * xx + 2 * dx * dy * xy + dy * dy * yy) * per_square;
    const Scalar b = (dy * dy * xx - 2 * dx * dy * xy + dx * dx * yy) * per_square;
    const Scalar c = (dx * dy * (yy - xx) + (dx * dx - dy * dy) * xy) * per_square;
    const Scalar first = h.along * a + h.mixed * c, last = h.mixed * c + h.across * b;
    const Scalar twice = (h.along * c + h.mixed * b) * (h.mixed * a + h.across * c);
    return (first * first + last * last) / 2 + twice;
}

}  // namespace pilotage
