#pragma once
/// \file
/// Angle to a marker above the horizontal plane through the sensor, up positive.

#include "pilotage/sensing/curvature.hpp"
#include "pilotage/sensing/line_of_sight.hpp"

namespace pilotage {

/// Eq. 24 of Kiriy and Buehler 2002 for a marker on the ground (dz = -mu), and the second row of
/// eq. 25 with the signs that follow from eq. 24 (they are printed the other way round).
template <typename Scalar>
struct Elevation {
    static constexpr ComponentIndex kIndex = kElevation;
    static constexpr bool kWraps = false;

    [[nodiscard]] Prediction<Scalar> predict(const LineOfSight<Scalar>& sight) const noexcept {
        using std::atan;
        const Scalar slant_squared = sight.ground_squared + sight.dz * sight.dz;
        const Scalar factor = sight.dz / (sight.ground * slant_squared);
        return {atan(sight.dz / sight.ground), sight.dx * factor, sight.dy * factor, Scalar(0)};
    }

    [[nodiscard]] Bend<Scalar> bend(const LineOfSight<Scalar>& sight) const noexcept {
        const Scalar slant_squared = sight.ground_squared + sight.dz * sight.dz;
        return {2 * sight.ground * sight.dz / (slant_squared * slant_squared), 0,
                -sight.dz / (sight.ground * slant_squared)};
    }
};

}  // namespace pilotage
