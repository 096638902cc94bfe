#pragma once
/// \file
/// Pairs and triples out of a few, in an order in which those that follow each other share little:
/// one bad sighting then spoils few of those that are tried first.

#include <array>
#include <cstdint>

namespace pilotage {

template <int K>
using Subset = std::array<int, K>;

[[nodiscard]] constexpr int binomial(int n, int k) noexcept {
    int result = 1;
    for (int i = 0; i < k; ++i) result = result * (n - i) / (i + 1);
    return n < k ? 0 : result;
}

/// The subset of K numbers below n that is number `index` in the order of a dictionary.
template <int K>
[[nodiscard]] constexpr Subset<K> subset(int n, int index) noexcept {
    Subset<K> result{};
    int number = 0;
    for (int k = 0; k < K; ++k, ++number) {
        for (int rest = 0; index >= (rest = binomial(n - number - 1, K - k - 1)); ++number)
            index -= rest;
        result[static_cast<std::size_t>(k)] = number;
    }
    return result;
}

/// Numbers that are next to each other or in step become such as have nothing to do with each
/// other: the last steps of SplitMix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number
/// generators", OOPSLA 2014).
[[nodiscard]] constexpr std::uint32_t scattered(std::uint64_t n) noexcept {
    n += 0x9e3779b97f4a7c15;
    n = (n ^ n >> 30) * 0xbf58476d1ce4e5b9;
    n = (n ^ n >> 27) * 0x94d049bb133111eb;
    return static_cast<std::uint32_t>(n >> 32);
}

/// One of `count` numbers from 0 on, each as often as the others over many `scattered`.
[[nodiscard]] constexpr std::uint32_t one_of(std::uint32_t count,
                                             std::uint32_t scattered) noexcept {
    return static_cast<std::uint32_t>(std::uint64_t{scattered} * count >> 32);
}

/// A prime that divides no binomial(n, 2) or binomial(n, 3) of an n below it.
inline constexpr std::uint32_t kStride = 37;

/// visit(subset) for all of them until it says false; `turn` chooses where to begin.
template <int K, typename Visit>
void each_subset(int n, std::uint32_t turn, const Visit& visit) noexcept {
    const auto total = static_cast<std::uint32_t>(binomial(n, K));
    for (std::uint32_t i = 0; i < total; ++i)
        if (!visit(subset<K>(n, static_cast<int>((i + turn % total) * kStride % total)))) return;
}

}  // namespace pilotage
