#pragma once
/// \file
/// One sighting into the filter, and what became of it.

#include <cmath>
#include <limits>

#include "pilotage/filter/ekf.hpp"
#include "pilotage/held_sighting.hpp"
#include "pilotage/marker_map.hpp"
#include "pilotage/params.hpp"
#include "pilotage/samples.hpp"
#include "pilotage/verdict.hpp"

namespace pilotage {

/// A report that says nothing yet but which sighting it is of.
[[nodiscard]] inline SightingReport blank_report(const Sample& sample, Verdict verdict) noexcept {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    int dof = 0;
    each<3>([&](int c) { dof += std::isnan(sample.payload.sighting.value[c]) ? 0 : 1; });
    return {sample.utime,
            sample.seq,
            0,
            sample.payload.sighting.id,
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

/// Fuses the given components as one vector.
template <typename Scalar, int N, typename... Components>
void fuse_components(Ekf<Scalar, N>& filter, const Marker& marker, const Sighting& sighting,
                     const MarkerSensorParams& sensor, const Policy& policy, SightingReport& report,
                     const Components&... components) noexcept {
    constexpr int M = sizeof...(Components);
    constexpr ComponentIndex which[] = {Components::kIndex...};
    const auto held = hold_against<Scalar>(filter.state().template head<kPoseStates>(), marker,
                                           sighting, sensor, components...);
    if (!held.defined) {
        report.verdict = Verdict::too_close;
        report.limit = sensor.min_distance_m;
        return;
    }
    const auto update =
        held.survey_variance > 0
            ? filter.correct(held.innovation, held.jacobian, held.noise(), policy)
            : filter.correct_independent(held.innovation, held.jacobian, held.variances, policy);
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
