#pragma once
/// \file
/// A sighting taken to be of one marker: how likely that is, and what the pose would then be.
///
/// Everything is linearised at the pose before the frame, so that the order in which pairings are
/// taken together does not matter.

#include <cmath>

#include "pilotage/filter/ekf.hpp"
#include "pilotage/held_sighting.hpp"

namespace pilotage {

/// Density of what is seen of no marker of the map (a reflection, another robot), by component
/// [1/rad, 1/rad, 1/m]: any bearing, any elevation, any range up to 10 m. A pairing has to be
/// likelier than this.
inline constexpr double kStrayDensity[] = {0.159, 0.318, 0.1};

/// A deviation (x [m], y [m], heading [rad]) from the pose before the frame, with its covariance.
template <typename Scalar>
using Deviation = Ekf<Scalar, kPoseStates>;

template <typename Scalar>
struct Pairing {
    std::int32_t id = kUnknownId;  ///< of the marker
    int dof = 0;                   ///< so many leading entries mean something; 0: cannot be
    Vector<Scalar, 3> innovation;  ///< at the pose before the frame
    Matrix<Scalar, 3> jacobian, noise;
    Scalar stray;     ///< log density of being of no marker, and log (2 pi)^(dof/2)
    Scalar log_odds;  ///< given nothing else of the frame
};

/// What speaks for a pairing, given others.
template <typename Scalar>
struct Support {
    bool possible = false;
    Scalar nis = 0;
    Scalar log_odds = 0;  ///< log likelihood less that of being of no marker [nats]
};

/// Log likelihood less that of being of no marker.
template <typename Scalar, int M>
[[nodiscard]] Scalar log_odds_of(Scalar nis, const Matrix<Scalar, M>& s, Scalar stray) noexcept {
    return -(nis + std::log(Ldlt<Scalar, M>(s).determinant())) / 2 - stray;
}

/// Takes a pairing of M components for true.
template <int M, typename Scalar>
[[nodiscard, gnu::flatten]] Support<Scalar> take_components(
    Deviation<Scalar>& deviation, const Pairing<Scalar>& pairing) noexcept {
    const auto h = entries<Matrix<Scalar, M, kPoseStates>>(
        [&](int i, int j) { return pairing.jacobian(i, j); });
    const auto innovation = entries<Vector<Scalar, M>>([&](int i, int) {
        return pairing.innovation[i] - row_by_column(h, i, deviation.state(), 0);
    });
    const auto r = symmetric<Matrix<Scalar, M>>([&](int i, int j) { return pairing.noise(i, j); });
    const auto update = deviation.correct(innovation, h, r, Policy{});
    if (!update.accepted()) return {};
    const Scalar odds = log_odds_of<Scalar, M>(update.nis, update.s, pairing.stray);
    return {std::isfinite(odds), update.nis, odds};
}

/// Takes the pairing for true.
template <typename Scalar>
[[nodiscard]] Support<Scalar> take(Deviation<Scalar>& deviation,
                                   const Pairing<Scalar>& pairing) noexcept {
    switch (pairing.dof) {
        case 1:
            return take_components<1>(deviation, pairing);
        case 2:
            return take_components<2>(deviation, pairing);
        case 3:
            return take_components<3>(deviation, pairing);
        default:
            return {};
    }
}

/// The best that `log_odds` can become, however sure the pose.
template <typename Scalar>
[[nodiscard]] Scalar most_odds(const Pairing<Scalar>& pairing) noexcept {
    const auto with_noise = [&](auto components) {
        constexpr int M = decltype(components)::value;
        const auto r =
            symmetric<Matrix<Scalar, M>>([&](int i, int j) { return pairing.noise(i, j); });
        return log_odds_of<Scalar, M>(Scalar(0), r, pairing.stray);
    };
    switch (pairing.dof) {
        case 1:
            return with_noise(std::integral_constant<int, 1>{});
        case 2:
            return with_noise(std::integral_constant<int, 2>{});
        default:
            return with_noise(std::integral_constant<int, 3>{});
    }
}

/// The sighting as one of this marker.
/// \param robot the pose before the frame
template <typename Scalar>
[[nodiscard]] Pairing<Scalar> pair_up(const Pose<Scalar>& robot, const Marker& marker,
                                      const Sighting& sighting,
                                      const MarkerSensorParams& sensor) noexcept {
    Pairing<Scalar> pairing;
    with_components<Scalar>(sighting, sensor, [&](const auto&... components) {
        constexpr int M = sizeof...(components);
        const auto held = hold_against<Scalar>(robot, marker, sighting, sensor, components...);
        if (!held.defined) return;
        constexpr double half_log_two_pi = 0.91893853320467274178;
        const auto r = held.noise();
        pairing.id = marker.id;
        pairing.dof = M;
        each<M>([&](int i) {
            pairing.innovation[i] = held.innovation[i];
            each<3>([&](int j) { pairing.jacobian(i, j) = held.jacobian(i, j); });
            each<M>([&](int j) { pairing.noise(i, j) = r(i, j); });
        });
        pairing.stray =
            Scalar(((std::log(kStrayDensity[std::decay_t<decltype(components)>::kIndex]) +
                     half_log_two_pi) +
                    ...));
    });
    return pairing;
}

}  // namespace pilotage
