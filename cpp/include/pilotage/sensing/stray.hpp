#pragma once
/// \file
/// What is seen of no marker of the map: a reflection, another robot.

#include "pilotage/angle.hpp"
#include "pilotage/sensing/line_of_sight.hpp"

namespace pilotage {

/// Density of a component: any bearing, any elevation, any range up to `reach_m` is as likely.
[[nodiscard]] constexpr double stray_density(ComponentIndex component, double reach_m) noexcept {
    return 1 / (component == kBearing     ? 2 * kPi<double>
                : component == kElevation ? kPi<double>
                                          : reach_m);
}

}  // namespace pilotage
