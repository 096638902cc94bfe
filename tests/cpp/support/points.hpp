#pragma once
/// \file
/// Where Jacobians are checked: the places where they go wrong, and seeded random ones.

#include <vector>

#include "pilotage/state.hpp"
#include "support/random.hpp"

namespace pilotage::test {

/// The origin, headings at and beside the wrap and along the axes, and random poses.
template <typename Scalar>
[[nodiscard]] std::vector<Pose<Scalar>> poses() {
    constexpr Scalar pi = kPi<Scalar>;
    std::vector<Pose<Scalar>> result{Pose<Scalar>::Zero()};
    for (const Scalar heading : {pi, -pi, pi - Scalar(1e-6), -pi + Scalar(1e-6), pi / 2, -pi / 2})
        result.emplace_back(Scalar(1), Scalar(-2), heading);
    Draw draw(1);
    for (int i = 0; i < 50; ++i) result.push_back(draw.pose<Scalar>());
    return result;
}

/// (distance [m], turn [rad]): at rest, on the spot, straight, backwards, turns of 1e-8 rad, around
/// the switch of the chord series, past a half turn, and random ones.
template <typename Scalar>
[[nodiscard]] std::vector<Vector<Scalar, 2>> travels() {
    std::vector<Vector<Scalar, 2>> result;
    for (const double turn : {0.0, 1e-8, -1e-8, 0.0999, 0.1001, -0.1001, 1.0, 3.1, -3.2})
        for (const double distance : {0.0, 1.0, -0.3})
            result.emplace_back(Scalar(distance), Scalar(turn));
    Draw draw(2);
    for (int i = 0; i < 20; ++i)
        result.emplace_back(draw.uniform<Scalar>(-2, 2), draw.uniform<Scalar>(-0.5, 0.5));
    return result;
}

/// Where a marker may stand as seen from a sensor: all around it, from a millimetre to 10 km away,
/// level, above and below. z is above the sensor.
template <typename Scalar>
[[nodiscard]] std::vector<Vector<Scalar, 3>> markers_around(const Pose<Scalar>& sensor) {
    std::vector<Vector<Scalar, 3>> result;
    for (const Scalar distance : {Scalar(2e-3), Scalar(1), Scalar(15), Scalar(1e4)})
        for (const Scalar height : {Scalar(0), Scalar(-1.2), Scalar(0.3)})
            for (const double direction : {0.0, 0.7, 1.5707963, 3.1415926, -2.5})
                result.emplace_back(sensor[kX] + distance * Scalar(std::cos(direction)),
                                    sensor[kY] + distance * Scalar(std::sin(direction)), height);
    return result;
}

}  // namespace pilotage::test
