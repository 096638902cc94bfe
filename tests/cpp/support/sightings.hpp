#pragma once
/// \file
/// Sightings of a marker by what they measure.

#include "pilotage/sensing/bearing.hpp"
#include "pilotage/sensing/elevation.hpp"
#include "pilotage/sensing/marker_sighting.hpp"
#include "pilotage/sensing/range.hpp"
#include "pilotage/sensing/world_bearing.hpp"

namespace pilotage::test {

template <typename Scalar>
using BearingOnly = MarkerSighting<Scalar, Bearing<Scalar>>;
template <typename Scalar>
using ElevationOnly = MarkerSighting<Scalar, Elevation<Scalar>>;
template <typename Scalar>
using RangeOnly = MarkerSighting<Scalar, Range<Scalar>>;
template <typename Scalar>
using WorldBearingOnly = MarkerSighting<Scalar, WorldBearing<Scalar>>;
template <typename Scalar>
using BearingElevation = MarkerSighting<Scalar, Bearing<Scalar>, Elevation<Scalar>>;
template <typename Scalar>
using BearingElevationRange =
    MarkerSighting<Scalar, Bearing<Scalar>, Elevation<Scalar>, Range<Scalar>>;

}  // namespace pilotage::test
