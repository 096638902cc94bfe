#pragma once
/// \file
/// What a body that is tilted sees: exact rotations.

#include <Eigen/Geometry>
#include <cmath>

#include "pilotage/state.hpp"

namespace pilotage::test {

using Point3 = Vector<double, 3>;

/// What is left of a direction (bearing, elevation) in a body that is turned by pitch and roll.
[[nodiscard]] inline Point3 tilted(const Point3& seen, double pitch, double roll) {
    const Point3 level(std::cos(seen[0]) * std::cos(seen[1]), std::sin(seen[0]) * std::cos(seen[1]),
                       std::sin(seen[1]));
    const Point3 turn(roll, -pitch, 0);  // nose up is a turn about the right hand side
    const double angle = turn.norm();
    const Point3 body =
        angle == 0 ? level : Point3(Eigen::AngleAxisd(-angle, turn / angle) * level);
    return {std::atan2(body[1], body[0]), std::asin(body[2]), seen[2]};
}

}  // namespace pilotage::test
