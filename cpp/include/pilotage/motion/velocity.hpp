#pragma once
/// \file
/// A robot whose speed and yaw rate are known and held over a step.

#include "pilotage/motion/unicycle.hpp"

namespace pilotage {

/// u = (speed [m/s], yaw rate [rad/s]) over dt_s. The chord is the integrator: tangent is Euler's
/// method (eqs. 5 and 6 of Kohler), midpoint the second-order one, arc is exact.
///
/// With the gyro's rate in u, the compass as a HeadingFix and slip_angle_rad = -beta this is eqs.
/// 36 and 37 of Tamas et al. 2008: the course is the heading plus the slip angle.
template <typename Scalar, Chord kChord>
struct Velocity {
    Scalar dt_s;
    Scalar slip_angle_rad = 0;  ///< direction of travel relative to the heading

    [[nodiscard]] MotionStep<Scalar, 2> linearize(const Pose<Scalar>& x,
                                                  const Vector<Scalar, 2>& u) const noexcept {
        const Unicycle<Scalar, kChord> drive{slip_angle_rad};
        auto step = drive.linearize(x, Vector<Scalar, 2>(u * dt_s));
        step.b *= dt_s;
        return step;
    }
};

/// The same, exactly integrated, but its covariance moves by the transition matrix exp(A dt) of the
/// kinematics linearised at the start of the step with the input of the step: eqs. 4 to 7 of Sousa,
/// Costa, Moreira and Carvalho, "Self Localization of an Autonomous Robot: Using an EKF to merge
/// Odometry and Vision based Landmarks". The paper says of eq. 6 only t_k.
template <typename Scalar>
struct LinearizedVelocity {
    Scalar dt_s;

    [[nodiscard]] MotionStep<Scalar, 2> linearize(const Pose<Scalar>& x,
                                                  const Vector<Scalar, 2>& u) const noexcept {
        auto step = Velocity<Scalar, Chord::arc>{dt_s}.linearize(x, u);
        // A^2 = 0, so exp(A dt) = I + A dt, which is what Euler's step does to an error.
        step.a = Velocity<Scalar, Chord::tangent>{dt_s}.linearize(x, u).a;
        return step;
    }
};

}  // namespace pilotage
