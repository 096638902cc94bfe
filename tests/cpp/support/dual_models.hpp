#pragma once
/// \file
/// The same model over another scalar. A new model or component adds its line here.

#include <tuple>

#include "pilotage/motion/calibrated.hpp"
#include "pilotage/motion/constant_velocity.hpp"
#include "pilotage/motion/differential_drive.hpp"
#include "pilotage/motion/skid_steer.hpp"
#include "pilotage/motion/unicycle.hpp"
#include "pilotage/motion/velocity.hpp"
#include "pilotage/sensing/bearing.hpp"
#include "pilotage/sensing/direct.hpp"
#include "pilotage/sensing/echo_envelope.hpp"
#include "pilotage/sensing/elevation.hpp"
#include "pilotage/sensing/marker_sighting.hpp"
#include "pilotage/sensing/mounted.hpp"
#include "pilotage/sensing/pixel_sighting.hpp"
#include "pilotage/sensing/range.hpp"
#include "pilotage/sensing/relative_position.hpp"
#include "pilotage/sensing/wall_range.hpp"
#include "pilotage/sensing/wheel_travel.hpp"
#include "pilotage/sensing/world_bearing.hpp"

namespace pilotage::test {

template <typename To, typename From, Chord kChord>
Unicycle<To, kChord> with_scalar(const Unicycle<From, kChord>& model) {
    return {To(model.slip_angle_rad)};
}

template <typename To, typename From>
DifferentialDrive<To> with_scalar(const DifferentialDrive<From>& model) {
    return {To(model.track_width_m)};
}

template <typename To, typename From>
GyroDrive<To> with_scalar(const GyroDrive<From>&) {
    return {};
}

template <typename To, typename Model, typename From>
auto with_scalar(const Calibrated<Model, From>& calibrated) {
    const auto model = with_scalar<To>(calibrated.model);
    return Calibrated<std::remove_const_t<decltype(model)>, To>{model, To(calibrated.gyro_time_s)};
}

template <typename To, typename From, Chord kChord>
Velocity<To, kChord> with_scalar(const Velocity<From, kChord>& model) {
    return {To(model.dt_s), To(model.slip_angle_rad)};
}

template <typename To, typename From>
PlanarVelocity<To> with_scalar(const PlanarVelocity<From>& model) {
    return {To(model.dt_s)};
}

template <typename To, typename From>
SkidSteer<To> with_scalar(const SkidSteer<From>& model) {
    return {model.coefficients.template cast<To>(), To(model.dt_s)};
}

template <typename To, typename From>
ConstantVelocity<To> with_scalar(const ConstantVelocity<From>& model) {
    return {To(model.dt_s)};
}

template <typename To, typename From>
Bearing<To> with_scalar(const Bearing<From>&) {
    return {};
}

template <typename To, typename From>
Elevation<To> with_scalar(const Elevation<From>&) {
    return {};
}

template <typename To, typename From>
Range<To> with_scalar(const Range<From>& range) {
    return {To(range.scale), To(range.offset_m)};
}

template <typename To, typename From>
WorldBearing<To> with_scalar(const WorldBearing<From>&) {
    return {};
}

template <typename To, typename From, int First, int Count>
Direct<To, First, Count> with_scalar(const Direct<From, First, Count>&) {
    return {};
}

template <typename To, typename From>
WheelTravel<To> with_scalar(const WheelTravel<From>& model) {
    return {To(model.track_width_m), To(model.dt_s)};
}

template <typename To, typename From>
RelativePosition<To> with_scalar(const RelativePosition<From>& model) {
    return {model.marker_m.template cast<To>()};
}

template <typename To, typename From>
WallRange<To> with_scalar(const WallRange<From>& model) {
    return {model.walls, To(model.beam_rad), To(model.min_sine)};
}

template <typename To, typename From>
EchoEnvelope<To> with_scalar(const EchoEnvelope<From>& model) {
    return {To(model.time_s)};
}

template <typename To, typename From>
PixelSighting<To> with_scalar(const PixelSighting<From>& model) {
    return {model.marker_above_sensor.template cast<To>(), model.camera};
}

template <typename To, typename From, typename... Components>
auto with_scalar(const MarkerSighting<From, Components...>& sighting) {
    const Vector<To, 3> marker = sighting.marker_above_sensor.template cast<To>();
    return std::apply(
        [&](const auto&... component) {
            return MarkerSighting<To, decltype(with_scalar<To>(component))...>{
                marker, {with_scalar<To>(component)...}, To(sighting.min_ground_m)};
        },
        sighting.components);
}

template <typename To, typename Model, typename From>
auto with_scalar(const Mounted<Model, From>& mounted) {
    const auto model = with_scalar<To>(mounted.model);
    const PlanarMounting<From>& at = mounted.mounting;
    return Mounted<std::remove_const_t<decltype(model)>, To>{
        model, {To(at.x_m), To(at.y_m), To(at.yaw_rad)}};
}

}  // namespace pilotage::test
