#pragma once
/// \file
/// Angles in radians, counter-clockwise, in (-pi, pi].

#include <cmath>

namespace pilotage {

template <typename Scalar>
inline constexpr Scalar kPi = Scalar(3.141592653589793238462643383279502884L);

/// The same angle in (-pi, pi]. One turn off, the usual case, costs a branch; std::remainder is slow.
template <typename Scalar>
[[nodiscard]] Scalar wrap(Scalar angle_rad) noexcept {
    using std::remainder;
    constexpr auto pi = kPi<Scalar>;
    if (angle_rad > pi) {
        angle_rad -= 2 * pi;
        if (angle_rad > pi) angle_rad = remainder(angle_rad, 2 * pi);
    }
    if (angle_rad <= -pi) {
        angle_rad += 2 * pi;
        if (angle_rad <= -pi) angle_rad = remainder(angle_rad, 2 * pi);
        if (angle_rad <= -pi) angle_rad = pi;
    }
    return angle_rad;
}

}  // namespace pilotage
