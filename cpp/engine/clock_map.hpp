#pragma once
/// \file
/// From a sender's clock to ours.

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace pilotage {

/// Moves stamps by the smallest receive - utime of the last minute: the message that travelled
/// fastest tells the clocks' offset best, and a minute is short enough to follow their drift (50
/// ppm are 3 ms a minute).
class ClockMap {
   public:
    /// The stamp on the receiver's clock [us].
    [[nodiscard]] std::int64_t map(std::int64_t utime, std::int64_t received) noexcept {
        const std::int64_t second = received / 1'000'000;
        const std::int64_t offset = received - utime;
        Bucket& bucket =
            buckets_[static_cast<std::size_t>(((second % kSeconds) + kSeconds) % kSeconds)];
        if (bucket.second == second) {
            bucket.smallest = std::min(bucket.smallest, offset);
            offset_us_ = std::min(offset_us_, offset);
        } else {
            bucket = {second, offset};
            offset_us_ = offset;
            for (const Bucket& b : buckets_)
                if (b.second > second - kSeconds && b.second <= second)
                    offset_us_ = std::min(offset_us_, b.smallest);
        }
        return utime + offset_us_;
    }

    /// Smallest receive - utime of the last minute [us]; 0 before the first message.
    [[nodiscard]] std::int64_t offset_us() const noexcept { return offset_us_; }

    /// By how much the sender's clock runs slow [parts per million], from the smallest offsets of
    /// seconds at least half a minute apart; NaN before.
    [[nodiscard]] double skew_ppm() const noexcept {
        const Bucket *oldest = nullptr, *newest = nullptr;
        for (const Bucket& b : buckets_) {
            if (b.second == Bucket{}.second) continue;
            if (oldest == nullptr || b.second < oldest->second) oldest = &b;
            if (newest == nullptr || b.second > newest->second) newest = &b;
        }
        if (oldest == nullptr || newest->second - oldest->second < kSeconds / 2)
            return std::numeric_limits<double>::quiet_NaN();
        return static_cast<double>(newest->smallest - oldest->smallest) /
               static_cast<double>(newest->second - oldest->second);
    }

   private:
    static constexpr std::int64_t kSeconds = 60;
    struct Bucket {
        std::int64_t second = std::numeric_limits<std::int64_t>::min();  // since the epoch
        std::int64_t smallest = 0;
    };
    std::array<Bucket, kSeconds> buckets_{};
    std::int64_t offset_us_ = 0;
};

}  // namespace pilotage
