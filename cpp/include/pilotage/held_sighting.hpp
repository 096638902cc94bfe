#pragma once
/// \file
/// A sighting held against a marker of the map: what was measured less what the pose predicts, with
/// its Jacobian and its noise. The update and the association both begin with it.

#include <cmath>

#include "pilotage/marker_map.hpp"
#include "pilotage/params.hpp"
#include "pilotage/samples.hpp"
#include "pilotage/sensing/bearing.hpp"
#include "pilotage/sensing/elevation.hpp"
#include "pilotage/sensing/marker_sighting.hpp"
#include "pilotage/sensing/mounted.hpp"
#include "pilotage/sensing/range.hpp"

namespace pilotage {

/// The components that a sighting has: bit ComponentIndex is set.
[[nodiscard]] inline int measured_components(const Sighting& sighting) noexcept {
    int bits = 0;
    each<3>([&](int c) { bits |= std::isnan(sighting.value[c]) ? 0 : 1 << c; });
    return bits;
}

/// Variance of one component: the sighting's own sigma where it states one, and for ranges what
/// grows with them.
template <typename Scalar>
[[nodiscard]] Scalar sensor_variance(const Sighting& sighting, ComponentIndex component,
                                     const SensorParams& sensor, Scalar predicted) noexcept {
    const double configured[] = {sensor.sigma_bearing_rad, sensor.sigma_elevation_rad,
                                 sensor.sigma_range_m};
    const double stated = sighting.sigma[component];
    const auto sigma = Scalar(std::isnan(stated) ? configured[component] : stated);
    if (component != kRange) return sigma * sigma;
    const Scalar growth = Scalar(sensor.sigma_range_per_m) * predicted;
    return sigma * sigma + growth * growth;
}

/// The innovation of M components and what is needed to judge it.
template <typename Scalar, int M>
struct HeldSighting {
    Vector<Scalar, M> innovation;
    Matrix<Scalar, M, kPoseStates> jacobian;
    Vector<Scalar, M> variances;  ///< of the sensor
    Scalar survey_variance;       ///< of the marker's x and of its y [m^2]
    Scalar dx, dy, dz;            ///< from the sensor to the marker [m]
    bool defined;                 ///< else the marker is too close, and nothing else means anything

    /// R. The survey's uncertainty reaches the measurement as the sensor's position does, with the
    /// other sign.
    [[nodiscard]] Matrix<Scalar, M> noise() const noexcept {
        return symmetric<Matrix<Scalar, M>>([&](int i, int j) {
            const Scalar survey = survey_variance * (jacobian(i, kX) * jacobian(j, kX) +
                                                     jacobian(i, kY) * jacobian(j, kY));
            return i == j ? survey + variances[i] : survey;
        });
    }
};

/// The model of these components of a marker, seen by a sensor.
template <typename Scalar, typename... Components>
[[nodiscard, gnu::always_inline]] inline Mounted<MarkerSighting<Scalar, Components...>, Scalar>
sighting_model(const Marker& marker, const SensorParams& sensor,
               const Components&... components) noexcept {
    return {
        {Vector<Scalar, 3>(Scalar(marker.x_m), Scalar(marker.y_m), Scalar(marker.z_m - sensor.z_m)),
         {components...},
         Scalar(sensor.min_distance_m)},
        {Scalar(sensor.x_m), Scalar(sensor.y_m), Scalar(sensor.yaw_rad)}};
}

/// The values of these components.
template <typename Scalar, typename... Components>
[[nodiscard, gnu::always_inline]] inline Vector<Scalar, int(sizeof...(Components))> values_of(
    const Sighting& sighting) noexcept {
    constexpr ComponentIndex which[] = {Components::kIndex...};
    return entries<Vector<Scalar, int(sizeof...(Components))>>(
        [&](int i, int) { return Scalar(sighting.value[which[i]]); });
}

/// Linearised at a pose of the robot.
template <typename Scalar, typename... Components>
[[nodiscard, gnu::always_inline]] inline HeldSighting<Scalar, sizeof...(Components)> hold_against(
    const Pose<Scalar>& robot, const Marker& marker, const Sighting& sighting,
    const SensorParams& sensor, const Components&... components) noexcept {
    constexpr int M = sizeof...(Components);
    constexpr ComponentIndex which[] = {Components::kIndex...};
    const auto model = sighting_model<Scalar>(marker, sensor, components...);
    const auto h = model.linearize(robot);
    HeldSighting<Scalar, M> held;
    held.defined = h.defined;
    if (!h.defined) return held;
    held.innovation = model.minus(values_of<Scalar, Components...>(sighting), h.value);
    held.jacobian = h.jacobian;
    held.variances = entries<Vector<Scalar, M>>(
        [&](int i, int) { return sensor_variance(sighting, which[i], sensor, h.value[i]); });
    held.survey_variance = Scalar(marker.sigma_m) * Scalar(marker.sigma_m);
    held.dx = h.dx;
    held.dy = h.dy;
    held.dz = model.model.marker_above_sensor[2];
    return held;
}

}  // namespace pilotage
