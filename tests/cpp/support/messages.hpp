#pragma once
/// \file
/// LCM messages in one line each.

#include <cmath>
#include <string>
#include <vector>

#include "engine/checkpoint_file.hpp"
#include "engine/codecs.hpp"
#include "pilotage/encoders_t.hpp"
#include "pilotage/gyro_t.hpp"
#include "pilotage/heading_t.hpp"
#include "pilotage/marker_frame_t.hpp"
#include "pilotage/pixel_frame_t.hpp"
#include "pilotage/pose_fix_t.hpp"
#include "pilotage/pose_reset_t.hpp"
#include "pilotage/position_fix_t.hpp"
#include "pilotage/reference_t.hpp"
#include "pilotage/tick_t.hpp"
#include "pilotage/velocity_t.hpp"
#include "pilotage/wall_range_t.hpp"

namespace pilotage::test {

template <typename Message>
[[nodiscard]] Bytes bytes_of(const Message& message) {
    Bytes bytes;
    encode(message, bytes);
    return bytes;
}

[[nodiscard]] inline encoders_t encoders(std::int64_t utime, std::int64_t left, std::int64_t right,
                                         std::int32_t seq = 0) {
    encoders_t m{};
    m.utime = utime;
    m.seq = seq;
    m.left = left;
    m.right = right;
    return m;
}

[[nodiscard]] inline velocity_t velocity(std::int64_t utime, double v, double omega) {
    velocity_t m{};
    m.utime = utime;
    m.v = v;
    m.omega = omega;
    return m;
}

[[nodiscard]] inline gyro_t gyro(std::int64_t utime, double rate, std::int32_t seq = 0) {
    gyro_t m{};
    m.utime = utime;
    m.seq = seq;
    m.rate = rate;
    return m;
}

[[nodiscard]] inline marker_sighting_t seen(std::int32_t id, double bearing, double elevation = NAN,
                                            double range = NAN) {
    return {id, -1, bearing, elevation, range, NAN, NAN, NAN};
}

[[nodiscard]] inline marker_frame_t frame(std::int64_t utime, const std::string& sensor,
                                          const std::vector<marker_sighting_t>& sightings,
                                          std::int32_t seq = 0) {
    marker_frame_t m{};
    m.utime = utime;
    m.seq = seq;
    m.sensor = sensor;
    m.n = static_cast<std::int32_t>(sightings.size());
    m.sightings = sightings;
    return m;
}

[[nodiscard]] inline pixel_observation_t spotted(std::int32_t id, double u, double v,
                                                 double sigma = NAN) {
    return {id, -1, u, v, sigma, sigma};
}

[[nodiscard]] inline pixel_frame_t pixels(std::int64_t utime, const std::string& sensor,
                                          const std::vector<pixel_observation_t>& observations,
                                          std::int32_t seq = 0) {
    pixel_frame_t m{};
    m.utime = utime;
    m.seq = seq;
    m.sensor = sensor;
    m.n = static_cast<std::int32_t>(observations.size());
    m.observations = observations;
    return m;
}

[[nodiscard]] inline pose_reset_t reset(std::int64_t utime, double x, double y, double heading,
                                        double variance = 0.01) {
    pose_reset_t m{};
    m.utime = utime;
    m.x = x;
    m.y = y;
    m.heading = heading;
    m.covariance[0] = m.covariance[4] = m.covariance[8] = variance;
    return m;
}

[[nodiscard]] inline heading_t heading(std::int64_t utime, const std::string& sensor,
                                       double heading, double sigma = NAN, std::int32_t seq = 0) {
    heading_t m{};
    m.utime = utime;
    m.seq = seq;
    m.sensor = sensor;
    m.heading = heading;
    m.sigma = sigma;
    return m;
}

[[nodiscard]] inline position_fix_t position_fix(std::int64_t utime, const std::string& sensor,
                                                 double x, double y, double variance = NAN,
                                                 std::int32_t seq = 0) {
    position_fix_t m{};
    m.utime = utime;
    m.seq = seq;
    m.sensor = sensor;
    m.x = x;
    m.y = y;
    m.covariance[0] = m.covariance[3] = variance;
    m.covariance[1] = m.covariance[2] = variance * 0;
    return m;
}

[[nodiscard]] inline pose_fix_t pose_fix(std::int64_t utime, const std::string& sensor, double x,
                                         double y, double heading, double variance = NAN,
                                         std::int32_t seq = 0) {
    pose_fix_t m{};
    m.utime = utime;
    m.seq = seq;
    m.sensor = sensor;
    m.x = x;
    m.y = y;
    m.heading = heading;
    for (int i = 0; i < 9; ++i) m.covariance[i] = i % 4 == 0 ? variance : variance * 0;
    return m;
}

[[nodiscard]] inline wall_range_t wall_ranges(std::int64_t utime, const std::string& sensor,
                                              const std::vector<double>& angles,
                                              const std::vector<double>& ranges, double sigma = NAN,
                                              std::int32_t seq = 0) {
    wall_range_t m{};
    m.utime = utime;
    m.seq = seq;
    m.sensor = sensor;
    m.n = static_cast<std::int32_t>(angles.size());
    m.angle = angles;
    m.range = ranges;
    m.sigma.assign(angles.size(), sigma);
    return m;
}

[[nodiscard]] inline reference_t reference(std::int64_t utime, double x, double y, double heading) {
    reference_t m{};
    m.utime = utime;
    m.x = x;
    m.y = y;
    m.heading = heading;
    return m;
}

[[nodiscard]] inline tick_t tick(std::int64_t utime, std::int64_t drops = 0) {
    tick_t m{};
    m.utime = utime;
    m.drops = drops;
    return m;
}

}  // namespace pilotage::test
