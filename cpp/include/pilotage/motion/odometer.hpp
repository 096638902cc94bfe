#pragma once
/// \file
/// Turns absolute ticks and gyro rates into increments between motion samples.

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "pilotage/motion/increment.hpp"

namespace pilotage {

/// Seconds between two times in microseconds.
template <typename Scalar>
[[nodiscard]] Scalar seconds_between(std::int64_t from_us, std::int64_t to_us) noexcept {
    return Scalar(to_us - from_us) * Scalar(1e-6);
}

/// What became of a pair of tick counts.
enum class TickFault : std::uint8_t { none, wrapped, reset };

/// The turn that the gyro measured and the pose has not used yet. A rate is the mean over the
/// interval that ends at its stamp. Up to a motion sample that is newer than the newest rate, that
/// rate is held; what was held too much or too little is made good by the next rate, so no turn is
/// lost or counted twice.
class GyroIntegral {
   public:
    void add(std::int64_t utime, double rate_rad_s, double max_gap_s) noexcept {
        const auto dt_s = seconds_between<double>(utime_, utime);
        unused_rad_ += rate_rad_s * dt_s;
        whole_ = whole_ && seen_ && dt_s <= max_gap_s;
        same_ = seen_ && rate_rad_s == rate_rad_s_ ? same_ + 1 : 0;
        seen_ = true;
        utime_ = utime;
        rate_rad_s_ = rate_rad_s;
    }

    /// The turn from the last call's time up to `utime`; none if the gyro was silent for a part of
    /// it.
    [[nodiscard]] std::optional<double> take(std::int64_t utime, double max_gap_s) noexcept {
        const auto held_s = seconds_between<double>(utime_, utime);
        const double held_rad = rate_rad_s_ * held_s;
        const double turn_rad = unused_rad_ + held_rad;
        const bool whole = whole_ && seen_ && held_s <= max_gap_s;
        unused_rad_ = -held_rad;
        whole_ = true;
        return whole ? std::optional<double>(turn_rad) : std::nullopt;
    }

    /// The rate has been the same to the last bit for so long that no noise is left in it.
    [[nodiscard]] bool frozen() const noexcept { return same_ >= kFrozen; }

    /// The clock was set: time goes on at `utime`, without what the old clock dated.
    void restart(std::int64_t utime) noexcept {
        *this = {};
        utime_ = utime;
    }

   private:
    static constexpr int kFrozen = 20;

    std::int64_t utime_ = 0;
    int same_ = 0;  // rates in a row
    double rate_rad_s_ = 0, unused_rad_ = 0;
    bool seen_ = false;
    bool whole_ = false;  // no gap since the last call of take()
};

/// The wheels' last counts. Counters that wrap at 16 or 32 bits and counters that start again are
/// told from motion by the greatest speed the robot can have.
class TickCounter {
   public:
    /// The travel [m] since the last counts; none after a reset.
    [[nodiscard]] TickFault advance(const EncoderTicks& now, double dt_s, const WheelParams& wheels,
                                    double& left_m, double& right_m) noexcept {
        const double limit_m =
            wheels.max_speed_m_s * (std::fmin(dt_s, kLongestDrive_s) + kStampSlack_s);
        const TickFault left =
            travel(now.left, last_.left, wheels.left_m_per_tick, limit_m, left_m);
        const TickFault right =
            travel(now.right, last_.right, wheels.right_m_per_tick, limit_m, right_m);
        last_ = now;
        if (left != TickFault::reset && right != TickFault::reset)
            return left == TickFault::none ? right : left;
        left_m = right_m = 0;
        return TickFault::reset;
    }

    void start(const EncoderTicks& now) noexcept { last_ = now; }
    [[nodiscard]] const EncoderTicks& last() const noexcept { return last_; }

   private:
    static constexpr double kStampSlack_s = 0.1;  // stamps repeat and jitter; a reset jumps further
    static constexpr double kLongestDrive_s = 60;  // of a longer gap, ticks tell no path

    static TickFault travel(std::int64_t now, std::int64_t last, double m_per_tick, double limit_m,
                            double& travel_m) noexcept {
        // Unsigned, since a peer may send any two numbers and their difference may not fit.
        const auto ticks = static_cast<std::int64_t>(static_cast<std::uint64_t>(now) -
                                                     static_cast<std::uint64_t>(last));
        for (const std::int64_t turn :
             {std::int64_t{0}, std::int64_t{1} << 32, std::int64_t{1} << 16})
            for (const std::int64_t wrap : {turn, -turn}) {
                travel_m = (static_cast<double>(ticks) + static_cast<double>(wrap)) * m_per_tick;
                if (std::abs(travel_m) <= limit_m)
                    return turn == 0 ? TickFault::none : TickFault::wrapped;
            }
        return TickFault::reset;
    }

    EncoderTicks last_{};
};

}  // namespace pilotage
