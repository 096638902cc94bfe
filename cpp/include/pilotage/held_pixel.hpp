#pragma once
/// \file
/// What a sensor of pixels saw, in the same terms as held_sighting.hpp: held against a marker, or
/// turned into a bearing and an elevation for what reasons in angles.
///
/// A sighting of such a sensor is (u, v) [px] with their sigmas.

#include <cmath>
#include <limits>

#include "pilotage/held_sighting.hpp"
#include "pilotage/sensing/pixel_sighting.hpp"

namespace pilotage {

/// Variance of u (0) or v (1): the sighting's own where it states one.
[[nodiscard]] inline double pixel_variance(const Sighting& pixel, int component,
                                           const SensorParams& sensor) noexcept {
    const double stated = pixel.sigma[component];
    const double sigma = std::isnan(stated) ? sensor.sigma_pixel : stated;
    return sigma * sigma;
}

/// The model of a marker in the image of a sensor's camera.
template <typename Scalar>
[[nodiscard]] Mounted<PixelSighting<Scalar>, Scalar> pixel_model(
    const Marker& marker, const SensorParams& sensor) noexcept {
    return {
        {Vector<Scalar, 3>(Scalar(marker.x_m), Scalar(marker.y_m), Scalar(marker.z_m - sensor.z_m)),
         &sensor.camera},
        {Scalar(sensor.x_m), Scalar(sensor.y_m), Scalar(sensor.yaw_rad)}};
}

template <typename Scalar>
struct HeldPixel : HeldSighting<Scalar, 2> {
    Matrix<Scalar, 2> by_tilt;  ///< derivative by the body's pitch and roll (tilt.hpp)
};

/// Linearised at a pose of the robot; not defined where the camera cannot see the marker.
template <typename Scalar>
[[nodiscard]] HeldPixel<Scalar> hold_pixel_against(const Pose<Scalar>& robot, const Marker& marker,
                                                   const Sighting& pixel,
                                                   const SensorParams& sensor) noexcept {
    const auto h = pixel_model<Scalar>(marker, sensor).linearize(robot);
    HeldPixel<Scalar> held;
    held.defined = h.defined;
    if (!h.defined) return held;
    held.innovation << Scalar(pixel.value[0]) - h.value[0], Scalar(pixel.value[1]) - h.value[1];
    held.jacobian = h.jacobian;
    held.variances << Scalar(pixel_variance(pixel, 0, sensor)),
        Scalar(pixel_variance(pixel, 1, sensor));
    held.survey_variance = Scalar(marker.sigma_m) * Scalar(marker.sigma_m);
    held.dx = h.point[0];
    held.dy = h.point[1];
    held.dz = h.point[2];
    // Of v - w x v with w = (roll, -pitch, 0) in the robot's frame.
    const auto c = Scalar(std::cos(sensor.yaw_rad)), s = Scalar(std::sin(sensor.yaw_rad));
    Matrix<Scalar, 3, 2> by_tilt;
    by_tilt << c * held.dz, s * held.dz,  //
        -s * held.dz, c * held.dz,        //
        s * held.dy - c * held.dx, -c * held.dy - s * held.dx;
    held.by_tilt = h.by_point * by_tilt;
    return held;
}

/// Bearing and elevation of what is seen at a pixel, with their standard deviations, for the search
/// of a pose and for what a marker may be at all. How the two errors depend on each other is left
/// out. They are NaN straight above or below the camera, where there is no bearing.
[[nodiscard]] inline Sighting angles_of(const Sighting& pixel,
                                        const SensorParams& sensor) noexcept {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const auto h = sensor.camera.angles(Vector<double, 2>(pixel.value[0], pixel.value[1]));
    Sighting angles{{h.value[0], h.value[1], nan}, {nan, nan, nan}, pixel.id, pixel.label};
    for (int i = 0; i < 2; ++i) {
        double variance = 0;
        for (int j = 0; j < 2; ++j)
            variance += h.jacobian(i, j) * h.jacobian(i, j) * pixel_variance(pixel, j, sensor);
        angles.sigma[i] = std::sqrt(variance);
    }
    return angles;
}

}  // namespace pilotage
