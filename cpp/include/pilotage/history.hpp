#pragma once
/// \file
/// The samples of the last seconds in their own order, each with room for what was computed at it,
/// and what was computed before them. Capacity is fixed at construction; after it nothing is
/// allocated.

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "pilotage/samples.hpp"

namespace pilotage {

/// A sequence sorted by Sample::compare over a pool of nodes that never move: inserting in the
/// middle moves small indices only.
template <typename Node>
class History {
   public:
    explicit History(std::size_t capacity) : pool_(capacity + 1), order_(capacity) {
        for (std::size_t i = 0; i < capacity; ++i) order_[i] = static_cast<std::uint32_t>(i);
        past_ = static_cast<std::uint32_t>(capacity);
    }

    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    [[nodiscard]] bool full() const noexcept { return size_ == order_.size(); }
    [[nodiscard]] Node& operator[](std::size_t i) noexcept { return pool_[slot(i)]; }
    [[nodiscard]] const Node& operator[](std::size_t i) const noexcept { return pool_[slot(i)]; }

    /// The node that was before all others.
    [[nodiscard]] Node& past() noexcept { return pool_[past_]; }
    [[nodiscard]] const Node& past() const noexcept { return pool_[past_]; }

    /// Where `sample` belongs, and whether the same sample is there already. Searched from the
    /// newest end, where samples usually belong.
    [[nodiscard]] std::size_t place(const Sample& sample, bool& duplicate) const noexcept {
        std::size_t i = size_;
        duplicate = false;
        for (; i > 0; --i) {
            const int order = (*this)[i - 1].sample.compare(sample);
            duplicate = order == 0;
            if (order <= 0) break;
        }
        return i;
    }

    /// \pre not full. The node's old content is left in it.
    Node& insert(std::size_t position) noexcept {
        const std::uint32_t fresh = order_[wrapped(first_ + size_)];
        for (std::size_t i = size_; i > position; --i) slot(i) = slot(i - 1);
        slot(position) = fresh;
        ++size_;
        return pool_[fresh];
    }

    void pop_front() noexcept {
        // The freed slot stays in the ring's unused part, behind the last element.
        first_ = wrapped(first_ + 1);
        --size_;
    }

    /// The same, and what stood in it is past now, in place of what was.
    void pass_front() noexcept {
        std::swap(past_, slot(0));
        pop_front();
    }

   private:
    [[nodiscard]] std::size_t wrapped(std::size_t i) const noexcept {
        return i < order_.size() ? i : i - order_.size();
    }
    [[nodiscard]] std::uint32_t& slot(std::size_t i) noexcept {
        return order_[wrapped(first_ + i)];
    }
    [[nodiscard]] std::uint32_t slot(std::size_t i) const noexcept {
        return order_[wrapped(first_ + i)];
    }

    std::vector<Node> pool_;
    std::vector<std::uint32_t>
        order_;  // a ring: size_ indices in use from first_, then the free ones
    std::size_t first_ = 0, size_ = 0;
    std::uint32_t past_;
};

}  // namespace pilotage
