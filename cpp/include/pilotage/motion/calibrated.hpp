#pragma once
/// \file
/// Adds the calibration states to a motion model by the chain rule, so that Ekf<3> and Ekf<6> share models.

#include "pilotage/congruence.hpp"
#include "pilotage/state.hpp"

namespace pilotage {

/// Wraps a model with u = (distance, turn). With calibration c = (gyro bias, distance scale, rotation
/// scale) it drives the model with
///     distance' = distance_scale * distance
///     turn'     = rotation_scale * (turn - gyro_bias * gyro_time)
template <typename Model, typename Scalar>
struct Calibrated {
    Model model;
    Scalar gyro_time_s;  ///< time over which the gyro's bias entered the turn: dt times the gyro's share in it

    struct Step {
        Vector<Scalar, 6> next;
        CalibratedTransition<Scalar> a;
        Matrix<Scalar, 3, 2> b;
    };

    [[nodiscard]] Step linearize(const Vector<Scalar, 6>& x, const Vector<Scalar, 2>& u) const noexcept {
        const Scalar distance_scale = x[kDistanceScale], rotation_scale = x[kRotationScale];
        const Scalar unbiased_turn = u[1] - x[kGyroBias] * gyro_time_s;
        const Vector<Scalar, 2> driven(distance_scale * u[0], rotation_scale * unbiased_turn);
        const auto step = model.linearize(x.template head<3>(), driven);
        Step result;
        result.next << step.next, x.template tail<3>();
        result.a.shear = step.a;
        result.a.by_calibration.col(0) = step.b.col(1) * (-rotation_scale * gyro_time_s);
        result.a.by_calibration.col(1) = step.b.col(0) * u[0];
        result.a.by_calibration.col(2) = step.b.col(1) * unbiased_turn;
        result.b.col(0) = step.b.col(0) * distance_scale;
        result.b.col(1) = step.b.col(1) * rotation_scale;
        return result;
    }
};

}  // namespace pilotage
