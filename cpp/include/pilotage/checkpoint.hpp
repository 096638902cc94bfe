#pragma once
/// \file
/// What a restart begins with: a hypothesis of the pose.

#include <cstdint>

#include "pilotage/samples.hpp"
#include "pilotage/state.hpp"

namespace pilotage {

struct Checkpoint {
    std::int64_t utime = 0;  ///< us, of the newest motion sample
    EncoderTicks ticks{};    ///< then; zeros without encoders
    int states = 0;          ///< kPoseStates or kCalibratedStates
    /// StateIndex order; the first `states` hold, the others are zero.
    Vector<double, kCalibratedStates> state = Vector<double, kCalibratedStates>::Zero();
    Matrix<double, kCalibratedStates> covariance = Matrix<double, kCalibratedStates>::Zero();
};

}  // namespace pilotage
