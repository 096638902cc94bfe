#pragma once
/// \file
/// A robot to test on, what it measures on a drive, and where geometry says
/// that it is.

#include <cmath>
#include <cstdint>
#include <vector>

#include "pilotage/marker_map.hpp"
#include "pilotage/params.hpp"
#include "support/samples.hpp"
#include "support/units.hpp"

namespace pilotage::test {

inline constexpr std::int64_t kPeriod = 20'000;  // of the motion samples, us

/// Wheels of 1 mm a tick, 0.5 m apart, heading by the wheels, one sensor;
/// starts at the origin.
[[nodiscard]] inline Params plain_params() {
    Params params;
    params.motion.heading = HeadingSource::wheels;
    params.initial.x_m = params.initial.y_m = params.initial.heading_rad = 0;
    params.sensor_count = 1;
    return params;
}

/// The same with another heading.
[[nodiscard]] inline Params params_with(HeadingSource heading) {
    Params params = plain_params();
    params.motion.heading = heading;
    return params;
}

/// Markers all around; two of them were surveyed poorly.
inline const MarkerMap kSurveyedMarkers({{1, 6, 2, 0.4, 0.01},
                                         {2, -3, 5, 0, 0},
                                         {3, 4, -4, 0, 0.02}});

/// Looks the same from the other side.
inline const MarkerMap kRectangle(
    {{1, 5, 3, 0, 0}, {2, -5, 3, 0, 0}, {3, -5, -3, 0, 0}, {4, 5, -3, 0, 0}});

/// Encoder samples of `steps` periods with so many ticks in each, the first at
/// utime 0.
[[nodiscard]] inline std::vector<Sample> drive(int steps, int left_ticks, int right_ticks) {
    std::vector<Sample> samples;
    for (int i = 0; i <= steps; ++i)
        samples.push_back(encoders_at(i * kPeriod, std::int64_t{i} * left_ticks,
                                      std::int64_t{i} * right_ticks, i));
    return samples;
}

/// The pose after an arc from `start`, as a chord: not the way that the models
/// compute it.
[[nodiscard]] inline Pose<double> after_arc(const Pose<double>& start, double distance_m,
                                            double turn_rad) {
    const double to = start[kHeading] + turn_rad;
    if (turn_rad == 0)
        return {start[kX] + distance_m * std::cos(to), start[kY] + distance_m * std::sin(to), to};
    const double radius = distance_m / turn_rad;
    return {start[kX] + radius * (std::sin(to) - std::sin(start[kHeading])),
            start[kY] - radius * (std::cos(to) - std::cos(start[kHeading])), to};
}

/// What a sensor at a pose of the robot sees of a marker: (bearing, elevation,
/// range).
[[nodiscard]] inline Vector<double, 3> view(const Pose<double>& robot, const Marker& marker,
                                            const SensorParams& sensor = {}) {
    const double c = std::cos(robot[kHeading]), s = std::sin(robot[kHeading]);
    const double dx = marker.x_m - robot[kX] - c * sensor.x_m + s * sensor.y_m;
    const double dy = marker.y_m - robot[kY] - s * sensor.x_m - c * sensor.y_m;
    const double dz = marker.z_m - sensor.z_m;
    const double bearing = std::atan2(dy, dx) - robot[kHeading] - sensor.yaw_rad;
    return {std::remainder(bearing, 2 * kPi<double>), std::atan2(dz, std::hypot(dx, dy)),
            std::hypot(dx, dy, dz) * sensor.range_scale + sensor.range_offset_m};
}

/// Only some of the components.
[[nodiscard]] inline Vector<double, 3> only(const Vector<double, 3>& measured, bool bearing,
                                            bool elevation, bool range) {
    return {bearing ? measured[0] : kNan, elevation ? measured[1] : kNan,
            range ? measured[2] : kNan};
}

}  // namespace pilotage::test
