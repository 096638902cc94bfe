#pragma once
/// \file
/// From a sensor to a marker: the geometry that bearing, elevation and range share.

#include <cmath>

#include "pilotage/state.hpp"

namespace pilotage {

/// Places of the components in a sighting and its report.
enum ComponentIndex : int { kBearing = 0, kElevation = 1, kRange = 2 };

/// \f$\Delta\f$ = marker - sensor in frame map, and the distance d over ground (below eq. 24 of
/// Kiriy and Buehler 2002).
template <typename Scalar>
struct LineOfSight {
    Scalar dx, dy, dz;          ///< m
    Scalar ground_squared;      ///< d^2 [m^2]
    Scalar ground;              ///< d [m]
    Scalar sensor_heading_rad;  ///< in frame map

    LineOfSight(const Pose<Scalar>& sensor, const Vector<Scalar, 3>& marker_above_sensor) noexcept
        : dx(marker_above_sensor[0] - sensor[kX]),
          dy(marker_above_sensor[1] - sensor[kY]),
          dz(marker_above_sensor[2]),
          ground_squared(dx * dx + dy * dy),
          sensor_heading_rad(sensor[kHeading]) {
        using std::sqrt;
        ground = sqrt(ground_squared);
    }
};

/// One predicted value with its derivatives by the sensor's x, y and heading.
template <typename Scalar>
struct Prediction {
    Scalar value;
    Scalar by_x, by_y, by_heading;
};

}  // namespace pilotage
