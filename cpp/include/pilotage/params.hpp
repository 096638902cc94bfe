#pragma once
/// \file
/// Every parameter of the core with its one default. Names carry units; the configuration file uses
/// the same names (cpp/engine/config_schema.cpp lists them with their ranges and meaning).

#include <array>
#include <cstdint>
#include <limits>

#include "pilotage/filter/policy.hpp"
#include "pilotage/sensing/camera_model.hpp"

namespace pilotage {

/// Where the change of heading comes from.
enum class HeadingSource : unsigned char {
    gyro,    ///< from the gyro; from the wheels while the gyro is silent
    wheels,  ///< from the wheels (or the velocity message's omega)
    both,    ///< the inverse-variance mean of the two
};

/// Which message carries the motion.
enum class MotionSource : unsigned char { encoders, velocity };

/// How models are made linear.
enum class Filter : unsigned char {
    ekf,  ///< by their Jacobians at the estimate
    ukf,  ///< by their values at sigma points
};

struct WheelParams {
    double left_m_per_tick =
        0.001;  ///< negative where the encoder counts down when driving forward
    double right_m_per_tick = 0.001;  ///< likewise
    double track_width_m = 0.5;
    double max_speed_m_s = 10;  ///< ticks that imply more are a counter's wrap or reset
};

struct MotionParams {
    MotionSource source = MotionSource::encoders;
    HeadingSource heading = HeadingSource::gyro;
    double slip_angle_rad = 0;  ///< direction of travel relative to the heading
    double max_gap_s = 0.5;     ///< a rate sample holds for no longer than this
};

/// Whether noise is as configured, or the start of what innovations teach (noise_scale.hpp).
enum class NoiseAdaptation : unsigned char { off, on };

/// Noise grows with distance, turn and time, never with the number of samples.
struct NoiseParams {
    double wheel_m_per_sqrt_m =
        0.02;  ///< travel of each wheel; of a velocity message, sqrt(2) times its distance's
    double gyro_rad_per_sqrt_s = 0.002;    ///< turn by the gyro, or by a velocity message's omega
    double position_m_per_sqrt_m = 0.005;  ///< pose, per distance (wheel slip)
    double position_m_per_sqrt_s = 0;      ///< pose, per time
    double heading_rad_per_sqrt_m = 0;     ///< heading, per distance
    double heading_rad_per_sqrt_rad = 0;   ///< heading, per turn
    double heading_rad_per_sqrt_s = 0;     ///< heading, per time
    NoiseAdaptation adaptation = NoiseAdaptation::off;

    [[nodiscard]] bool adapts() const noexcept { return adaptation == NoiseAdaptation::on; }
};

/// A calibration state: frozen at its initial value where sigma is 0.
struct CalibrationParams {
    double initial = 0;
    double sigma = 0;  ///< of the initial value
    double walk =
        0;  ///< per root second (gyro bias), root metre (distance), root radian (rotation)
};

/// Pitch and roll of the body against the ground: Gauss-Markov states, zero on average. Elevations
/// suffer from them; without elevations they are not needed.
struct TiltParams {
    double pitch_sigma_rad = 0, roll_sigma_rad = 0;
    double tau_s = 0;  ///< correlation time; 0: new in every frame

    [[nodiscard]] bool any() const noexcept { return pitch_sigma_rad > 0 || roll_sigma_rad > 0; }
    /// Of an elevation to any side.
    [[nodiscard]] double variance_rad2() const noexcept {
        return pitch_sigma_rad * pitch_sigma_rad + roll_sigma_rad * roll_sigma_rad;
    }
};

/// What a sensor measures.
enum class Measures : unsigned char {
    markers,  ///< bearing, elevation and range of them, or some of these
    pose,     ///< its own position, its own heading, or both
    walls,    ///< range along beams to the walls of the map
    pixels,   ///< where markers are in a camera's image
};

/// One sensor: where it sits and how well it measures.
struct SensorParams {
    Measures measures = Measures::markers;
    double x_m = 0, y_m = 0, z_m = 0, yaw_rad = 0;  ///< mounting in the robot frame
    double sigma_bearing_rad = 0.02;
    double sigma_elevation_rad = 0.02;
    double sigma_range_m = 0.1;
    double sigma_range_per_m = 0;   ///< added to sigma_range_m in quadrature, times the range
    double range_scale = 1;         ///< reported over true range
    double range_offset_m = 0;      ///< reported at range zero
    double sigma_position_m = 0.1;  ///< of x and of y
    double sigma_heading_rad = 0.05;
    CameraModel camera;                   ///< of a sensor of pixels
    double sigma_pixel = 1;               ///< of u and of v [px]
    double association_radius_pixel = 0;  ///< 0: associated by likelihood, as other sightings are
    double min_distance_m = 0.05;         ///< nearer markers have no usable direction
    Fusion fusion = Fusion::student_t;
    double gate_false_reject = 0.001;
    double student_t_dof = 4;
};

/// Start of the filter; NaN: the pose is found from sightings, or set by a pose_reset_t.
struct InitialParams {
    double x_m = std::numeric_limits<double>::quiet_NaN();
    double y_m = std::numeric_limits<double>::quiet_NaN();
    double heading_rad = std::numeric_limits<double>::quiet_NaN();
    double sigma_position_m = 0.1;
    double sigma_heading_rad = 0.05235987755982989;  // 3 degrees
};

struct StatusParams {
    double alert_limit_m = 1.0;         ///< OK promises a 95 % radius below this
    double dead_reckoning_after_s = 5;  ///< without a sighting that agrees
    double lost_limit_m = 10;           ///< a 95 % radius above this is LOST
    double lost_after_s = 10;           ///< without motion samples
};

struct HistoryParams {
    double window_s = 2;  ///< a sample later than this is rejected
    int capacity = 2048;  ///< samples held; the window is shorter where more arrive
};

struct Params {
    static constexpr int kMaxSensors = 8;

    Filter filter = Filter::ekf;
    MotionParams motion;
    WheelParams wheels;
    NoiseParams noise;
    CalibrationParams gyro_bias{0, 0, 0};
    CalibrationParams distance_scale{1, 0, 0};
    CalibrationParams rotation_scale{1, 0, 0};
    TiltParams tilt;
    InitialParams initial;
    StatusParams status;
    HistoryParams history;
    int sensor_count = 0;
    std::array<SensorParams, kMaxSensors> sensors{};

    /// True where any calibration state may move, so that the filter needs six states.
    [[nodiscard]] bool calibrates() const noexcept {
        for (const CalibrationParams* c : {&gyro_bias, &distance_scale, &rotation_scale})
            if (c->sigma > 0 || c->walk > 0) return true;
        return false;
    }
};

}  // namespace pilotage
