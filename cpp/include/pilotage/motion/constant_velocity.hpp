#pragma once
/// \file
/// Velocities in the state, as Kiriy and Buehler 2002 wish for in their conclusion: wheels and gyro
/// are then measurements, and what moves the state is noise.

#include "pilotage/motion/velocity.hpp"
#include "pilotage/velocity_state.hpp"

namespace pilotage {

/// State (pose, speed, yaw rate); u = (acceleration [m/s^2], yaw acceleration [rad/s^2]), normally
/// zero, so that its covariance is the process noise. Both are held over dt_s; for u = 0 the pose
/// moves along the exact arc.
template <typename Scalar>
struct ConstantVelocity {
    Scalar dt_s;

    struct Step {
        Vector<Scalar, kVelocityStates> next;
        Matrix<Scalar, kVelocityStates> a;
        Matrix<Scalar, kVelocityStates, 2> b;
    };

    [[nodiscard]] Step linearize(const Vector<Scalar, kVelocityStates>& x,
                                 const Vector<Scalar, 2>& u) const noexcept {
        using Square = Matrix<Scalar, 2>;
        const Scalar half_s = dt_s / 2;
        const Vector<Scalar, 2> velocity = x.template tail<2>();
        const Vector<Scalar, 2> mean_velocity = velocity + half_s * u;
        const auto drive = Velocity<Scalar, Chord::arc>{dt_s}.linearize(
            x.template head<kPoseStates>(), mean_velocity);
        Step step;
        step.next << drive.next, velocity + dt_s * u;
        step.a << drive.a.dense(), drive.b, Matrix<Scalar, 2, 3>::Zero(), Square::Identity();
        step.b << half_s * drive.b, dt_s * Square::Identity();
        return step;
    }
};

}  // namespace pilotage
