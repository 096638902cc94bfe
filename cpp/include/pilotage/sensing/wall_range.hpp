#pragma once
/// \file
/// Distance to the nearest wall along a beam, by ray casting in a known world: the range finder of
/// the assignment "Localization and the extended Kalman filter".

#include <cmath>

#include "pilotage/sensing/measurement.hpp"
#include "pilotage/wall_map.hpp"

namespace pilotage {

/// The wall that is hit is a line n.p = c to the derivative, which holds until the beam leaves it.
template <typename Scalar>
struct WallRange {
    static constexpr int kStates = kPoseStates;
    using Values = Vector<Scalar, 1>;

    const WallMap* walls;            ///< not owned
    Scalar beam_rad;                 ///< from the sensor's forward axis, left positive
    Scalar min_sine = Scalar(0.05);  ///< of beam and wall; flatter than this h is no line

    /// Not defined where the beam meets no wall or grazes one.
    [[nodiscard]] Measurement<Scalar, 1, kStates> linearize(
        const Pose<Scalar>& sensor) const noexcept {
        using std::abs;
        using std::cos;
        using std::sin;
        using std::sqrt;
        const Scalar direction = sensor[kHeading] + beam_rad;
        const Vector<Scalar, 2> u(cos(direction), sin(direction));
        const WallHit<Scalar> hit = walls->cast(sensor[kX], sensor[kY], u);
        const Vector<Scalar, 2>& n = hit.normal;
        const Scalar n_u = n[0] * u[0] + n[1] * u[1];
        const Scalar n_left = n[1] * u[0] - n[0] * u[1];  // along the beam turned by 90 degrees
        Measurement<Scalar, 1, kStates> h;
        h.value << hit.range_m;
        h.defined = hit.any() && abs(n_u) >= min_sine * sqrt(n[0] * n[0] + n[1] * n[1]);
        h.jacobian.setZero();
        if (h.defined) h.jacobian << -n[0] / n_u, -n[1] / n_u, -hit.range_m * n_left / n_u;
        return h;
    }

    [[nodiscard]] Values minus(const Values& z, const Values& predicted) const noexcept {
        return z - predicted;
    }
};

}  // namespace pilotage
