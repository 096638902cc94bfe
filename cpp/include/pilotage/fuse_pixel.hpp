#pragma once
/// \file
/// Where a marker was seen in an image, into the filter, and what became of it.

#include "pilotage/filter/ukf.hpp"
#include "pilotage/held_pixel.hpp"
#include "pilotage/sighting_report.hpp"

namespace pilotage {

/// Whether the projection bends within the pose's own uncertainty by more than pixels are noisy,
/// as fuse_sighting.hpp has it: on a close pass, and of an unsure heading.
template <typename Scalar, int N>
[[nodiscard]] bool bends(const HeldPixel<Scalar>& held, const Ekf<Scalar, N>& filter,
                         const CameraModel& camera) noexcept {
    const auto& p = filter.covariance();
    const Scalar slant_squared = held.dx * held.dx + held.dy * held.dy + held.dz * held.dz;
    const Scalar bend = Scalar(camera.intrinsics().fx_px) *
                        (p(kHeading, kHeading) + (p(kX, kX) + p(kY, kY)) / slant_squared);
    return bend * bend > Scalar(0.8) * held.variances[0];
}

/// \param unscented linearised over the Gaussian about the state, as on a close pass by either
/// filter; where the camera does not see the marker from all of it, at the state
template <typename Scalar, int N>
[[nodiscard, gnu::noinline]] SightingReport fuse_pixel(Ekf<Scalar, N>& filter, const Sample& sample,
                                                       const MarkerMap& map,
                                                       const SensorParams& sensor,
                                                       const Policy& policy,
                                                       bool unscented) noexcept {
    constexpr int which[] = {0, 1};
    const Sighting& pixel = sample.payload.sighting;
    SightingReport report = blank_report(sample, Verdict::unknown_marker);
    const Marker* marker = map.find(pixel.id);
    if (marker == nullptr) return report;
    HeldPixel<Scalar> held = hold_pixel_against<Scalar>(filter.state().template head<kPoseStates>(),
                                                        *marker, pixel, sensor);
    report.verdict = Verdict::out_of_view;
    if (!held.defined) return report;
    Matrix<Scalar, 2> rest = Matrix<Scalar, 2>::Zero();
    if (unscented || (policy.fusion != Fusion::plain && bends(held, filter, sensor.camera))) {
        const auto over = unscented_measurement(pixel_model<Scalar>(*marker, sensor), filter);
        if (over.defined) {
            held.innovation << Scalar(pixel.value[0]) - over.value[0],
                Scalar(pixel.value[1]) - over.value[1];
            held.jacobian = over.jacobian;
            rest = over.noise;
        }
    }
    const Matrix<Scalar, 2> noise = held.noise() + rest;
    if constexpr (N == kTiltedStates) {
        Matrix<Scalar, 2, N> jacobian = Matrix<Scalar, 2, N>::Zero();
        jacobian.template leftCols<kPoseStates>() = held.jacobian;
        jacobian.template middleCols<2>(kPitch) = held.by_tilt;
        held.innovation -= held.by_tilt * filter.state().template segment<2>(kPitch);
        describe_update(filter.correct(held.innovation, jacobian, noise, policy), which, policy,
                        report);
    } else {
        describe_update(filter.correct(held.innovation, held.jacobian, noise, policy), which,
                        policy, report);
    }
    return report;
}

/// The same by either filter, called as fuse_sighting.
template <Filter kFilter, typename Scalar, int N>
[[nodiscard]] SightingReport fuse_pixel(Ekf<Scalar, N>& filter, const Sample& sample,
                                        const MarkerMap& map, const SensorParams& sensor,
                                        const Policy& policy) noexcept {
    return fuse_pixel(filter, sample, map, sensor, policy, kFilter == Filter::ukf);
}

}  // namespace pilotage
