#pragma once
/// \file
/// Adds the calibration states to a motion model by the chain rule, so that Ekf<3> and Ekf<6> share
/// models.

#include "pilotage/congruence.hpp"
#include "pilotage/state.hpp"

namespace pilotage {

/// Wraps a model with u = (distance, turn). With calibration c = (gyro bias, distance scale,
/// rotation scale) it drives the model with
///     distance' = distance_scale * distance
///     turn'     = rotation_scale * (turn - gyro_bias * gyro_time)
template <typename Model, typename Scalar>
struct Calibrated {
    Model model;
    Scalar gyro_time_s;  ///< time over which the gyro's bias entered the turn: dt times the gyro's
                         ///< share in it

    struct Step {
        Vector<Scalar, 6> next;
        CalibratedTransition<Scalar> a;
        Matrix<Scalar, 3, 2> b;
    };

    [[nodiscard]] Step linearize(const Vector<Scalar, 6>& x,
                                 const Vector<Scalar, 2>& u) const noexcept {
        const Scalar distance_scale = x[kDistanceScale], rotation_scale = x[kRotationScale];
        const Scalar unbiased_turn = u[1] - x[kGyroBias] * gyro_time_s;
        const Vector<Scalar, 2> driven(distance_scale * u[0], rotation_scale * unbiased_turn);
        const auto step = model.linearize(x.template head<3>(), driven);
        Step result;
        each<3>([&](int i) {
            result.next[i] = step.next[i];
            result.next[kPoseStates + i] = x[kPoseStates + i];
            const Scalar by_distance = step.b(i, 0), by_turn = step.b(i, 1);
            result.a.by_calibration(i, 0) = times(-rotation_scale * gyro_time_s, by_turn);
            result.a.by_calibration(i, 1) = times(u[0], by_distance);
            result.a.by_calibration(i, 2) = times(unbiased_turn, by_turn);
            result.b(i, 0) = times(distance_scale, by_distance);
            result.b(i, 1) = times(rotation_scale, by_turn);
        });
        result.a.shear = step.a;
        return result;
    }
};

}  // namespace pilotage
