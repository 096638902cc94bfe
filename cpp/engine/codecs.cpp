#include "codecs.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

#include "pilotage/encoders_t.hpp"
#include "pilotage/gyro_t.hpp"
#include "pilotage/marker_frame_t.hpp"
#include "pilotage/pose_reset_t.hpp"
#include "pilotage/reference_t.hpp"
#include "pilotage/tick_t.hpp"
#include "pilotage/velocity_t.hpp"

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

bool decode_frame(const std::uint8_t* data, std::size_t size, Decoded& out) {
    // A count that the bytes cannot hold would make the generated decoder allocate gigabytes.
    marker_frame_t message;
    constexpr std::size_t header = 8 + 8 + 4 + 4, count_and_end = 4;
    if (size < header) return false;
    std::int32_t name = 0, count = 0;
    if (__int32_t_decode_array(data, 20, static_cast<int>(size) - 20, &name, 1) < 0 || name < 1 ||
        static_cast<std::size_t>(name) + header + count_and_end > size)
        return false;
    const int at = static_cast<int>(header) + name;
    if (__int32_t_decode_array(data, at, static_cast<int>(size) - at, &count, 1) < 0 || count < 0)
        return false;
    constexpr std::size_t sighting_bytes = 2 * 4 + 6 * 8;
    if (static_cast<std::size_t>(count) > size / sighting_bytes ||
        count > std::numeric_limits<std::uint16_t>::max() || !read(data, size, message))
        return false;
    out.utime = message.utime;
    out.seq = message.seq;
    out.sensor = message.sensor;
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

const char* expected_type(Kind kind) {
    for (const Codec& codec : codecs())
        if (codec.kind == kind) return codec.type;
    return "";
}

}  // namespace pilotage
