#pragma once
/// \file
/// Angles in radians, counter-clockwise, in (-pi, pi].

#include <cmath>

namespace pilotage {

template <typename Scalar>
inline constexpr Scalar kPi = Scalar(3.141592653589793238462643383279502884L);

/// For an angle that is more than a turn off.
template <typename Scalar>
[[nodiscard, gnu::noinline, gnu::cold]] Scalar wrap_far(Scalar angle_rad) noexcept {
    using std::remainder;
    const Scalar wrapped = remainder(angle_rad, Scalar(2 * kPi<Scalar>));
    return wrapped <= -kPi<Scalar> ? kPi<Scalar> : wrapped;
}

/// The same angle in (-pi, pi]. One turn off, the usual case, costs a branch; std::remainder is
/// slow.
template <typename Scalar>
[[nodiscard]] inline Scalar wrap(Scalar angle_rad) noexcept {
    constexpr auto pi = kPi<Scalar>;
    if (angle_rad > pi) {
        const Scalar turned = angle_rad - 2 * pi;
        return turned <= pi ? turned : wrap_far(turned);
    }
    if (angle_rad <= -pi) {
        const Scalar turned = angle_rad + 2 * pi;
        return turned > -pi ? turned : wrap_far(turned);
    }
    return angle_rad;
}

/// Angle of the direction (x, y), as atan2(y, x) but at half its cost: it may be one more unit in
/// the last place off, because the rounding of the quotient is not undone.
template <typename Scalar>
[[nodiscard]] inline Scalar direction_of(const Scalar& x, const Scalar& y) noexcept {
    using std::abs;
    using std::atan;
    constexpr auto pi = kPi<Scalar>;
    if (abs(x) < abs(y)) return (y > 0 ? pi / 2 : -pi / 2) - atan(x / y);
    const Scalar angle = atan(y / x);
    return x > 0 ? angle : y < 0 ? angle - pi : angle + pi;
}

}  // namespace pilotage
