#pragma once
/// \file
/// Where a robot can be that sees the markers of a map, when nothing else is known.

#include <algorithm>
#include <cmath>
#include <limits>

#include "pilotage/marker_map.hpp"

namespace pilotage {

/// The markers' bounding box, grown on all sides by how far a sensor may see: any place in it and
/// any heading are as likely.
struct Site {
    double low_x_m, low_y_m, high_x_m, high_y_m;
    double reach_m;  ///< the farthest a marker is seen from

    explicit Site(const MarkerMap& map) noexcept {
        constexpr double inf = std::numeric_limits<double>::infinity();
        low_x_m = low_y_m = inf;
        high_x_m = high_y_m = -inf;
        for (const Marker& m : map.markers()) {
            low_x_m = std::min(low_x_m, m.x_m);
            low_y_m = std::min(low_y_m, m.y_m);
            high_x_m = std::max(high_x_m, m.x_m);
            high_y_m = std::max(high_y_m, m.y_m);
        }
        if (map.markers().empty()) low_x_m = low_y_m = high_x_m = high_y_m = 0;
        constexpr double least_reach_m = 10;
        reach_m = std::max(least_reach_m, std::hypot(high_x_m - low_x_m, high_y_m - low_y_m));
        low_x_m -= reach_m;
        low_y_m -= reach_m;
        high_x_m += reach_m;
        high_y_m += reach_m;
    }

    [[nodiscard]] bool holds(double x_m, double y_m) const noexcept {
        return x_m >= low_x_m && x_m <= high_x_m && y_m >= low_y_m && y_m <= high_y_m;
    }

    /// Logarithm of the volume of all poses [m^2 rad].
    [[nodiscard]] double log_volume() const noexcept {
        return std::log((high_x_m - low_x_m) * (high_y_m - low_y_m) * 2 * kPi<double>);
    }

    /// Variances of the pose: of a uniform density, width^2 / 12.
    [[nodiscard]] Pose<double> variances() const noexcept {
        const double x = high_x_m - low_x_m, y = high_y_m - low_y_m, turn = 2 * kPi<double>;
        return {x * x / 12, y * y / 12, turn * turn / 12};
    }
};

}  // namespace pilotage
