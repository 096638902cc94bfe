#pragma once
/// \file
/// A fuzzer's bytes read as choices, numbers and times. Past the end everything is zero.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>

namespace pilotage::test {

class Draws {
   public:
    Draws(const std::uint8_t* data, std::size_t size) noexcept : at_(data), end_(data + size) {}

    [[nodiscard]] bool empty() const noexcept { return at_ == end_; }
    std::uint8_t byte() noexcept { return empty() ? std::uint8_t{0} : *at_++; }
    int below(int n) noexcept { return byte() % n; }

    /// One of a table's values, each as likely.
    template <typename Table>
    const auto& one_of(const Table& table) noexcept {
        return table[static_cast<std::size_t>(below(static_cast<int>(std::size(table))))];
    }

    /// Any value of a type, by its bytes.
    template <typename T>
    T raw() noexcept {
        std::uint8_t bytes[sizeof(T)];
        for (std::uint8_t& b : bytes) b = byte();
        T value;
        std::memcpy(&value, bytes, sizeof value);
        return value;
    }

    /// Mostly small steps of 1/16 around zero, else what breaks arithmetic, else any bits.
    double number() noexcept {
        using Limits = std::numeric_limits<double>;
        static constexpr double awkward[] = {Limits::quiet_NaN(),
                                             Limits::infinity(),
                                             -Limits::infinity(),
                                             Limits::max(),
                                             Limits::lowest(),
                                             Limits::denorm_min(),
                                             Limits::min(),
                                             -0.0,
                                             1e154,
                                             1e-9,
                                             1e9,
                                             -1e9,
                                             1e7,
                                             3.141592653589793,
                                             -3.141592653589793,
                                             100.0};
        const std::uint8_t kind = byte();
        if (kind < 16) return awkward[kind];
        if (kind < 20) return raw<double>();
        return static_cast<std::int8_t>(byte()) / 16.0;
    }

    /// Any whole number, mostly the ends of its range.
    std::int64_t extreme() noexcept {
        using Limits = std::numeric_limits<std::int64_t>;
        static constexpr std::int64_t ends[] = {Limits::min(),
                                                Limits::max(),
                                                -1,
                                                0,
                                                1,
                                                std::int64_t{1} << 60,
                                                -(std::int64_t{1} << 60),
                                                std::int64_t{1} << 61,
                                                -(std::int64_t{1} << 61),
                                                std::int64_t{1} << 31};
        const std::uint8_t kind = byte();
        return kind < std::size(ends) ? ends[kind] : raw<std::int64_t>();
    }

   private:
    const std::uint8_t* at_;
    const std::uint8_t* end_;
};

}  // namespace pilotage::test
