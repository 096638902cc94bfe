#pragma once
/// \file
/// A sighting taken to be of one marker: how likely that is, and what the pose would then be.
///
/// Everything is linearised at the pose before the frame, so that the order in which pairings are
/// taken together does not matter.

#include <cmath>

#include "pilotage/filter/ekf.hpp"
#include "pilotage/held_pixel.hpp"
#include "pilotage/held_sighting.hpp"
#include "pilotage/sensing/stray.hpp"

namespace pilotage {

/// How far strays are seen [m]. A pairing has to be likelier than one.
inline constexpr double kStrayReach_m = 10;

/// A deviation (x [m], y [m], heading [rad]) from the pose before the frame, with its covariance.
template <typename Scalar>
using Deviation = Ekf<Scalar, kPoseStates>;

/// Always of three components: one that was not measured has no innovation, no Jacobian and a noise
/// of one, which changes neither NIS nor determinant, and spares code for each number of them.
template <typename Scalar>
struct Pairing {
    std::int32_t id = kUnknownId;  ///< of the marker
    int dof = 0;                   ///< components measured; 0: it cannot be this marker
    Vector<Scalar, 3> innovation = Vector<Scalar, 3>::Zero();  ///< at the pose before the frame
    Matrix<Scalar, 3> jacobian = Matrix<Scalar, 3>::Zero();
    Matrix<Scalar, 3> noise = Matrix<Scalar, 3>::Identity();
    Scalar stray = 0;     ///< log density of being of no marker, and log (2 pi)^(dof/2)
    Scalar log_odds = 0;  ///< given nothing else of the frame
};

/// What speaks for a pairing, given others.
template <typename Scalar>
struct Support {
    bool possible = false;
    Scalar nis = 0;
    Scalar log_odds = 0;  ///< log likelihood less that of being of no marker [nats]
};

template <typename Scalar>
[[nodiscard]] Scalar log_odds_of(Scalar nis, const Matrix<Scalar, 3>& s, Scalar stray) noexcept {
    return -(nis + std::log(Ldlt<Scalar, 3>(s).determinant())) / 2 - stray;
}

/// Takes the pairing for true.
template <typename Scalar>
[[nodiscard]] Support<Scalar> take(Deviation<Scalar>& deviation,
                                   const Pairing<Scalar>& pairing) noexcept {
    if (pairing.dof == 0) return {};
    const auto innovation = entries<Vector<Scalar, 3>>([&](int i, int) {
        return pairing.innovation[i] - row_by_column(pairing.jacobian, i, deviation.state(), 0);
    });
    const auto update = deviation.correct(innovation, pairing.jacobian, pairing.noise, Policy{});
    if (!update.accepted()) return {};
    const Scalar odds = log_odds_of(update.nis, update.s, pairing.stray);
    return {std::isfinite(odds), update.nis, odds};
}

/// The best that `log_odds` can become, however sure the pose.
template <typename Scalar>
[[nodiscard]] Scalar most_odds(const Pairing<Scalar>& pairing) noexcept {
    return log_odds_of(Scalar(0), pairing.noise, pairing.stray);
}

/// \param measured bit i: there is component i
/// \param strays density of each component where it is of no marker
template <typename Scalar, int M>
[[nodiscard]] Pairing<Scalar> pairing_of(const Marker& marker, const HeldSighting<Scalar, M>& held,
                                         const Matrix<Scalar, M>& noise, int measured,
                                         const double (&strays)[M]) noexcept {
    constexpr double half_log_two_pi = 0.91893853320467274178;
    const auto has = [&](int i) { return (measured >> i & 1) != 0; };
    Pairing<Scalar> pairing;
    pairing.id = marker.id;
    each<M>([&](int i) {
        if (!has(i)) return;
        ++pairing.dof;
        pairing.stray += Scalar(std::log(strays[i]) + half_log_two_pi);
        pairing.innovation[i] = held.innovation[i];
        each<kPoseStates>([&](int j) { pairing.jacobian(i, j) = held.jacobian(i, j); });
        each<M>([&](int j) {
            if (has(j)) pairing.noise(i, j) = noise(i, j);
        });
    });
    return pairing;
}

/// The pixel as one of this marker.
template <typename Scalar>
[[nodiscard]] Pairing<Scalar> pair_up_pixel(const Pose<Scalar>& robot, const Marker& marker,
                                            const Sighting& pixel, const SensorParams& sensor,
                                            Scalar tilt_variance) noexcept {
    const auto held = hold_pixel_against<Scalar>(robot, marker, pixel, sensor);
    if (!held.defined) return {};
    const Matrix<Scalar, 2> tilted = held.by_tilt * held.by_tilt.transpose() * tilt_variance;
    const Intrinsics& image = sensor.camera.intrinsics();
    return pairing_of<Scalar, 2>(marker, held, held.noise() + tilted, 0b11,
                                 {1.0 / image.width_px, 1.0 / image.height_px});
}

/// The sighting as one of this marker.
/// \param robot the pose before the frame
template <typename Scalar>
[[nodiscard]] Pairing<Scalar> pair_up(const Pose<Scalar>& robot, const Marker& marker,
                                      const Sighting& sighting, const SensorParams& sensor,
                                      Scalar tilt_variance = 0) noexcept {
    if (sensor.measures == Measures::pixels)
        return pair_up_pixel(robot, marker, sighting, sensor, tilt_variance);
    const Range<Scalar> range{Scalar(sensor.range_scale), Scalar(sensor.range_offset_m)};
    const auto held = hold_against<Scalar>(robot, marker, sighting, sensor, Bearing<Scalar>{},
                                           Elevation<Scalar>{}, range);
    if (!held.defined) return {};
    auto noise = held.noise();
    noise(kElevation, kElevation) += tilt_variance;
    return pairing_of<Scalar, 3>(
        marker, held, noise, measured_components(sighting),
        {stray_density(kBearing, kStrayReach_m), stray_density(kElevation, kStrayReach_m),
         stray_density(kRange, kStrayReach_m)});
}

}  // namespace pilotage
