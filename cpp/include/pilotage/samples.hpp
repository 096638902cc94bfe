#pragma once
/// \file
/// What enters the localizer, and the one order in which it is processed.

#include <cstdint>
#include <cstring>

namespace pilotage {

/// Kinds of samples, in the order in which samples of equal time are processed: a turn is known
/// before the motion that uses it, and what is measured at a motion sample's time sees the pose at
/// its end.
enum class Stream : std::uint8_t { reset, gyro, motion, sighting, fix, beam };

/// Absolute wheel counts [ticks].
struct EncoderTicks {
    std::int64_t left, right;

    [[nodiscard]] bool operator==(const EncoderTicks& other) const noexcept {
        return left == other.left && right == other.right;
    }
};

/// Mean yaw rate since the previous sample [rad/s].
struct GyroRate {
    double rate_rad_s;
};

/// Mean speed [m/s] and yaw rate [rad/s] since the previous sample.
struct BodyVelocity {
    double v_m_s, omega_rad_s;
};

inline constexpr std::int32_t kUnknownId = -1;  ///< of a sighting: its marker is to be found

/// One marker in one frame; NaN values were not measured, NaN sigmas are as configured.
/// Components in the order bearing [rad], elevation [rad], range [m]; of a sensor of pixels u, v
/// [px] (held_pixel.hpp).
struct Sighting {
    double value[3];
    double sigma[3];
    std::int32_t id;
    std::int32_t label;
};

/// The pose of a sensor as something else than markers tells it, or a part: (x [m], y [m], heading
/// [rad]), NaN where not measured. Covariance as (xx, yx, yy, hx, hy, hh); NaN: as configured.
struct Fix {
    double value[3];
    double covariance[6];
};

/// Range to a wall along a beam; NaN sigma: as configured.
struct Beam {
    double angle_rad, range_m, sigma_m;
};

/// A pose (x [m], y [m], heading [rad]) given from outside, with its covariance as
/// (xx, yx, yy, hx, hy, hh).
struct PoseReset {
    double pose[3];
    double covariance[6];
};

/// A sample at its own time. All bytes are set, so that equal samples are equal byte for byte.
struct Sample {
    std::int64_t utime;  ///< us, after the time policy
    std::int32_t seq;    ///< sender's count
    Stream stream;
    std::uint8_t source;  ///< sensor number, for sightings, fixes and beams
    std::uint16_t index;  ///< position in its message, for the same
    union Payload {
        EncoderTicks ticks;
        GyroRate gyro;
        BodyVelocity velocity;
        Sighting sighting;
        Fix fix;
        Beam beam;
        PoseReset reset;
    } payload;

    template <typename T>
    [[nodiscard]] static Sample make(std::int64_t utime, std::int32_t seq, Stream stream,
                                     const T& value, std::uint8_t source = 0,
                                     std::uint16_t index = 0) noexcept {
        static_assert(sizeof(T) <= sizeof(Payload));
        Sample sample;
        std::memset(static_cast<void*>(&sample), 0, sizeof(Sample));
        sample.utime = utime;
        sample.seq = seq;
        sample.stream = stream;
        sample.source = source;
        sample.index = index;
        std::memcpy(static_cast<void*>(&sample.payload), &value, sizeof(T));
        return sample;
    }

    /// Negative, zero or positive as this comes before, is the same as, or comes after `other`: by
    /// time, stream, seq, then the remaining bytes, never by arrival.
    [[nodiscard]] int compare(const Sample& other) const noexcept {
        if (utime != other.utime) return utime < other.utime ? -1 : 1;
        if (stream != other.stream) return stream < other.stream ? -1 : 1;
        if (seq != other.seq) return seq < other.seq ? -1 : 1;
        if (source != other.source) return source < other.source ? -1 : 1;
        if (index != other.index) return index < other.index ? -1 : 1;
        return std::memcmp(&payload, &other.payload, sizeof(Payload));
    }
};

/// Whether it is something that a sensor measured of the pose.
[[nodiscard]] constexpr bool is_measurement(Stream stream) noexcept {
    return stream == Stream::sighting || stream == Stream::fix || stream == Stream::beam;
}

/// Whether two were measured at once by one sensor.
[[nodiscard]] inline bool same_frame(const Sample& a, const Sample& b) noexcept {
    return a.utime == b.utime && a.stream == b.stream && is_measurement(a.stream) &&
           a.seq == b.seq && a.source == b.source;
}

}  // namespace pilotage
