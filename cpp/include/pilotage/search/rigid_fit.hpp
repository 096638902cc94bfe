#pragma once
/// \file
/// The pose from two points that are known in the robot's frame and in the map's.

#include <cmath>

#include "pilotage/search/heading_equation.hpp"

namespace pilotage {

/// Whether two points seen are as far apart as their markers, as far as noise lets one tell.
[[nodiscard]] inline bool same_distance(const Clue& one, const Clue& two) noexcept {
    constexpr double sigmas = 4;
    const double off = (two.point() - one.point()).norm() - (two.marker - one.marker).norm();
    return off * off < sigmas * sigmas * (one.variance_m2 + two.variance_m2);
}

/// The turn that lays the line through the points on the line through their markers, as (cosine,
/// sine); the least-squares rigid fit of two points (Umeyama 1991, in the plane).
/// \pre both are points, and apart from each other
[[nodiscard]] inline Point turn_by(const Clue& one, const Clue& two) noexcept {
    const Point seen = two.point() - one.point(), known = two.marker - one.marker;
    return Point(seen.dot(known), cross(seen, known)).normalized();
}

/// The place that goes with that turn: the middle of the points on the middle of their markers.
[[nodiscard]] inline Point place_by(const Clue& one, const Clue& two, const Point& turn) noexcept {
    const Point middle = (one.point() + two.point()) / 2;
    return (one.marker + two.marker) / 2 - turned(turn, middle);
}

}  // namespace pilotage
