#pragma once
/// \file
/// Which markers something is of, as far as it takes to count a few.

#include <cstddef>
#include <cstdint>

namespace pilotage {

/// By their places in the map, modulo 64: never counts more than there are.
class MarkerSet {
   public:
    constexpr MarkerSet() = default;
    /// What is not of one marker: as good as of all.
    [[nodiscard]] static constexpr MarkerSet all() noexcept { return MarkerSet(~std::uint64_t{0}); }
    /// \param place in the map
    [[nodiscard]] static constexpr MarkerSet of(std::ptrdiff_t place) noexcept {
        return MarkerSet(std::uint64_t{1} << place % 64);
    }

    constexpr void add(MarkerSet more) noexcept { bits_ |= more.bits_; }

    [[nodiscard]] constexpr int count() const noexcept {
        int n = 0;
        for (std::uint64_t bits = bits_; bits != 0; bits &= bits - 1) ++n;
        return n;
    }

   private:
    constexpr explicit MarkerSet(std::uint64_t bits) noexcept : bits_(bits) {}

    std::uint64_t bits_ = 0;
};

}  // namespace pilotage
