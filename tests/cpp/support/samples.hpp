#pragma once
/// \file
/// Samples in one line each.

#include <limits>

#include "pilotage/samples.hpp"
#include "pilotage/state.hpp"

namespace pilotage::test {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInf = std::numeric_limits<double>::infinity();

[[nodiscard]] inline Sample encoders_at(std::int64_t utime, std::int64_t left, std::int64_t right,
                                        std::int32_t seq = 0) {
    return Sample::make(utime, seq, Stream::motion, EncoderTicks{left, right});
}

[[nodiscard]] inline Sample velocity_at(std::int64_t utime, double v_m_s, double omega_rad_s,
                                        std::int32_t seq = 0) {
    return Sample::make(utime, seq, Stream::motion, BodyVelocity{v_m_s, omega_rad_s});
}

[[nodiscard]] inline Sample gyro_at(std::int64_t utime, double rate_rad_s, std::int32_t seq = 0) {
    return Sample::make(utime, seq, Stream::gyro, GyroRate{rate_rad_s});
}

/// Components are (bearing, elevation, range), NaN where not measured; sigmas
/// are as configured.
[[nodiscard]] inline Sample sighting_at(std::int64_t utime, std::int32_t id,
                                        const Vector<double, 3>& measured,
                                        std::uint16_t index = 0) {
    const Sighting sighting{{measured[0], measured[1], measured[2]}, {kNan, kNan, kNan}, id, -1};
    return Sample::make(utime, 0, Stream::sighting, sighting, 0, index);
}

/// NaN where not measured; noise is as configured.
[[nodiscard]] inline Sample fix_at(std::int64_t utime, const Pose<double>& value,
                                   std::int32_t seq = 0) {
    return Sample::make(utime, seq, Stream::fix,
                        Fix{{value[0], value[1], value[2]}, {kNan, kNan, kNan, kNan, kNan, kNan}});
}

[[nodiscard]] inline Sample beam_at(std::int64_t utime, double angle_rad, double range_m,
                                    std::uint16_t index = 0) {
    return Sample::make(utime, 0, Stream::beam, Beam{angle_rad, range_m, kNan}, 0, index);
}

[[nodiscard]] inline Sample reset_at(std::int64_t utime, const Pose<double>& pose,
                                     const Vector<double, 3>& sigmas, std::int32_t seq = 0) {
    const PoseReset reset{
        {pose[0], pose[1], pose[2]},
        {sigmas[0] * sigmas[0], 0, sigmas[1] * sigmas[1], 0, 0, sigmas[2] * sigmas[2]}};
    return Sample::make(utime, seq, Stream::reset, reset);
}

/// For sets and sorting: the order in which samples are processed.
struct InOrder {
    bool operator()(const Sample& a, const Sample& b) const noexcept { return a.compare(b) < 0; }
};

}  // namespace pilotage::test
