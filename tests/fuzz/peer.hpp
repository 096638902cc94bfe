#pragma once
/// \file
/// A robot's messages, right and wrong, as a fuzzer's bytes ask for them.

#include <cstdint>
#include <string>

#include "draws.hpp"
#include "support/messages.hpp"

namespace pilotage::test {

/// What a peer does in one step.
struct Action {
    enum class Kind : std::uint8_t { nothing, message, tick } kind = Kind::nothing;
    std::string channel;
    Bytes bytes;
    std::int64_t received = 0;  ///< or the time of the tick [us]
    std::int64_t drops = 0;
};

class Peer {
   public:
    explicit Peer(Draws& draws) : draws_(draws) {}

    /// The next step; a fuzzer's byte chooses which, more bytes its numbers.
    [[nodiscard]] const Action& next();

   private:
    enum class Damage : std::uint8_t { none, flipped, overwritten, cut, longer };

    [[nodiscard]] std::int64_t time();
    [[nodiscard]] std::int32_t next_seq() noexcept;
    [[nodiscard]] marker_frame_t some_frame();
    [[nodiscard]] pixel_frame_t some_pixels();
    [[nodiscard]] pose_reset_t some_reset();
    void measure_otherwise();
    void prepare_mishap();
    void damage(Bytes& bytes) const;
    template <typename Message>
    void say(const char* channel, const Message& message);
    void send(const char* channel, Bytes bytes);

    Draws& draws_;
    Action action_;
    std::int64_t now_ = 1'000'000, delay_ = 0, left_ = 0, right_ = 0;
    std::int32_t seq_ = -1;
    const char* other_channel_ = nullptr;  // for the next message
    Damage damage_ = Damage::none;         // of the next message
    std::uint8_t damaged_at_ = 0, damage_value_ = 0;
};

}  // namespace pilotage::test
