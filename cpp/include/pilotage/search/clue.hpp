#pragma once
/// \file
/// What a sighting says about the pose if it is of a certain marker: the marker lies on a ray, on a
/// circle, or at a point of the robot's frame of now.

#include <cmath>

#include "pilotage/search/evidence.hpp"

namespace pilotage {

struct Clue {
    Point place;             ///< of the sensor at the sighting, in the robot's frame of now [m]
    Point along;             ///< unit vector to the marker in the same frame, where has_direction
    Point marker;            ///< in frame map [m]
    double distance_m = 0;   ///< over ground, where has_distance
    double variance_m2 = 0;  ///< of the point, both axes together
    bool has_direction = false, has_distance = false;

    [[nodiscard]] bool is_point() const noexcept { return has_direction && has_distance; }

    /// The marker in the robot's frame of now.
    /// \pre is_point()
    [[nodiscard]] Point point() const noexcept { return place + distance_m * along; }
};

/// The bearing alone.
[[nodiscard]] inline Clue ray_of(const View& view, const Marker& marker) noexcept {
    Clue clue{view.place.head<2>(), view.along, {marker.x_m, marker.y_m}};
    clue.has_direction = view.has(kBearing);
    return clue;
}

/// Bearing and distance. That is taken from the range or, where there is none, from the elevation
/// if it tells it to better than `kVague`.
[[nodiscard]] inline Clue clue_of(const View& view, const Marker& marker) noexcept {
    constexpr double kVague = 0.3;  // sigma over distance
    Clue clue = ray_of(view, marker);
    const double dz = marker.z_m - view.sensor->z_m;
    double variance = 0;
    if (view.has(kRange)) {
        clue.distance_m = std::sqrt(std::max(0.0, view.slant_m * view.slant_m - dz * dz));
        const double scale = view.sensor->range_scale;
        const double by_slant = view.slant_m / clue.distance_m;
        variance = view.variance[kRange] / (scale * scale) * by_slant * by_slant;
        clue.has_distance = clue.distance_m >= view.sensor->min_distance_m;
    } else if (view.has(kElevation)) {
        const double d = dz / view.slope;
        const double by_elevation = (d * d + dz * dz) / dz;
        variance = view.variance[kElevation] * by_elevation * by_elevation;
        clue.distance_m = d;
        clue.has_distance = d >= view.sensor->min_distance_m && variance < kVague * kVague * d * d;
    }
    clue.variance_m2 =
        variance + view.place_m2 + marker.sigma_m * marker.sigma_m +
        clue.distance_m * clue.distance_m * (view.variance[kBearing] + view.place_rad2);
    return clue;
}

}  // namespace pilotage
