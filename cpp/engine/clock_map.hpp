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

    /// The newest offset [us]; 0 before the first message.
    [[nodiscard]] std::int64_t offset_us() const noexcept { return offset_us_; }

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
