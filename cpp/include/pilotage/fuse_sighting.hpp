#pragma once
/// \file
/// One sighting into the filter, and what became of it.

#include <cmath>

#include "pilotage/filter/ukf.hpp"
#include "pilotage/held_sighting.hpp"
#include "pilotage/marker_map.hpp"
#include "pilotage/params.hpp"
#include "pilotage/samples.hpp"
#include "pilotage/sighting_report.hpp"
#include "pilotage/tilt.hpp"

namespace pilotage {

/// Whether the first component bends so much within the pose's own uncertainty that its variance
/// grows by a fifth: on a close pass.
template <ComponentIndex kFirst, typename Scalar, int M, int N>
[[nodiscard, gnu::always_inline]] inline bool bends(const HeldSighting<Scalar, M>& held,
                                                    const Ekf<Scalar, N>& filter) noexcept {
    const auto& p = filter.covariance();
    const Scalar spread = p(kX, kX) + p(kY, kY);
    const Scalar ground_squared = held.dx * held.dx + held.dy * held.dy;
    const Scalar flat = ground_squared * Scalar(0.8) * held.variances[0];
    return spread * spread > (kFirst == kRange ? flat : flat * ground_squared);
}

/// What linearising leaves out of a close pass, as variances of the components.
template <typename Scalar, int N, typename... Components>
[[nodiscard, gnu::noinline, gnu::cold]] Vector<Scalar, int(sizeof...(Components))> bend_variances(
    const Ekf<Scalar, N>& filter, Scalar dx, Scalar dy, Scalar dz,
    const Components&... components) noexcept {
    const LineOfSight<Scalar> sight({0, 0, 0}, {dx, dy, dz});
    Vector<Scalar, int(sizeof...(Components))> result;
    int i = 0;
    ((result[i++] = curvature_variance(components.bend(sight), dx, dy, filter.covariance())), ...);
    return result;
}

/// Bearing, elevation and range of a marker over the Gaussian of a pose, whichever a sighting has
/// of them: one function for all, since its code counts for more than its time.
template <typename Scalar>
[[nodiscard, gnu::noinline, gnu::cold]] auto seen_over(const Pose<Scalar>& mean,
                                                       const Matrix<Scalar, 3>& covariance,
                                                       const Marker& marker,
                                                       const SensorParams& sensor) noexcept {
    return unscented_measurement(
        sighting_model<Scalar>(
            marker, sensor, Bearing<Scalar>{}, Elevation<Scalar>{},
            Range<Scalar>{Scalar(sensor.range_scale), Scalar(sensor.range_offset_m)}),
        mean, covariance, Unscented{});
}

inline void describe_too_close(const SensorParams& sensor, SightingReport& report) noexcept {
    report.verdict = Verdict::too_close;
    report.limit = sensor.min_distance_m;
}

/// Fuses the given components as one vector.
/// \tparam kHold see Ekf::correct
template <bool kHold, typename Scalar, int N, typename... Components>
[[gnu::flatten]] void fuse_components(Ekf<Scalar, N>& filter, const Marker& marker,
                                      const Sighting& sighting, const SensorParams& sensor,
                                      const Policy& policy, SightingReport& report,
                                      const Components&... components) noexcept {
    constexpr int M = sizeof...(Components);
    constexpr ComponentIndex which[] = {Components::kIndex...};
    auto held = hold_against<Scalar>(filter.state().template head<kPoseStates>(), marker, sighting,
                                     sensor, components...);
    if (!held.defined) return describe_too_close(sensor, report);
    if (bends<which[0]>(held, filter) && policy.fusion != Fusion::plain) {
        const auto more = bend_variances(filter, held.dx, held.dy, held.dz, components...);
        each<M>([&](int i) { held.variances[i] += more[i]; });
    }
    if constexpr (N == kTiltedStates) {
        const auto tilted = with_tilt<Scalar, Components...>(held, filter.state());
        describe_update(
            filter.correct(tilted.innovation, tilted.jacobian, held.noise(), policy, kHold), which,
            policy, report);
    } else {
        const auto update =
            held.survey_variance > 0
                ? filter.correct(held.innovation, held.jacobian, held.noise(), policy, kHold)
                : filter.correct_independent(held.innovation, held.jacobian, held.variances, policy,
                                             kHold);
        describe_update(update, which, policy, report);
    }
}

/// The same by either filter, where the size of the code counts for more than its time.
/// \param hold see Ekf::correct
template <Filter kFilter, typename Scalar, int N, typename... Components>
[[gnu::noinline]] void fuse_compactly(Ekf<Scalar, N>& filter, bool hold, const Marker& marker,
                                      const Sighting& sighting, const SensorParams& sensor,
                                      const Policy& policy, SightingReport& report,
                                      const Components&... components) noexcept {
    constexpr int M = sizeof...(Components);
    constexpr ComponentIndex which[] = {Components::kIndex...};
    auto held = hold_against<Scalar>(filter.state().template head<kPoseStates>(), marker, sighting,
                                     sensor, components...);
    Matrix<Scalar, M> rest = Matrix<Scalar, M>::Zero();
    if (held.defined && kFilter == Filter::ukf) {
        const auto seen =
            seen_over<Scalar>(filter.state().template head<kPoseStates>(),
                              filter.covariance().template topLeftCorner<3, 3>(), marker, sensor);
        held.defined = seen.defined;
        const auto value =
            entries<Vector<Scalar, M>>([&](int i, int) { return seen.value[which[i]]; });
        held.innovation = sighting_model<Scalar>(marker, sensor, components...)
                              .minus(values_of<Scalar, Components...>(sighting), value);
        held.jacobian = entries<Matrix<Scalar, M, kPoseStates>>(
            [&](int i, int j) { return seen.jacobian(which[i], j); });
        rest = entries<Matrix<Scalar, M>>(
            [&](int i, int j) { return seen.noise(which[i], which[j]); });
    } else if (held.defined && policy.fusion != Fusion::plain && bends<which[0]>(held, filter)) {
        held.variances += bend_variances(filter, held.dx, held.dy, held.dz, components...);
    }
    if (!held.defined) return describe_too_close(sensor, report);
    const Matrix<Scalar, M> noise = held.noise() + rest;
    if constexpr (N == kTiltedStates) {
        const auto tilted = with_tilt<Scalar, Components...>(held, filter.state());
        describe_update(filter.correct(tilted.innovation, tilted.jacobian, noise, policy, hold),
                        which, policy, report);
    } else {
        describe_update(filter.correct(held.innovation, held.jacobian, noise, policy, hold), which,
                        policy, report);
    }
}

/// Calls visit(component, ...) with the models of the components that a sighting has. \return
/// whether it has any
template <typename Scalar, typename Visit>
[[gnu::always_inline]] inline bool with_components(const Sighting& sighting,
                                                   const SensorParams& sensor,
                                                   const Visit& visit) noexcept {
    const Bearing<Scalar> bearing{};
    const Elevation<Scalar> elevation{};
    const auto range = [&]() -> Range<Scalar> {
        return {Scalar(sensor.range_scale), Scalar(sensor.range_offset_m)};
    };
    switch (measured_components(sighting)) {
        case 0b001:
            return visit(bearing), true;
        case 0b010:
            return visit(elevation), true;
        case 0b100:
            return visit(range()), true;
        case 0b011:
            return visit(bearing, elevation), true;
        case 0b101:
            return visit(bearing, range()), true;
        case 0b110:
            return visit(elevation, range()), true;
        case 0b111:
            return visit(bearing, elevation, range()), true;
        default:
            return false;
    }
}

/// Of a sighting beyond the gate: where the rest is within, only the elevation is wrong, as by a
/// tilt, and is left out; else nothing tells them apart, and the rule of fusion decides.
template <Filter kFilter, typename Scalar, int N>
[[gnu::noinline, gnu::cold]] void fuse_apart(Ekf<Scalar, N>& filter, const Marker& marker,
                                             const Sighting& sighting, const SensorParams& sensor,
                                             const Policy& policy,
                                             SightingReport& report) noexcept {
    const auto fuse = [&](bool hold, const Sighting& part) {
        report.value = report.limit = NAN;
        (void)with_components<Scalar>(part, sensor, [&](const auto&... components) {
            fuse_compactly<kFilter>(filter, hold, marker, part, sensor, policy, report,
                                    components...);
        });
    };
    Sighting level = sighting;
    level.value[kElevation] = NAN;
    fuse(true, level);
    if (report.verdict == Verdict::fused)
        --report.dof;
    else
        fuse(false, sighting);
}

/// Holds the sighting against the map and fuses what it measured.
/// \tparam kFilter how it is linearised: at the state, or over the Gaussian about it
/// \pre the sighting's values are finite or NaN
template <Filter kFilter = Filter::ekf, typename Scalar, int N>
[[nodiscard]] SightingReport fuse_sighting(Ekf<Scalar, N>& filter, const Sample& sample,
                                           const MarkerMap& map, const SensorParams& sensor,
                                           const Policy& policy) noexcept {
    const Sighting& sighting = sample.payload.sighting;
    SightingReport report =
        blank_report(sample, Verdict::unknown_marker, sighting.id, components_of(sighting.value));
    const Marker* marker = map.find(sighting.id);
    if (marker == nullptr) return report;
    const bool measured = with_components<Scalar>(sighting, sensor, [&](const auto&... components) {
        constexpr bool separable =
            sizeof...(components) > 1 &&
            (... || (std::decay_t<decltype(components)>::kIndex == kElevation));
        if constexpr (kFilter == Filter::ukf)
            fuse_compactly<kFilter>(filter, separable, *marker, sighting, sensor, policy, report,
                                    components...);
        else
            fuse_components<separable>(filter, *marker, sighting, sensor, policy, report,
                                       components...);
        if (separable && report.verdict == Verdict::gate)
            fuse_apart<kFilter>(filter, *marker, sighting, sensor, policy, report);
    });
    if (!measured) report.verdict = Verdict::bad_value;
    return report;
}

}  // namespace pilotage
