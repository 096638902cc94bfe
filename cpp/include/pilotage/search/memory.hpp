#pragma once
/// \file
/// The latest sightings that have left the history: a search looks farther back than corrections
/// can come. It looks at no more sightings than the memory holds: so what it finds does not depend
/// on where the history ends, which is a matter of arrival.

#include <cstdint>

#include "pilotage/search/evidence.hpp"

namespace pilotage {

class Memory {
   public:
    static constexpr int kCapacity = 128;

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
    Item items_[kCapacity];
    int next_ = 0, size_ = 0;
};

}  // namespace pilotage
