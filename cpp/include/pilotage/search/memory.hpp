#pragma once
/// \file
/// The latest sightings that have left the history: a search looks farther back than corrections
/// can come.

#include <cstdint>

#include "pilotage/search/pose_search.hpp"

namespace pilotage {

class Memory {
   public:
    struct Item {
        std::int64_t utime;
        Evidence evidence;
    };

    void add(const Item& item) noexcept {
        next_ = (next_ + 1) % kCapacity;
        items_[next_] = item;
        if (size_ < kCapacity) ++size_;
    }

    template <typename Visit>
    void each_newest_first(const Visit& visit) const noexcept {
        for (int i = 0; i < size_; ++i) visit(items_[(next_ + kCapacity - i) % kCapacity]);
    }

   private:
    static constexpr int kCapacity = PoseSearch::kMostEvidence;

    Item items_[kCapacity];
    int next_ = 0, size_ = 0;
};

}  // namespace pilotage
