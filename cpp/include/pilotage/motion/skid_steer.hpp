#pragma once
/// \file
/// Robots that move sideways as well: by their velocity in the robot frame, and skid-steered ones,
/// whose wheels decide it by coefficients of the ground.

#include "pilotage/motion/unicycle.hpp"

namespace pilotage {

/// u = (forward [m/s], leftward [m/s], yaw rate [rad/s]) in the robot frame, held over dt_s and
/// integrated exactly.
template <typename Scalar>
struct PlanarVelocity {
    Scalar dt_s;

    [[nodiscard]] MotionStep<Scalar, 3> linearize(const Pose<Scalar>& x,
                                                  const Vector<Scalar, 3>& u) const noexcept {
        using Arc = Unicycle<Scalar, Chord::arc>;
        const Vector<Scalar, 3> driven = u * dt_s;
        // The displacement is linear in both velocities: a forward and a leftward arc of one turn.
        const auto forward = Arc{}.linearize(x, {driven[0], driven[2]});
        const auto leftward = Arc{kPi<Scalar> / 2}.linearize(x, {driven[1], driven[2]});
        MotionStep<Scalar, 3> step;
        step.next = {forward.next[kX] + leftward.a.dx, forward.next[kY] + leftward.a.dy,
                     forward.next[kHeading]};
        step.a = {forward.a.dx + leftward.a.dx, forward.a.dy + leftward.a.dy};
        step.b << forward.b.col(0), leftward.b.col(0), forward.b.col(1) + leftward.b.col(1);
        step.b(kHeading, 2) = 1;
        step.b *= dt_s;
        return step;
    }
};

/// u = (right, left) speed of the wheels [m/s]. Eqs. 29 and 30 of L. Tamas et al., "State
/// Estimation Based on Kalman Filtering Techniques in Navigation", 2008, after Anousaki and
/// Kyriakopoulos.
template <typename Scalar>
struct SkidSteer {
    /// a_ij of eq. 30: forward [1], leftward [1] and yaw rate [rad/m] by (right, left). A
    /// differential drive of track width b has [1/2 1/2; 0 0; 1/b -1/b].
    Matrix<Scalar, 3, 2> coefficients;
    Scalar dt_s;

    [[nodiscard]] MotionStep<Scalar, 2> linearize(const Pose<Scalar>& x,
                                                  const Vector<Scalar, 2>& u) const noexcept {
        const PlanarVelocity<Scalar> body{dt_s};
        const auto step = body.linearize(x, Vector<Scalar, 3>(coefficients * u));
        return {step.next, step.a, step.b * coefficients};
    }
};

}  // namespace pilotage
