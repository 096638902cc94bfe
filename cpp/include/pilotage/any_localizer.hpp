#pragma once
/// \file
/// The localizer with as many states as a configuration asks for.

#include <utility>
#include <variant>

#include "pilotage/localizer.hpp"

namespace pilotage {

using AnyLocalizer =
    std::variant<Localizer<double, kPoseStates>, Localizer<double, kCalibratedStates>,
                 Localizer<double, kTiltedStates>>;

[[nodiscard]] inline AnyLocalizer make_localizer(const Params& params, MarkerMap map, WallMap walls,
                                                 Listener& listener) {
    if (params.tilt.any())
        return AnyLocalizer(std::in_place_index<2>, params, std::move(map), listener,
                            std::move(walls));
    if (params.calibrates())
        return AnyLocalizer(std::in_place_index<1>, params, std::move(map), listener,
                            std::move(walls));
    return AnyLocalizer(std::in_place_index<0>, params, std::move(map), listener, std::move(walls));
}

}  // namespace pilotage
