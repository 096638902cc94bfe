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

/// The components that a sighting has: bit ComponentIndex is set.
[[nodiscard]] inline int measured_components(const Sighting& sighting) noexcept {
    int bits = 0;
    each<3>([&](int c) { bits |= std::isnan(sighting.value[c]) ? 0 : 1 << c; });
    return bits;
}

/// A report that says nothing yet but which sighting it is of.
[[nodiscard]] inline SightingReport blank_report(const Sample& sample, Verdict verdict) noexcept {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    int dof = 0;
    each<3>([&](int c) { dof += std::isnan(sample.payload.sighting.value[c]) ? 0 : 1; });
    return {sample.utime,
            sample.seq,
            0,
            sample.payload.sighting.id,
            sample.index,
            sample.source,
            verdict,
            false,
            dof,
            {nan, nan, nan},
            {nan, nan, nan},
            nan,
            0,
            nan,
            nan};
}

/// Variance of one component: the sighting's own sigma where it states one, and for ranges what
/// grows with them.
template <typename Scalar>
[[nodiscard]] Scalar sensor_variance(const Sighting& sighting, ComponentIndex component,
                                     const MarkerSensorParams& sensor, Scalar predicted) noexcept {
    const double configured[] = {sensor.sigma_bearing_rad, sensor.sigma_elevation_rad,
                                 sensor.sigma_range_m};
    const double stated = sighting.sigma[component];
    const auto sigma = Scalar(std::isnan(stated) ? configured[component] : stated);
    if (component != kRange) return sigma * sigma;
    const Scalar growth = Scalar(sensor.sigma_range_per_m) * predicted;
    return sigma * sigma + growth * growth;
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
    const auto variances = entries<Vector<Scalar, M>>(
        [&](int i, int) { return sensor_variance(sighting, which[i], sensor, h.value[i]); });
    // The survey's uncertainty reaches the measurement as the sensor's position does, with the
    // other sign.
    const Scalar survey_variance = Scalar(marker.sigma_m) * Scalar(marker.sigma_m);
    const auto noise = [&](int i, int j) {
        const Scalar survey = survey_variance * (h.jacobian(i, kX) * h.jacobian(j, kX) +
                                                 h.jacobian(i, kY) * h.jacobian(j, kY));
        return i == j ? survey + variances[i] : survey;
    };
    const auto z =
        entries<Vector<Scalar, M>>([&](int i, int) { return Scalar(sighting.value[which[i]]); });
    const auto innovation = model.minus(z, h.value);
    const auto update =
        survey_variance > 0
            ? filter.correct(innovation, h.jacobian, symmetric<Matrix<Scalar, M>>(noise), policy)
            : filter.correct_independent(innovation, h.jacobian, variances, policy);
    each<M>([&](int i) {
        report.innovation[which[i]] = double(update.innovation[i]);
        report.sigma[which[i]] = std::sqrt(double(update.s(i, i)));
    });
    report.nis = double(update.nis);
    report.agrees = report.nis <= policy.gate_nis[M - 1];
    report.weight = double(update.weight);
    switch (update.fault) {
        case UpdateFault::none:
            report.verdict = Verdict::fused;
            break;
        case UpdateFault::gated:
            report.verdict = Verdict::gate;
            report.value = report.nis;
            report.limit = policy.gate_nis[M - 1];
            break;
        default:
            report.verdict = Verdict::numeric;
    }
}

/// Holds the sighting against the map and fuses what it measured, linearised at the state as it
/// stands.
/// \pre the sighting's values are finite or NaN
template <typename Scalar, int N>
[[nodiscard]] SightingReport fuse_sighting(Ekf<Scalar, N>& filter, const Sample& sample,
                                           const MarkerMap& map, const MarkerSensorParams& sensor,
                                           const Policy& policy) noexcept {
    const Sighting& sighting = sample.payload.sighting;
    SightingReport report = blank_report(sample, Verdict::unknown_marker);
    const Marker* marker = map.find(sighting.id);
    if (marker == nullptr) return report;
    const Bearing<Scalar> bearing{};
    const Elevation<Scalar> elevation{};
    const auto range = [&]() -> Range<Scalar> {
        return {Scalar(sensor.range_scale), Scalar(sensor.range_offset_m)};
    };
    const auto fuse = [&](const auto&... components) {
        fuse_components(filter, *marker, sighting, sensor, policy, report, components...);
    };
    switch (measured_components(sighting)) {
        case 0b001:
            fuse(bearing);
            break;
        case 0b010:
            fuse(elevation);
            break;
        case 0b100:
            fuse(range());
            break;
        case 0b011:
            fuse(bearing, elevation);
            break;
        case 0b101:
            fuse(bearing, range());
            break;
        case 0b110:
            fuse(elevation, range());
            break;
        case 0b111:
            fuse(bearing, elevation, range());
            break;
        default:
            report.verdict = Verdict::bad_value;
    }
    return report;
}

}  // namespace pilotage
