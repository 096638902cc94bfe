#pragma once
/// \file
/// What was measured of the pose without a marker, into the filter.

#include <cmath>

#include "pilotage/examine.hpp"
#include "pilotage/filter/ukf.hpp"
#include "pilotage/params.hpp"
#include "pilotage/samples.hpp"
#include "pilotage/sensing/direct.hpp"
#include "pilotage/sensing/mounted.hpp"
#include "pilotage/sensing/wall_range.hpp"
#include "pilotage/sighting_report.hpp"

namespace pilotage {

/// The covariance that a fix states, or the configured one.
[[nodiscard]] inline Matrix<double, 3> noise_of(const Fix& fix,
                                                const SensorParams& sensor) noexcept {
    const Matrix<double, 3> stated = symmetric_of(fix.covariance);
    if (!stated.array().isNaN().all()) return stated;
    const Pose<double> sigma(sensor.sigma_position_m, sensor.sigma_position_m,
                             sensor.sigma_heading_rad);
    return sigma.cwiseAbs2().asDiagonal();
}

/// The pose of the robot that a whole fix tells, with its covariance: the sensor's heading error
/// moves the robot about the sensor.
struct FixedPose {
    Pose<double> pose;
    Matrix<double, 3> covariance;
};
[[nodiscard]] inline FixedPose robot_of(const Fix& fix, const SensorParams& sensor) noexcept {
    const double heading = fix.value[kHeading] - sensor.yaw_rad;
    const double c = std::cos(heading), s = std::sin(heading);
    const double ahead_x = c * sensor.x_m - s * sensor.y_m,
                 ahead_y = s * sensor.x_m + c * sensor.y_m;
    Matrix<double, 3> j = Matrix<double, 3>::Identity();
    j(kX, kHeading) = ahead_y;
    j(kY, kHeading) = -ahead_x;
    return {{fix.value[kX] - ahead_x, fix.value[kY] - ahead_y, wrap(heading)},
            j * noise_of(fix, sensor) * j.transpose()};
}

/// A beam's range as the map has it, with its variance: scale and offset taken out.
struct TrueRange {
    double range_m, variance_m2;
};
[[nodiscard]] inline TrueRange range_of(const Beam& beam, const SensorParams& sensor) noexcept {
    const double sigma = std::isnan(beam.sigma_m) ? sensor.sigma_range_m : beam.sigma_m;
    const double growth = sensor.sigma_range_per_m * beam.range_m;
    return {(beam.range_m - sensor.range_offset_m) / sensor.range_scale,
            (sigma * sigma + growth * growth) / (sensor.range_scale * sensor.range_scale)};
}

/// Variance of one component as it is stated or configured.
[[nodiscard]] inline double variance_of(const Sample& sample, const SensorParams& sensor,
                                        int component) noexcept {
    return sample.stream == Stream::beam
               ? range_of(sample.payload.beam, sensor).variance_m2
               : noise_of(sample.payload.fix, sensor)(component, component);
}

/// Fuses a fix, or a beam that met a wall of the map.
/// \param noise_scale estimated over stated sigma
/// \pre the numbers are sound (examine)
template <Filter kFilter, typename Scalar, int N>
[[nodiscard]] SightingReport fuse_fix(Ekf<Scalar, N>& filter, const Sample& sample,
                                      const WallMap& walls, const SensorParams& sensor,
                                      double noise_scale, const Policy& policy) noexcept {
    SightingReport report = blank_report(sample, Verdict::no_match);
    const auto tell = [&](const auto& update, const auto& which) {
        if (update.fault != UpdateFault::undefined) describe_update(update, which, policy, report);
    };
    const auto fuse = [&](const auto& measured, auto value, auto noise, const auto& which) {
        constexpr int M = decltype(value)::RowsAtCompileTime;
        using Model = Mounted<std::decay_t<decltype(measured)>, Scalar>;
        const Model model{measured,
                          {Scalar(sensor.x_m), Scalar(sensor.y_m), Scalar(sensor.yaw_rad)}};
        const Vector<Scalar, M> z = value.template cast<Scalar>();
        const Matrix<Scalar, M> r = (noise_scale * noise_scale * noise).template cast<Scalar>();
        if constexpr (kFilter == Filter::ukf) {
            tell(unscented_update(filter, model, z, r, policy), which);
        } else {
            const auto h = model.linearize(filter.state().template head<kPoseStates>());
            if (h.defined)
                tell(filter.correct(model.minus(z, h.value), h.jacobian, r, policy), which);
        }
    };
    if (sample.stream == Stream::beam) {
        const TrueRange range = range_of(sample.payload.beam, sensor);
        constexpr int which[] = {0};
        fuse(WallRange<Scalar>{&walls, Scalar(sample.payload.beam.angle_rad)},
             Vector<double, 1>(range.range_m), Matrix<double, 1>(range.variance_m2), which);
        return report;
    }
    const Fix& fix = sample.payload.fix;
    const Pose<double> value(fix.value);
    const Matrix<double, 3> noise = noise_of(fix, sensor);
    if (report.dof == 1) {
        constexpr int which[] = {kHeading};
        fuse(HeadingFix<Scalar>{}, Vector<double, 1>(value.tail<1>()),
             Matrix<double, 1>(noise.bottomRightCorner<1, 1>()), which);
    } else if (report.dof == 2) {
        constexpr int which[] = {kX, kY};
        fuse(PositionFix<Scalar>{}, Vector<double, 2>(value.head<2>()),
             Matrix<double, 2>(noise.topLeftCorner<2, 2>()), which);
    } else {
        constexpr int which[] = {kX, kY, kHeading};
        fuse(PoseFix<Scalar>{}, value, noise, which);
    }
    return report;
}

}  // namespace pilotage
