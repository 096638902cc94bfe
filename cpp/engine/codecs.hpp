#pragma once
/// \file
/// Between LCM messages and samples. A decoder is chosen by the message's first eight bytes, the
/// fingerprint of its type; a new input type is one line in the table of codecs.cpp.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "pilotage/localizer.hpp"
#include "pilotage/samples.hpp"

namespace pilotage {

/// What a message is about.
enum class Kind : std::uint8_t {
    encoders,
    velocity,
    gyro,
    frame,
    fix,
    walls,
    pixels,
    reset,
    reference,
    tick
};

/// Whether such messages name the sensor that they are of.
[[nodiscard]] constexpr bool names_sensor(Kind kind) noexcept {
    return kind == Kind::frame || kind == Kind::fix || kind == Kind::walls || kind == Kind::pixels;
}

/// A message as the engine sees it: one stamp, any number of samples.
struct Decoded {
    std::int64_t utime = 0;
    std::int32_t seq = 0;
    std::string sensor;  ///< that it names, if it is of one
    std::vector<Sample> samples;
    double reference[3] = {};  ///< x, y, heading of a reference
    std::int64_t drops = 0;    ///< of a tick
};

struct Codec {
    std::int64_t (*fingerprint)();
    const char* type;
    Kind kind;
    /// False if the bytes are no such message; `out` may then hold anything.
    bool (*decode)(const std::uint8_t* data, std::size_t size, Decoded& out);
};

/// The codec of a fingerprint, or nullptr.
[[nodiscard]] const Codec* find_codec(std::int64_t fingerprint);

/// The first eight bytes as a number; 0 if there are fewer.
[[nodiscard]] std::int64_t fingerprint_of(const std::uint8_t* data, std::size_t size) noexcept;

/// Names of the types that an input of this kind takes.
[[nodiscard]] std::string expected_types(Kind kind);

/// Encodes any lcm-gen type into `buffer`, which keeps its memory.
template <typename Message>
void encode(const Message& message, std::vector<std::uint8_t>& buffer) {
    buffer.resize(static_cast<std::size_t>(message.getEncodedSize()));
    message.encode(buffer.data(), 0, static_cast<int>(buffer.size()));
}

}  // namespace pilotage
