#include "codecs.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

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

namespace pilotage {

namespace {

template <typename Message>
bool read(const std::uint8_t* data, std::size_t size, Message& message) {
    if (size > static_cast<std::size_t>(std::numeric_limits<int>::max())) return false;
    return message.decode(data, 0, static_cast<int>(size)) == static_cast<int>(size);
}

/// For a message that is one sample.
template <typename Message, typename Convert>
bool decode_one(const std::uint8_t* data, std::size_t size, Decoded& out, Stream stream,
                Convert convert) {
    Message message{};
    if (!read(data, size, message)) return false;
    out.utime = message.utime;
    out.seq = message.seq;
    out.samples.push_back(Sample::make(message.utime, message.seq, stream, convert(message)));
    return true;
}

bool decode_encoders(const std::uint8_t* data, std::size_t size, Decoded& out) {
    return decode_one<encoders_t>(data, size, out, Stream::motion, [](const encoders_t& m) {
        return EncoderTicks{m.left, m.right};
    });
}

bool decode_gyro(const std::uint8_t* data, std::size_t size, Decoded& out) {
    return decode_one<gyro_t>(data, size, out, Stream::gyro,
                              [](const gyro_t& m) { return GyroRate{m.rate}; });
}

bool decode_velocity(const std::uint8_t* data, std::size_t size, Decoded& out) {
    return decode_one<velocity_t>(data, size, out, Stream::motion,
                                  [](const velocity_t& m) { return BodyVelocity{m.v, m.omega}; });
}

bool decode_reset(const std::uint8_t* data, std::size_t size, Decoded& out) {
    return decode_one<pose_reset_t>(data, size, out, Stream::reset, [](const pose_reset_t& m) {
        const double* p = m.covariance;
        return PoseReset{{m.x, m.y, m.heading}, {p[0], p[3], p[4], p[6], p[7], p[8]}};
    });
}

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

constexpr std::size_t kNameAt = 8 + 8 + 4;  // after fingerprint, utime and seq

/// A number in front of an array; what it counts may not be there.
bool read_count(const std::uint8_t* data, std::size_t size, std::size_t at, std::int32_t& count) {
    return at + 4 <= size && size <= static_cast<std::size_t>(std::numeric_limits<int>::max()) &&
           __int32_t_decode_array(data, static_cast<int>(at), 4, &count, 1) == 4 && count >= 0;
}

/// Where the name of a message's sensor ends; 0 where the message ends before.
std::size_t end_of_name(const std::uint8_t* data, std::size_t size) {
    std::int32_t length = 0;
    if (!read_count(data, size, kNameAt, length) || length < 1) return 0;
    const std::size_t end = kNameAt + 4 + static_cast<std::size_t>(length);
    return end <= size ? end : 0;
}

/// For a message of a sensor.
template <typename Message>
bool read_named(const std::uint8_t* data, std::size_t size, Message& message, Decoded& out) {
    if (end_of_name(data, size) == 0 || !read(data, size, message)) return false;
    out.utime = message.utime;
    out.seq = message.seq;
    out.sensor = message.sensor;
    return true;
}

/// The same with an array of `bytes` each: a count that the message cannot hold would make the
/// generated decoder allocate gigabytes.
template <typename Message>
bool read_list(const std::uint8_t* data, std::size_t size, std::size_t bytes, Message& message,
               Decoded& out) {
    std::int32_t count = 0;
    return read_count(data, size, end_of_name(data, size), count) &&
           static_cast<std::size_t>(count) <= size / bytes &&
           count <= std::numeric_limits<std::uint16_t>::max() &&
           read_named(data, size, message, out);
}

bool decode_frame(const std::uint8_t* data, std::size_t size, Decoded& out) {
    marker_frame_t message;
    if (!read_list(data, size, 2 * 4 + 6 * 8, message, out)) return false;
    for (std::size_t i = 0; i < message.sightings.size(); ++i) {
        const marker_sighting_t& s = message.sightings[i];
        const Sighting sighting{{s.bearing, s.elevation, s.range},
                                {s.sigma_bearing, s.sigma_elevation, s.sigma_range},
                                s.id,
                                s.label};
        out.samples.push_back(Sample::make(message.utime, message.seq, Stream::sighting, sighting,
                                           0, static_cast<std::uint16_t>(i)));
    }
    return true;
}

bool decode_pixels(const std::uint8_t* data, std::size_t size, Decoded& out) {
    pixel_frame_t message;
    if (!read_list(data, size, 2 * 4 + 4 * 8, message, out)) return false;
    for (std::size_t i = 0; i < message.observations.size(); ++i) {
        const pixel_observation_t& o = message.observations[i];
        const Sighting pixel{{o.u, o.v, kNone}, {o.sigma_u, o.sigma_v, kNone}, o.id, o.label};
        out.samples.push_back(Sample::make(message.utime, message.seq, Stream::sighting, pixel, 0,
                                           static_cast<std::uint16_t>(i)));
    }
    return true;
}

bool decode_walls(const std::uint8_t* data, std::size_t size, Decoded& out) {
    wall_range_t message;
    if (!read_list(data, size, 3 * 8, message, out)) return false;
    for (std::size_t i = 0; i < message.range.size(); ++i) {
        if (std::isnan(message.range[i])) continue;
        const Beam beam{message.angle[i], message.range[i], message.sigma[i]};
        out.samples.push_back(Sample::make(message.utime, message.seq, Stream::beam, beam, 0,
                                           static_cast<std::uint16_t>(i)));
    }
    return true;
}

/// For a message that is one fix.
template <typename Message, typename Convert>
bool decode_fix(const std::uint8_t* data, std::size_t size, Decoded& out, Convert convert) {
    Message message{};
    if (!read_named(data, size, message, out)) return false;
    const Fix fix = convert(message);
    out.samples.push_back(Sample::make(message.utime, message.seq, Stream::fix, fix));
    return true;
}

bool decode_heading(const std::uint8_t* data, std::size_t size, Decoded& out) {
    return decode_fix<heading_t>(data, size, out, [](const heading_t& m) {
        // The square would hide the sign of a sigma that is none.
        const double variance = m.sigma > 0 ? m.sigma * m.sigma : m.sigma;
        return Fix{{kNone, kNone, m.heading}, {kNone, kNone, kNone, kNone, kNone, variance}};
    });
}

bool decode_position(const std::uint8_t* data, std::size_t size, Decoded& out) {
    return decode_fix<position_fix_t>(data, size, out, [](const position_fix_t& m) {
        const double* p = m.covariance;
        return Fix{{m.x, m.y, kNone}, {p[0], p[2], p[3], kNone, kNone, kNone}};
    });
}

bool decode_pose_fix(const std::uint8_t* data, std::size_t size, Decoded& out) {
    return decode_fix<pose_fix_t>(data, size, out, [](const pose_fix_t& m) {
        const double* p = m.covariance;
        return Fix{{m.x, m.y, m.heading}, {p[0], p[3], p[4], p[6], p[7], p[8]}};
    });
}

bool decode_reference(const std::uint8_t* data, std::size_t size, Decoded& out) {
    reference_t message;
    if (!read(data, size, message)) return false;
    out.utime = message.utime;
    out.seq = message.seq;
    out.reference[0] = message.x;
    out.reference[1] = message.y;
    out.reference[2] = message.heading;
    return true;
}

bool decode_tick(const std::uint8_t* data, std::size_t size, Decoded& out) {
    tick_t message;
    if (!read(data, size, message)) return false;
    out.utime = message.utime;
    out.seq = message.seq;
    out.drops = message.drops;
    return true;
}

/// The M-Bot's encoders (MAEBOT_ENCODERS): int64 utime, int32 left, int32 right; no seq.
std::int64_t maebot_encoders_fingerprint() {
    return 0x7d090bfb221d74f9;
}

bool decode_maebot_encoders(const std::uint8_t* data, std::size_t size, Decoded& out) {
    std::int32_t ticks[2];
    if (size != 24 || __int64_t_decode_array(data, 8, 8, &out.utime, 1) < 0 ||
        __int32_t_decode_array(data, 16, 8, ticks, 2) < 0)
        return false;
    out.seq = 0;
    out.samples.push_back(
        Sample::make(out.utime, 0, Stream::motion, EncoderTicks{ticks[0], ticks[1]}));
    return true;
}

const std::vector<Codec>& codecs() {
    static const std::vector<Codec> table = {
        {&encoders_t::getHash, "encoders_t", Kind::encoders, &decode_encoders},
        {&velocity_t::getHash, "velocity_t", Kind::velocity, &decode_velocity},
        {&gyro_t::getHash, "gyro_t", Kind::gyro, &decode_gyro},
        {&marker_frame_t::getHash, "marker_frame_t", Kind::frame, &decode_frame},
        {&pixel_frame_t::getHash, "pixel_frame_t", Kind::pixels, &decode_pixels},
        {&pose_fix_t::getHash, "pose_fix_t", Kind::fix, &decode_pose_fix},
        {&position_fix_t::getHash, "position_fix_t", Kind::fix, &decode_position},
        {&heading_t::getHash, "heading_t", Kind::fix, &decode_heading},
        {&wall_range_t::getHash, "wall_range_t", Kind::walls, &decode_walls},
        {&pose_reset_t::getHash, "pose_reset_t", Kind::reset, &decode_reset},
        {&reference_t::getHash, "reference_t", Kind::reference, &decode_reference},
        {&tick_t::getHash, "tick_t", Kind::tick, &decode_tick},
        {&maebot_encoders_fingerprint, "maebot encoders", Kind::encoders, &decode_maebot_encoders},
    };
    return table;
}

}  // namespace

const Codec* find_codec(std::int64_t fingerprint) {
    for (const Codec& codec : codecs())
        if (codec.fingerprint() == fingerprint) return &codec;
    return nullptr;
}

std::int64_t fingerprint_of(const std::uint8_t* data, std::size_t size) noexcept {
    std::uint64_t value = 0;
    if (size < 8) return 0;
    for (int i = 0; i < 8; ++i) value = value << 8 | data[i];
    return static_cast<std::int64_t>(value);
}

std::string expected_types(Kind kind) {
    std::string types;
    for (const Codec& codec : codecs())
        if (codec.kind == kind && codec.fingerprint != &maebot_encoders_fingerprint)
            types += (types.empty() ? "" : " or ") + std::string(codec.type);
    return types;
}

}  // namespace pilotage
