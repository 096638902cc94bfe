#pragma once
/// \file
/// Forward-mode dual numbers: a value that carries its derivative by one variable. As scalar of a
/// model it is the oracle for the Jacobians that the model writes out by hand.

#include <Eigen/Core>
#include <cmath>
#include <type_traits>

namespace pilotage::test {

template <typename T>
struct Dual {
    T value = 0;
    T slope = 0;

    constexpr Dual() = default;
    constexpr Dual(T value_, T slope_) : value(value_), slope(slope_) {}
    /// A constant. Implicit, so that `2 * x` and `x > 0` read as they do for plain numbers.
    template <typename Number, typename = std::enable_if_t<std::is_arithmetic_v<Number>>>
    constexpr Dual(Number constant) : value(static_cast<T>(constant)) {}

    friend constexpr Dual operator-(Dual a) { return {-a.value, -a.slope}; }
    friend constexpr Dual operator+(Dual a, Dual b) {
        return {a.value + b.value, a.slope + b.slope};
    }
    friend constexpr Dual operator-(Dual a, Dual b) {
        return {a.value - b.value, a.slope - b.slope};
    }
    friend constexpr Dual operator*(Dual a, Dual b) {
        return {a.value * b.value, a.slope * b.value + a.value * b.slope};
    }
    friend constexpr Dual operator/(Dual a, Dual b) {
        const T quotient = a.value / b.value;
        return {quotient, (a.slope - quotient * b.slope) / b.value};
    }
    constexpr Dual& operator+=(Dual b) { return *this = *this + b; }
    constexpr Dual& operator-=(Dual b) { return *this = *this - b; }
    constexpr Dual& operator*=(Dual b) { return *this = *this * b; }
    constexpr Dual& operator/=(Dual b) { return *this = *this / b; }

    friend constexpr bool operator<(Dual a, Dual b) { return a.value < b.value; }
    friend constexpr bool operator>(Dual a, Dual b) { return a.value > b.value; }
    friend constexpr bool operator<=(Dual a, Dual b) { return a.value <= b.value; }
    friend constexpr bool operator>=(Dual a, Dual b) { return a.value >= b.value; }
    friend constexpr bool operator==(Dual a, Dual b) { return a.value == b.value; }
    friend constexpr bool operator!=(Dual a, Dual b) { return a.value != b.value; }
};

template <typename T>
Dual<T> sin(Dual<T> a) {
    return {std::sin(a.value), a.slope * std::cos(a.value)};
}

template <typename T>
Dual<T> cos(Dual<T> a) {
    return {std::cos(a.value), -a.slope * std::sin(a.value)};
}

template <typename T>
Dual<T> sqrt(Dual<T> a) {
    const T root = std::sqrt(a.value);
    return {root, a.slope / (2 * root)};
}

template <typename T>
Dual<T> exp(Dual<T> a) {
    const T power = std::exp(a.value);
    return {power, a.slope * power};
}

template <typename T>
Dual<T> log(Dual<T> a) {
    return {std::log(a.value), a.slope / a.value};
}

template <typename T>
Dual<T> abs(Dual<T> a) {
    return a.value < 0 ? -a : a;
}

template <typename T>
Dual<T> atan(Dual<T> a) {
    return {std::atan(a.value), a.slope / (1 + a.value * a.value)};
}

template <typename T>
Dual<T> atan2(Dual<T> y, Dual<T> x) {
    const T squared = x.value * x.value + y.value * y.value;
    return {std::atan2(y.value, x.value), (x.value * y.slope - y.value * x.slope) / squared};
}

/// By `a` only: the period is a constant.
template <typename T>
Dual<T> remainder(Dual<T> a, Dual<T> period) {
    return {std::remainder(a.value, period.value), a.slope};
}

}  // namespace pilotage::test

template <typename T>
struct Eigen::NumTraits<pilotage::test::Dual<T>> : Eigen::NumTraits<T> {
    using Real = pilotage::test::Dual<T>;
    using NonInteger = Real;
    using Nested = Real;
    using Literal = Real;
    enum { RequireInitialization = 1 };
};
