#pragma once
/// \file
/// A sighting as the search for a pose gets it, and as it sees it: from the robot as it stands now.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "pilotage/held_sighting.hpp"
#include "pilotage/marker_map.hpp"
#include "pilotage/params.hpp"
#include "pilotage/samples.hpp"
#include "pilotage/search/frame.hpp"
#include "pilotage/search/site.hpp"
#include "pilotage/sensing/stray.hpp"

namespace pilotage {

/// A sighting, and where dead reckoning says that it was made.
struct Evidence {
    static constexpr int kMost = 32;  ///< that a search takes

    Pose<double> body;  ///< of the robot at the sighting, in an odometry frame
    /// Variances that odometry has gathered since its frame began [m^2, each axis] and [rad^2]:
    /// what they grew by since a sighting tells how unsure the way from there to here is.
    double drift_m2, drift_rad2;
    Sighting sighting;      ///< id -1: unknown
    std::uint8_t source;    ///< sensor number
    double log_likelihood;  ///< under the estimate that is judged; NaN or -inf: there is none
};

/// How often a sighting is of something else than it says, or of nothing.
inline constexpr double kClutter = 0.15;

/// A sighting as seen from the robot now.
struct View {
    const Sighting* sighting = nullptr;
    const SensorParams* sensor = nullptr;
    const Marker* marker = nullptr;  ///< the only one that it can be of; nullptr: several can be
    std::int32_t label = -1;         ///< that it must have, -1: any
    int measured = 0;                ///< bit ComponentIndex
    double variance[3] = {};         ///< of the sensor's noise alone
    Pose<double> place{0, 0, 0};     ///< of the sensor at the sighting, in the robot's frame of now
    double place_m2 = 0, place_rad2 = 0;  ///< variances of that by odometry, each axis and heading
    Point along{0, 0};   ///< unit vector from the sensor to the marker, in the robot's frame of now
    double slope = 0;    ///< tangent of the elevation
    double slant_m = 0;  ///< range as the map has it: scale and offset taken out
    double share = 0;    ///< probability that it is of one marker that it can be of
    double clutter = 0;  ///< density of the measured values where it is of none, times kClutter
    double log_clutter = 0;
    double log_likelihood = 0;  ///< under the estimate that is judged, never below log_clutter

    [[nodiscard]] bool has(ComponentIndex c) const noexcept { return measured >> c & 1; }

    /// Whether the sighting can be of that marker: by its id or, where it has none, its label.
    [[nodiscard]] bool may_be_of(const Marker& candidate) const noexcept {
        return marker != nullptr ? marker == &candidate : label < 0 || candidate.label == label;
    }
};

/// \param relative pose of the robot at the sighting in the robot's frame of now
/// \return a view that measures nothing if the sighting says nothing about the pose
[[nodiscard]] inline View view_of(const Sighting& sighting, const SensorParams& sensor,
                                  const MarkerMap& map, const Site& site,
                                  const Pose<double>& relative = {0, 0, 0}, double drift_m2 = 0,
                                  double drift_rad2 = 0) noexcept {
    View view;
    view.sighting = &sighting;
    view.sensor = &sensor;
    view.marker = sighting.id < 0 ? nullptr : map.find(sighting.id);
    view.label = map.wanted_label(sighting.label);
    if (sighting.id >= 0 && view.marker == nullptr) return view;
    const auto& markers = map.markers();
    const auto may_be_of = [&](const Marker& marker) { return view.may_be_of(marker); };
    const auto candidates = view.marker != nullptr ? 1
                            : view.label < 0
                                ? static_cast<long>(markers.size())
                                : std::count_if(markers.begin(), markers.end(), may_be_of);
    if (candidates == 0) return view;
    view.measured = measured_components(sighting);
    view.place = Frame(relative).out_of({sensor.x_m, sensor.y_m, sensor.yaw_rad});
    // A heading that drifted evenly on the way leaves a third of its variance aside, by distance.
    view.place_m2 = drift_m2 + drift_rad2 * relative.head<2>().squaredNorm() / 3;
    view.place_rad2 = drift_rad2;
    view.clutter = kClutter;
    each<3>([&](int c) {
        const auto component = static_cast<ComponentIndex>(c);
        if (!view.has(component)) return;
        view.variance[c] = sensor_variance(sighting, component, sensor, sighting.value[c]);
        view.clutter *= stray_density(component, site.reach_m);
    });
    view.share = (1 - kClutter) / static_cast<double>(candidates);
    view.log_likelihood = view.log_clutter = std::log(view.clutter);
    view.slant_m = (sighting.value[kRange] - sensor.range_offset_m) / sensor.range_scale;
    if (view.has(kElevation)) view.slope = std::tan(sighting.value[kElevation]);
    if (view.has(kBearing)) {
        const double direction = view.place[kHeading] + sighting.value[kBearing];
        view.along = {std::cos(direction), std::sin(direction)};
    }
    return view;
}

}  // namespace pilotage
