#pragma once
/// \file
/// From samples to what the motion model is driven with: a distance and a turn, with their
/// covariance.

#include <cmath>

#include "pilotage/params.hpp"
#include "pilotage/samples.hpp"
#include "pilotage/state.hpp"

namespace pilotage {

/// Motion over an interval, as measured.
template <typename Scalar>
struct Increment {
    Scalar dt_s = 0;
    Scalar distance_m = 0;
    Scalar turn_rad = 0;
    Matrix<Scalar, 2> covariance = Matrix<Scalar, 2>::Zero();  ///< of (distance, turn)
    Scalar gyro_share = 0;  ///< weight of the gyro in the turn, in [0, 1]
    /// Variances of the pose for what `covariance` does not tell of: roughness, slip, gaps, being
    /// carried.
    Pose<Scalar> process_noise = Pose<Scalar>::Zero();
    bool still = false;  ///< the robot stood: time alone makes its pose no less sure

    /// The first `fraction` of it; noise is in proportion to what was driven.
    [[nodiscard]] Increment part(Scalar fraction) const noexcept {
        return {dt_s * fraction,
                distance_m * fraction,
                turn_rad * fraction,
                Matrix<Scalar, 2>(covariance * fraction),
                gyro_share,
                Pose<Scalar>(process_noise * fraction),
                still};
    }
};

/// Travel of both wheels: eqs. 19 and 20 of Kiriy and Buehler 2002, and their covariance for wheels
/// whose noise variance grows with their own travel.
template <typename Scalar>
[[nodiscard]] Increment<Scalar> from_wheels(Scalar left_m, Scalar right_m, Scalar dt_s,
                                            Scalar track_width_m,
                                            const NoiseParams& noise) noexcept {
    using std::abs;
    const Scalar per_m = Scalar(noise.wheel_m_per_sqrt_m * noise.wheel_m_per_sqrt_m);
    const Scalar left_variance = per_m * abs(left_m), right_variance = per_m * abs(right_m);
    const Scalar sum = left_variance + right_variance;
    const Scalar cross = (right_variance - left_variance) / (2 * track_width_m);
    Increment<Scalar> u;
    u.dt_s = dt_s;
    u.distance_m = (right_m + left_m) / 2;
    u.turn_rad = (right_m - left_m) / track_width_m;
    u.covariance << sum / 4, cross, cross, sum / (track_width_m * track_width_m);
    return u;
}

/// Speed and yaw rate held over the interval. The turn's noise is a rate sensor's.
template <typename Scalar>
[[nodiscard]] Increment<Scalar> from_velocity(Scalar v_m_s, Scalar omega_rad_s, Scalar dt_s,
                                              const NoiseParams& noise) noexcept {
    using std::abs;
    Increment<Scalar> u;
    u.dt_s = dt_s;
    u.distance_m = v_m_s * dt_s;
    u.turn_rad = omega_rad_s * dt_s;
    const auto per_m = Scalar(noise.wheel_m_per_sqrt_m * noise.wheel_m_per_sqrt_m);
    const auto per_s = Scalar(noise.gyro_rad_per_sqrt_s * noise.gyro_rad_per_sqrt_s);
    u.covariance << per_m * abs(u.distance_m) / 2, 0, 0, per_s * dt_s;
    u.gyro_share = 1;
    return u;
}

/// Takes the turn from the gyro, or from both by inverse variance.
template <typename Scalar>
void take_turn(Increment<Scalar>& u, Scalar gyro_turn_rad, HeadingSource source,
               const NoiseParams& noise) noexcept {
    const Scalar gyro_variance =
        Scalar(noise.gyro_rad_per_sqrt_s * noise.gyro_rad_per_sqrt_s) * u.dt_s;
    const Scalar wheel_variance = u.covariance(1, 1), sum = gyro_variance + wheel_variance;
    const Scalar share =
        source == HeadingSource::gyro ? Scalar(1) : (sum > 0 ? wheel_variance / sum : Scalar(0.5));
    u.turn_rad += share * (gyro_turn_rad - u.turn_rad);
    u.covariance(1, 1) = share * share * gyro_variance + (1 - share) * (1 - share) * wheel_variance;
    u.covariance(0, 1) *= 1 - share;
    u.covariance(1, 0) *= 1 - share;
    u.gyro_share = share + (1 - share) * u.gyro_share;
}

/// The same interval of a robot that stood, whatever the gyro says.
template <typename Scalar>
[[nodiscard]] Increment<Scalar> standstill(const Increment<Scalar>& u) noexcept {
    Increment<Scalar> still;
    still.dt_s = u.dt_s;
    still.still = true;
    return still;
}

/// Process noise of the pose on even ground: a part grows with distance and turn, the rest with
/// time.
template <typename Scalar>
[[nodiscard]] Pose<Scalar> pose_process_noise(const Increment<Scalar>& u,
                                              const NoiseParams& noise) noexcept {
    using std::abs;
    const auto variance = [](double sigma, Scalar amount) {
        return Scalar(sigma * sigma) * amount;
    };
    const Scalar driven = abs(u.distance_m), turned = abs(u.turn_rad);
    const Scalar time_s = u.still ? Scalar(0) : u.dt_s;
    const Scalar position = variance(noise.position_m_per_sqrt_m, driven) +
                            variance(noise.position_m_per_sqrt_s, time_s);
    const Scalar heading = variance(noise.heading_rad_per_sqrt_m, driven) +
                           variance(noise.heading_rad_per_sqrt_rad, turned) +
                           variance(noise.heading_rad_per_sqrt_s, time_s);
    return {position, position, heading};
}

/// The same motion, the variances of its noise times a factor; slip, gaps and being carried stay as
/// they are.
template <typename Scalar>
[[nodiscard]] Increment<Scalar> with_noise_times(Scalar factor, Increment<Scalar> u,
                                                 const NoiseParams& noise) noexcept {
    u.covariance *= factor;
    u.process_noise += (factor - 1) * pose_process_noise(u, noise);
    return u;
}

/// Random walk of (gyro bias, distance scale, rotation scale).
template <typename Scalar>
[[nodiscard]] Vector<Scalar, 3> calibration_process_noise(const Increment<Scalar>& u,
                                                          const Params& params) noexcept {
    using std::abs;
    const auto variance = [](double sigma, Scalar amount) {
        return Scalar(sigma * sigma) * amount;
    };
    return {variance(params.gyro_bias.walk, u.dt_s),
            variance(params.distance_scale.walk, abs(u.distance_m)),
            variance(params.rotation_scale.walk, abs(u.turn_rad))};
}

}  // namespace pilotage
