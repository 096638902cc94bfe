#pragma once
/// \file
/// Angle to a marker in the ground plane, from the sensor's forward axis, left positive.

#include "pilotage/sensing/curvature.hpp"
#include "pilotage/sensing/line_of_sight.hpp"

namespace pilotage {

/// Eq. 23 (with atan2) and the first row of eq. 25 of Kiriy and Buehler 2002.
template <typename Scalar>
struct Bearing {
    static constexpr ComponentIndex kIndex = kBearing;
    static constexpr bool kWraps = true;

    [[nodiscard]] Prediction<Scalar> predict(const LineOfSight<Scalar>& sight) const noexcept {
        const Scalar per_square = 1 / sight.ground_squared;
        return {direction_of(sight.dx, sight.dy) - sight.sensor_heading_rad, sight.dy * per_square,
                -sight.dx * per_square, Scalar(-1)};
    }

    [[nodiscard]] Bend<Scalar> bend(const LineOfSight<Scalar>& sight) const noexcept {
        return {0, -1 / sight.ground_squared, 0};
    }
};

}  // namespace pilotage
