#pragma once
/// \file
/// The measurement models of a marker with their components chosen at run time.

#include "pilotage/sensing/bearing.hpp"
#include "pilotage/sensing/elevation.hpp"
#include "pilotage/sensing/marker_sighting.hpp"
#include "pilotage/sensing/mounted.hpp"
#include "pilotage/sensing/range.hpp"

namespace pilotage::bindings {

/// Components, mounting and range calibration of a sighting of one marker.
struct MarkerModel {
    Vector<double, 3> marker_above_sensor;
    bool bearing, elevation, range;
    PlanarMounting<double> mounting;
    Range<double> range_model;

    /// Calls visit(model) with the core's model of these components.
    template <typename Visit>
    auto visit(const Visit& call) const {
        const auto make = [&](const auto&... components) {
            using Sighting = MarkerSighting<double, std::decay_t<decltype(components)>...>;
            return call(
                Mounted<Sighting, double>{{marker_above_sensor, {components...}}, mounting});
        };
        const Bearing<double> b{};
        const Elevation<double> e{};
        switch (bearing * 4 + elevation * 2 + range) {
            case 4:
                return make(b);
            case 2:
                return make(e);
            case 1:
                return make(range_model);
            case 6:
                return make(b, e);
            case 5:
                return make(b, range_model);
            case 3:
                return make(e, range_model);
            default:
                return make(b, e, range_model);
        }
    }
};

}  // namespace pilotage::bindings
