#pragma once
/// \file
/// Watches a sender's stamps against our clock: jumps, standstill, repetition, skew.

#include <cstdint>
#include <cstdlib>

#include "clock_map.hpp"

namespace pilotage {

/// A stamp that says something no delay can explain is held back for a second. If all stamps go on
/// like that the clock was set, and we follow; else it was a fault, and nothing of it is left.
class SenderClock {
   public:
    enum class Stamp : std::uint8_t { good, jumped, followed };

    /// Takes a message's stamp, count and time of arrival [us].
    [[nodiscard]] Stamp look(std::int64_t utime, std::int32_t seq, std::int64_t received) noexcept {
        if (!of_a_clock(utime) || !of_a_clock(received)) return Stamp::jumped;
        const bool same = messages_ > 0 && utime == last_utime_;
        if (same) ++repeated_;
        if (!same) moved_ = received;
        still_us_ = received - moved_;
        const bool backward = messages_ > 0 && seq > last_seq_ && utime < last_utime_ - kAhead_us;
        last_utime_ = utime;
        last_seq_ = seq;
        if (messages_++ == 0) first_ = received;
        const std::int64_t offset = received - utime;
        // Against the fastest message none can be ahead, and against the last one none can be much
        // later; a sender that is slow all along is only slow.
        const std::int64_t ahead = map_.offset_us() - offset, later = offset - last_offset_;
        const bool settled = received - first_ >= kPersistent_us && messages_ > kPersistent;
        const bool as_before = held_ > 0 && std::abs(offset - held_offset_) <= kAhead_us;
        const bool odd = (ahead > kAhead_us && !runs_fast()) || later > kBehind_us ||
                         ((backward || as_before) && later > kAhead_us);
        if (!settled || !odd) {
            held_ = 0;
            last_offset_ = offset;
            if (messages_ == 1)
                begun_ = {utime, received};
            else if (received - begun_.received > kPace_us)
                begun_ = latest_;
            latest_ = {utime, received};
            (void)map_.map(utime, received);
            return Stamp::good;
        }
        jump_us_ = ahead > 0 ? -ahead : later;
        if (!as_before) {
            held_ = 0;
            held_offset_ = offset;
            held_since_ = received;
        }
        if (++held_ <= kPersistent || received - held_since_ < kPersistent_us) return Stamp::jumped;
        map_ = {};
        (void)map_.map(utime, received);
        begun_ = latest_ = {utime, received};
        last_offset_ = offset;
        held_ = 0;
        ++steps_;
        return Stamp::followed;
    }

    /// The stamp on our clock [us].
    [[nodiscard]] std::int64_t mapped(std::int64_t utime) const noexcept {
        return of_a_clock(utime) ? utime + map_.offset_us() : utime;
    }

    [[nodiscard]] std::int64_t offset_us() const noexcept { return map_.offset_us(); }
    [[nodiscard]] double skew_ppm() const noexcept { return map_.skew_ppm(); }
    [[nodiscard]] std::int64_t repeated() const noexcept { return repeated_; }
    [[nodiscard]] std::int64_t steps() const noexcept { return steps_; }
    /// How late the newest stamp that was held back is against the others, negative if it is
    /// ahead of them.
    [[nodiscard]] std::int64_t jump_us() const noexcept { return jump_us_; }
    /// For how long all stamps have been the same.
    [[nodiscard]] std::int64_t still_us() const noexcept { return still_us_; }

    /// Sums of such times do not overflow.
    [[nodiscard]] static bool of_a_clock(std::int64_t t) noexcept {
        constexpr std::int64_t limit = std::int64_t{1} << 61;
        return -limit <= t && t <= limit;
    }

   private:
    struct Moment {
        std::int64_t utime = 0, received = 0;
    };

    /// As the stamps of a recording do that is played fast: each is ahead of all before it.
    [[nodiscard]] bool runs_fast() const noexcept {
        return (latest_.utime - begun_.utime) / 2 > latest_.received - begun_.received;
    }

    static constexpr std::int64_t kAhead_us = 250'000;     // no message arrives before its time
    static constexpr std::int64_t kBehind_us = 3'000'000;  // too late for any history
    static constexpr std::int64_t kPersistent_us = 1'000'000;
    static constexpr int kPersistent = 5;  // messages
    static constexpr std::int64_t kPace_us = 10'000'000;

    ClockMap map_;
    std::int64_t first_ = 0, last_utime_ = 0, moved_ = 0, still_us_ = 0, messages_ = 0;
    std::int64_t last_offset_ = 0, held_offset_ = 0, held_since_ = 0, jump_us_ = 0;
    std::int64_t repeated_ = 0, steps_ = 0;
    Moment begun_, latest_;  // good stamps, some time ago and now: the clock's pace
    std::int32_t last_seq_ = 0;
    int held_ = 0;
};

}  // namespace pilotage
