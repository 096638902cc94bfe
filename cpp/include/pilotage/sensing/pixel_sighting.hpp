#pragma once
/// \file
/// Where a camera sees a marker in its image.

#include "pilotage/sensing/camera_model.hpp"
#include "pilotage/sensing/measurement.hpp"

namespace pilotage {

/// Where a marker is in the image, and where it stands: what turns the camera moves that.
template <typename Scalar>
struct SeenPixel : Measurement<Scalar, 2, kPoseStates> {
    Vector<Scalar, 3> point;        ///< the marker in the level sensor frame [m]
    Matrix<Scalar, 2, 3> by_point;  ///< derivative of the pixel
};

/// (u, v) [px] of a marker: the projection of the map through the pose, section 2 of Kiriy and
/// Buehler 2002.
template <typename Scalar>
struct PixelSighting {
    static constexpr int kStates = kPoseStates;
    using Values = Vector<Scalar, 2>;

    Vector<Scalar, 3> marker_above_sensor;  ///< m: x and y in frame map, z above the sensor
    const CameraModel* camera;              ///< not owned

    /// Not defined where the camera cannot see the marker, but defined beyond the image's borders.
    [[nodiscard]] SeenPixel<Scalar> linearize(const Pose<Scalar>& sensor) const noexcept {
        using std::cos;
        using std::sin;
        const Scalar c = cos(sensor[kHeading]), s = sin(sensor[kHeading]);
        const Scalar dx = marker_above_sensor[0] - sensor[kX];
        const Scalar dy = marker_above_sensor[1] - sensor[kY];
        SeenPixel<Scalar> h;
        h.point << c * dx + s * dy, c * dy - s * dx, marker_above_sensor[2];
        const Measurement<Scalar, 2, 3> seen = camera->project(h.point);
        h.value = seen.value;
        h.defined = seen.defined;
        h.by_point = seen.jacobian;
        each<2>([&](int i) {
            const Scalar ahead = h.by_point(i, 0), left = h.by_point(i, 1);
            h.jacobian(i, kX) = s * left - c * ahead;
            h.jacobian(i, kY) = -s * ahead - c * left;
            h.jacobian(i, kHeading) = ahead * h.point[1] - left * h.point[0];
        });
        return h;
    }

    [[nodiscard]] Values minus(const Values& z, const Values& predicted) const noexcept {
        return z - predicted;
    }
};

}  // namespace pilotage
