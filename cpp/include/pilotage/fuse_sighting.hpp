#pragma once
/// \file
/// One sighting into the filter: which components it has, how sure they are, and what became of it.

#include <cmath>
#include <limits>

#include "pilotage/filter/ekf.hpp"
#include "pilotage/marker_map.hpp"
#include "pilotage/params.hpp"
#include "pilotage/samples.hpp"
#include "pilotage/sensing/bearing.hpp"
#include "pilotage/sensing/elevation.hpp"
#include "pilotage/sensing/marker_sighting.hpp"
#include "pilotage/sensing/mounted.hpp"
#include "pilotage/sensing/range.hpp"
#include "pilotage/verdict.hpp"

namespace pilotage {

/// A report that says nothing yet but which sighting it is of.
[[nodiscard]] inline SightingReport blank_report(const Sample& sample, Verdict verdict) noexcept {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const Sighting& sighting = sample.payload.sighting;
    SightingReport report{sample.utime, sample.seq, 0, sighting.id, sample.index, sample.source, verdict, 0,
                          {nan, nan, nan}, {nan, nan, nan}, nan, 0, nan, nan};
    for (const double value : sighting.value) report.dof += std::isnan(value) ? 0 : 1;
    return report;
}

/// The sensor's noise for one component, sqrt of the variance: the sighting's own sigma where it states one.
[[nodiscard]] inline double stated_sigma(const Sighting& sighting, int component,
                                         const MarkerSensorParams& sensor) noexcept {
    if (!std::isnan(sighting.sigma[component])) return sighting.sigma[component];
    const double configured[] = {sensor.sigma_bearing_rad, sensor.sigma_elevation_rad, sensor.sigma_range_m};
    return configured[component];
}

/// Fuses the given components as one vector.
template <typename Scalar, int N, typename... Components>
void fuse_components(Ekf<Scalar, N>& filter, const Marker& marker, const Sighting& sighting,
                     const MarkerSensorParams& sensor, const Policy& policy, SightingReport& report,
                     const Components&... components) noexcept {
    constexpr int M = sizeof...(Components);
    constexpr ComponentIndex which[] = {Components::kIndex...};
    using Model = Mounted<MarkerSighting<Scalar, Components...>, Scalar>;
    const Model model{
        {Vector<Scalar, 3>(Scalar(marker.x_m), Scalar(marker.y_m), Scalar(marker.z_m - sensor.z_m)),
         {components...},
         Scalar(sensor.min_distance_m)},
        {Scalar(sensor.x_m), Scalar(sensor.y_m), Scalar(sensor.yaw_rad)}};
    const auto h = model.linearize(filter.state().template head<kPoseStates>());
    if (!h.defined) {
        report.verdict = Verdict::too_close;
        report.limit = sensor.min_distance_m;
        return;
    }
    // The survey's uncertainty reaches the measurement as the sensor's position does, with the other sign.
    const auto by_position = h.jacobian.template leftCols<2>();
    const auto survey = Scalar(marker.sigma_m);
    Matrix<Scalar, M> r = by_position.lazyProduct(by_position.transpose()) * (survey * survey);
    Vector<Scalar, M> z;
    for (int i = 0; i < M; ++i) {
        z[i] = Scalar(sighting.value[which[i]]);
        const auto sigma = Scalar(stated_sigma(sighting, which[i], sensor));
        const Scalar per_m = which[i] == kRange ? Scalar(sensor.sigma_range_per_m) * h.value[i] : Scalar(0);
        r(i, i) += sigma * sigma + per_m * per_m;
    }
    const auto update = filter.correct(model.minus(z, h.value), h.jacobian, r, policy);
    for (int i = 0; i < M; ++i) {
        report.innovation[which[i]] = double(update.innovation[i]);
        report.sigma[which[i]] = std::sqrt(double(update.s(i, i)));
    }
    report.nis = double(update.nis);
    report.weight = double(update.weight);
    switch (update.fault) {
        case UpdateFault::none: report.verdict = Verdict::fused; break;
        case UpdateFault::gated:
            report.verdict = Verdict::gate;
            report.value = report.nis;
            report.limit = policy.gate_nis[M - 1];
            break;
        default: report.verdict = Verdict::numeric;
    }
}

/// Holds the sighting against the map and fuses what it measured, linearised at the state as it stands.
/// \pre the sighting's values are finite or NaN, at least one is finite
template <typename Scalar, int N>
[[nodiscard]] SightingReport fuse_sighting(Ekf<Scalar, N>& filter, const Sample& sample, const MarkerMap& map,
                                           const MarkerSensorParams& sensor, const Policy& policy) noexcept {
    const Sighting& sighting = sample.payload.sighting;
    SightingReport report = blank_report(sample, Verdict::unknown_marker);
    const Marker* marker = map.find(sighting.id);
    if (marker == nullptr) return report;
    const Bearing<Scalar> bearing{};
    const Elevation<Scalar> elevation{};
    const Range<Scalar> range{Scalar(sensor.range_scale), Scalar(sensor.range_offset_m)};
    const auto fuse = [&](const auto&... components) {
        fuse_components(filter, *marker, sighting, sensor, policy, report, components...);
    };
    const auto has = [&](int component) { return !std::isnan(sighting.value[component]); };
    switch (has(kBearing) * 4 + has(kElevation) * 2 + has(kRange)) {
        case 4: fuse(bearing); break;
        case 2: fuse(elevation); break;
        case 1: fuse(range); break;
        case 6: fuse(bearing, elevation); break;
        case 5: fuse(bearing, range); break;
        case 3: fuse(elevation, range); break;
        case 7: fuse(bearing, elevation, range); break;
        default: report.verdict = Verdict::bad_value;
    }
    return report;
}

}  // namespace pilotage
