#pragma once
/// \file
/// Encoders as measurements of the velocities in the state.

#include "pilotage/sensing/measurement.hpp"
#include "pilotage/velocity_state.hpp"

namespace pilotage {

/// (left, right) travel [m] of a differential drive within dt_s: eqs. 19 and 20 of Kiriy and
/// Buehler 2002, solved for the wheels.
template <typename Scalar>
struct WheelTravel {
    static constexpr int kStates = kVelocityStates;
    using Values = Vector<Scalar, 2>;

    Scalar track_width_m, dt_s;

    [[nodiscard]] Measurement<Scalar, 2, kStates> linearize(
        const Vector<Scalar, kStates>& x) const noexcept {
        const Scalar half_track_m = track_width_m / 2;
        Measurement<Scalar, 2, kStates> h;
        h.jacobian << 0, 0, 0, dt_s, -half_track_m * dt_s,  //
            0, 0, 0, dt_s, half_track_m * dt_s;
        h.value = h.jacobian * x;
        return h;
    }

    [[nodiscard]] Values minus(const Values& z, const Values& predicted) const noexcept {
        return z - predicted;
    }
};

}  // namespace pilotage
