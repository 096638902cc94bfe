#pragma once
/// \file
/// The core's models of motion and measurement as Python names them, and which of them fit a state.

#include <variant>

#include "pilotage/motion/constant_velocity.hpp"
#include "pilotage/motion/skid_steer.hpp"
#include "pilotage/motion/velocity.hpp"
#include "pilotage/sensing/direct.hpp"
#include "pilotage/sensing/echo_envelope.hpp"
#include "pilotage/sensing/marker_sighting.hpp"
#include "pilotage/sensing/mounted.hpp"
#include "pilotage/sensing/relative_position.hpp"
#include "pilotage/sensing/wall_range.hpp"
#include "pilotage/sensing/wheel_travel.hpp"
#include "pilotage/sensing/world_bearing.hpp"

namespace pilotage::bindings {

using EulerVelocity = Velocity<double, Chord::tangent>;
using MidpointVelocity = Velocity<double, Chord::midpoint>;
using ArcVelocity = Velocity<double, Chord::arc>;

template <template <typename> class Model>
using OnRobot = Mounted<Model<double>, double>;
using WorldBearingSighting = MarkerSighting<double, WorldBearing<double>>;

/// Of a pose.
using PoseMotion =
    std::variant<MoveAndTurn<double>, EulerVelocity, MidpointVelocity, ArcVelocity,
                 LinearizedVelocity<double>, PlanarVelocity<double>, SkidSteer<double>>;
/// By a pose, or by the pose that further states follow.
using PoseMeasurement =
    std::variant<OnRobot<RelativePosition>, WorldBearingSighting, OnRobot<WallRange>,
                 OnRobot<PositionFix>, OnRobot<HeadingFix>, OnRobot<PoseFix>>;

/// Of a pose with its velocities.
using VelocityMotion = std::variant<ConstantVelocity<double>>;
using VelocityMeasurement = std::variant<Speed<double>, YawRate<double>, WheelTravel<double>>;

/// Of an ultrasonic echo.
using EchoMeasurement = std::variant<EchoEnvelope<double>>;

}  // namespace pilotage::bindings
