#pragma once
/// \file
/// Direction from a marker to the robot in frame map, as found from the marker's own pose in an
/// image. It does not see the heading.

#include "pilotage/sensing/line_of_sight.hpp"

namespace pilotage {

/// Eq. 4 and the gradient of P. Kohler's final project report. Its innovation wraps: a robot that
/// looks towards +x at a marker has it at pi.
template <typename Scalar>
struct WorldBearing {
    static constexpr bool kWraps = true;

    [[nodiscard]] Prediction<Scalar> predict(const LineOfSight<Scalar>& sight) const noexcept {
        const Scalar per_square = 1 / sight.ground_squared;
        return {direction_of<Scalar>(-sight.dx, -sight.dy), sight.dy * per_square,
                -sight.dx * per_square, Scalar(0)};
    }
};

}  // namespace pilotage
