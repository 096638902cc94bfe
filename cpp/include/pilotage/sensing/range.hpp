#pragma once
/// \file
/// Slant distance to a marker, as a sensor with a scale error and an offset reports it.

#include "pilotage/sensing/curvature.hpp"
#include "pilotage/sensing/line_of_sight.hpp"

namespace pilotage {

template <typename Scalar>
struct Range {
    static constexpr ComponentIndex kIndex = kRange;
    static constexpr bool kWraps = false;

    Scalar scale = 1;     ///< reported over true distance
    Scalar offset_m = 0;  ///< reported at distance zero

    [[nodiscard]] Prediction<Scalar> predict(const LineOfSight<Scalar>& sight) const noexcept {
        using std::sqrt;
        const Scalar slant = sqrt(sight.ground_squared + sight.dz * sight.dz);
        const Scalar factor = -scale / slant;
        return {scale * slant + offset_m, sight.dx * factor, sight.dy * factor, Scalar(0)};
    }

    [[nodiscard]] Bend<Scalar> bend(const LineOfSight<Scalar>& sight) const noexcept {
        using std::sqrt;
        const Scalar slant_squared = sight.ground_squared + sight.dz * sight.dz;
        const Scalar across = scale / sqrt(slant_squared);
        return {across * sight.dz * sight.dz / slant_squared, 0, across};
    }
};

}  // namespace pilotage
