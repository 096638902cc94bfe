#pragma once
/// \file
/// What a tilted body does to bearing and elevation, to first order.
///
/// A body that is pitched by p (nose up) and rolled by r (left side up) sees the unit vector v to a
/// marker as v - w x v with w = (r, -p, 0). Of a marker at bearing b and elevation e, both in the
/// level robot frame, it measures
///     elevation: e - p cos b - r sin b
///     bearing:   b + tan e (r cos b - p sin b)

#include <cmath>

#include "pilotage/filter/ekf.hpp"
#include "pilotage/held_sighting.hpp"
#include "pilotage/params.hpp"

namespace pilotage {

/// A held sighting with what the tilt adds to it.
template <typename Scalar, int M>
struct TiltedSighting {
    Vector<Scalar, M> innovation;
    Matrix<Scalar, M, kTiltedStates> jacobian;
};

/// \param x the state, pose and tilt of which count
template <typename Scalar, typename... Components>
[[nodiscard]] TiltedSighting<Scalar, int(sizeof...(Components))> with_tilt(
    const HeldSighting<Scalar, int(sizeof...(Components))>& held,
    const Vector<Scalar, kTiltedStates>& x) noexcept {
    constexpr int M = sizeof...(Components);
    constexpr ComponentIndex which[] = {Components::kIndex...};
    const Scalar bearing = direction_of(held.dx, held.dy) - x[kHeading];
    const Scalar c = std::cos(bearing), s = std::sin(bearing);
    const Scalar tan_e = held.dz / std::sqrt(held.dx * held.dx + held.dy * held.dy);
    TiltedSighting<Scalar, M> tilted{held.innovation, Matrix<Scalar, M, kTiltedStates>::Zero()};
    tilted.jacobian.template leftCols<kPoseStates>() = held.jacobian;
    for (int i = 0; i < M; ++i) {
        if (which[i] == kRange) continue;
        const bool turns = which[i] == kBearing;
        tilted.jacobian(i, kPitch) = turns ? -tan_e * s : -c;
        tilted.jacobian(i, kRoll) = turns ? tan_e * c : -s;
        tilted.innovation[i] -=
            tilted.jacobian(i, kPitch) * x[kPitch] + tilted.jacobian(i, kRoll) * x[kRoll];
    }
    return tilted;
}

/// Carries pitch and roll over the time to the next frame: first-order Gauss-Markov, whose variance
/// stays sigma^2. With tau = 0 nothing is left of what they were, which gives each frame a tilt of
/// its own, common to all its sightings: R gets sigma_p^2 c c' + sigma_r^2 s s' over the frame.
template <typename Scalar>
void settle_tilt(Ekf<Scalar, kTiltedStates>& filter, Scalar dt_s, const TiltParams& tilt) noexcept {
    if (!(dt_s > 0)) return;
    const Scalar keep = tilt.tau_s > 0 ? std::exp(-dt_s / Scalar(tilt.tau_s)) : Scalar(0);
    const double sigma[] = {tilt.pitch_sigma_rad, tilt.roll_sigma_rad};
    Vector<Scalar, kTiltedStates> x = filter.state();
    Matrix<Scalar, kTiltedStates> p = filter.covariance();
    for (int i = 0; i < 2; ++i) {
        const int k = kPitch + i;
        x[k] *= keep;
        p.row(k) *= keep;
        p.col(k) *= keep;
        p(k, k) += Scalar(sigma[i] * sigma[i]) * (1 - keep * keep);
    }
    filter = {x, p};
}

}  // namespace pilotage
