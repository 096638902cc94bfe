#pragma once
/// \file
/// Moves the estimate by what wheels and gyro measured.

#include "pilotage/filter/ekf.hpp"
#include "pilotage/motion/calibrated.hpp"
#include "pilotage/motion/increment.hpp"
#include "pilotage/motion/unicycle.hpp"
#include "pilotage/params.hpp"

namespace pilotage {

/// Start of the filter at a pose: calibration at its configured initial values.
/// \param pose_covariance of (x, y, heading)
template <typename Scalar, int N>
[[nodiscard]] Ekf<Scalar, N> start_filter(const Pose<Scalar>& pose,
                                          const Matrix<Scalar, 3>& pose_covariance,
                                          const Params& params) noexcept {
    Vector<Scalar, N> x;
    Matrix<Scalar, N> p = Matrix<Scalar, N>::Zero();
    x.template head<3>() = pose;
    x[kHeading] = wrap(x[kHeading]);
    p.template topLeftCorner<3, 3>() = pose_covariance;
    if constexpr (N >= kCalibratedStates) {
        int i = kGyroBias;
        for (const CalibrationParams* c :
             {&params.gyro_bias, &params.distance_scale, &params.rotation_scale}) {
            x[i] = Scalar(c->initial);
            p(i, i) = Scalar(c->sigma * c->sigma);
            ++i;
        }
    }
    if constexpr (N == kTiltedStates) {
        x[kPitch] = x[kRoll] = 0;
        p(kPitch, kPitch) = Scalar(params.tilt.pitch_sigma_rad * params.tilt.pitch_sigma_rad);
        p(kRoll, kRoll) = Scalar(params.tilt.roll_sigma_rad * params.tilt.roll_sigma_rad);
    }
    return Ekf<Scalar, N>(x, p);
}

/// (distance [m], turn [rad]) of an increment after calibration, by the state or, frozen, by the
/// configuration.
template <typename Scalar, int N>
[[nodiscard]] Vector<Scalar, 2> calibrated_motion(const Vector<Scalar, N>& x,
                                                  const Increment<Scalar>& u,
                                                  const Params& params) noexcept {
    Vector<Scalar, 3> c(Scalar(params.gyro_bias.initial), Scalar(params.distance_scale.initial),
                        Scalar(params.rotation_scale.initial));
    if constexpr (N >= kCalibratedStates) c = x.template segment<3>(kGyroBias);
    return {c[1] * u.distance_m, c[2] * (u.turn_rad - c[0] * u.dt_s * u.gyro_share)};
}

/// Exact arcs, so that a step which is cut at a sighting ends where the whole step ends.
template <typename Scalar>
using RobotMotion = Unicycle<Scalar, Chord::arc>;

/// What a time update takes.
template <typename Model, typename Scalar, int N>
struct Motion {
    Model model;
    Vector<Scalar, 2> u;
    Matrix<Scalar, 2> gamma;
    Vector<Scalar, N> q;
};

/// Motion of a pose by an increment as measured, with the configured, frozen calibration.
template <typename Scalar>
[[nodiscard]] Motion<RobotMotion<Scalar>, Scalar, kPoseStates> motion_of(
    const Vector<Scalar, kPoseStates>& x, const Increment<Scalar>& u,
    const Params& params) noexcept {
    const Vector<Scalar, 2> scale(Scalar(params.distance_scale.initial),
                                  Scalar(params.rotation_scale.initial));
    Matrix<Scalar, 2> gamma;
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) gamma(i, j) = scale[i] * u.covariance(i, j) * scale[j];
    return {{Scalar(params.motion.slip_angle_rad)},
            calibrated_motion(x, u, params),
            gamma,
            u.process_noise};
}

/// With the calibration of the state.
template <typename Scalar>
[[nodiscard]] auto motion_of(const Vector<Scalar, kCalibratedStates>&, const Increment<Scalar>& u,
                             const Params& params) noexcept {
    using Model = Calibrated<RobotMotion<Scalar>, Scalar>;
    Vector<Scalar, kCalibratedStates> q;
    q << u.process_noise, calibration_process_noise(u, params);
    return Motion<Model, Scalar, kCalibratedStates>{
        Model{{Scalar(params.motion.slip_angle_rad)}, u.dt_s * u.gyro_share},
        Vector<Scalar, 2>(u.distance_m, u.turn_rad), u.covariance, q};
}

/// A model of the first states alone; the others stay.
template <typename Model, typename Scalar, int N>
struct Keeping {
    Model model;

    [[nodiscard]] auto linearize(const Vector<Scalar, N>& x,
                                 const Vector<Scalar, 2>& u) const noexcept {
        constexpr int moved = kCalibratedStates;
        const auto step = model.linearize(x.template head<moved>(), u);
        struct {
            Vector<Scalar, N> next;
            decltype(step.a) a;
            decltype(step.b) b;
        } result{x, step.a, step.b};
        result.next.template head<moved>() = step.next;
        return result;
    }
};

/// The same where the body tilts: on the way from one frame to the next its tilt stays, see
/// `settle_tilt`.
template <typename Scalar>
[[nodiscard]] auto motion_of(const Vector<Scalar, kTiltedStates>& x, const Increment<Scalar>& u,
                             const Params& params) noexcept {
    const auto level = motion_of(
        Vector<Scalar, kCalibratedStates>(x.template head<kCalibratedStates>()), u, params);
    using Model = Keeping<decltype(level.model), Scalar, kTiltedStates>;
    Vector<Scalar, kTiltedStates> q;
    q << level.q, 0, 0;
    return Motion<Model, Scalar, kTiltedStates>{{level.model}, level.u, level.gamma, q};
}

/// Time update by an increment as measured.
template <typename Scalar, int N>
void dead_reckon(Ekf<Scalar, N>& filter, const Increment<Scalar>& u,
                 const Params& params) noexcept {
    const auto motion = motion_of(filter.state(), u, params);
    filter.predict(motion.model, motion.u, motion.gamma, motion.q);
}

}  // namespace pilotage
