#pragma once
/// \file
/// Walls by the corners of rooms and obstacles.

#include "pilotage/wall_map.hpp"

namespace pilotage::test {

/// Walls from corner to corner and back to the first one.
[[nodiscard]] inline std::vector<Wall> ring(const std::vector<Vector<double, 2>>& corners) {
    std::vector<Wall> walls;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto& from = corners[i];
        const auto& to = corners[(i + 1) % corners.size()];
        walls.push_back({from[0], from[1], to[0], to[1]});
    }
    return walls;
}

}  // namespace pilotage::test
