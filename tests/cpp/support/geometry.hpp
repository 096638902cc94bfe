#pragma once
/// \file
/// Exact sightings for the search: what a robot at a pose saw, with where it was then.

#include "pilotage/search/clue.hpp"
#include "pilotage/search/evidence.hpp"
#include "support/robots.hpp"

namespace pilotage::test {

/// (cosine, sine)
[[nodiscard]] inline Point direction(double angle_rad) {
    return {std::cos(angle_rad), std::sin(angle_rad)};
}

/// What a sensor at a pose in the robot's frame of now knows of a marker, the robot being at
/// `robot` in frame map.
[[nodiscard]] inline Clue exact_clue(const Pose<double>& robot, const Pose<double>& place,
                                     const Point& marker, bool bearing, bool distance) {
    const Point seen = Frame(robot).into({marker[0], marker[1], 0}).head<2>();
    const Point way = seen - place.head<2>();
    Clue clue;
    clue.place = place.head<2>();
    clue.along = bearing ? Point(way.normalized()) : Point(kNan, kNan);
    clue.marker = marker;
    clue.distance_m = distance ? way.norm() : kNan;
    clue.variance_m2 = 1e-6;
    clue.has_direction = bearing;
    clue.has_distance = distance;
    return clue;
}

/// What a robot that is at `now` saw of a marker when it was at `then` (poses in frame map),
/// `odometry` being its frame of dead reckoning.
[[nodiscard]] inline Evidence exact_evidence(const Pose<double>& then, const Marker& marker,
                                             const Vector<double, 3>& components, int id,
                                             const SensorParams& sensor = {},
                                             const Pose<double>& odometry = {3, -4, 2}) {
    Vector<double, 3> z = view(then, marker, sensor);
    for (int c = 0; c < 3; ++c)
        if (components[c] == 0) z[c] = kNan;
    return {Frame(odometry).into(then),
            0,
            0,
            {{z[0], z[1], z[2]}, {kNan, kNan, kNan}, id, -1},
            0,
            kNan};
}

}  // namespace pilotage::test
