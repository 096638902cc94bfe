#pragma once
/// \file
/// Where a marker stands in the robot frame, measured as a point: A. Sousa, P. Costa, A. Moreira
/// and A. Carvalho, "Self Localization of an Autonomous Robot: Using an EKF to merge Odometry and
/// Vision based Landmarks".

#include <cmath>

#include "pilotage/sensing/measurement.hpp"

namespace pilotage {

/// (forward, leftward) [m] from the sensor to the marker: eqs. 8 and 9.
template <typename Scalar>
struct RelativePosition {
    static constexpr int kStates = kPoseStates;
    using Values = Vector<Scalar, 2>;

    Vector<Scalar, 2> marker_m;  ///< frame map

    [[nodiscard]] Measurement<Scalar, 2, kStates> linearize(
        const Pose<Scalar>& sensor) const noexcept {
        using std::cos;
        using std::sin;
        const Scalar c = cos(sensor[kHeading]), s = sin(sensor[kHeading]);
        const Scalar dx = marker_m[0] - sensor[kX], dy = marker_m[1] - sensor[kY];
        Measurement<Scalar, 2, kStates> h;
        h.value << c * dx + s * dy, c * dy - s * dx;
        h.jacobian << -c, -s, h.value[1], s, -c, -h.value[0];
        return h;
    }

    [[nodiscard]] Values minus(const Values& z, const Values& predicted) const noexcept {
        return z - predicted;
    }
};

/// R of a relative position, eqs. 13 to 16: a standard deviation in proportion to the distance
/// along the line of sight, and one of the angle across it. Eq. 15 is printed transposed, which
/// mirrors the ellipse. With the relative position itself as axis the distance enters by its
/// length.
/// \param relative_m (forward, leftward), measured or predicted
template <typename Scalar>
[[nodiscard]] Matrix<Scalar, 2> relative_position_noise(const Vector<Scalar, 2>& relative_m,
                                                        Scalar sigma_distance_per_m,
                                                        Scalar sigma_bearing_rad) noexcept {
    const Vector<Scalar, 2> along = sigma_distance_per_m * relative_m;
    const Vector<Scalar, 2> across =
        sigma_bearing_rad * Vector<Scalar, 2>(-relative_m[1], relative_m[0]);
    return along * along.transpose() + across * across.transpose();
}

}  // namespace pilotage
