#pragma once
/// \file
/// The state of a robot whose velocities are estimated with its pose.

#include "pilotage/state.hpp"

namespace pilotage {

/// Places behind the pose.
enum VelocityIndex : int {
    kSpeed = 3,    ///< m/s, along the heading
    kYawRate = 4,  ///< rad/s, counter-clockwise
};

inline constexpr int kVelocityStates = 5;

}  // namespace pilotage
