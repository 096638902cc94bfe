#pragma once
/// \file
/// A sensor somewhere on the robot: moves a model that speaks of the sensor's pose to the robot's
/// pose.

#include <cmath>

#include "pilotage/state.hpp"

namespace pilotage {

/// Sensor in the robot frame (x forward, y left, origin at the mid-axis).
template <typename Scalar>
struct PlanarMounting {
    Scalar x_m = 0, y_m = 0, yaw_rad = 0;
};

/// The model seen through the mounting. A sensor moves with the robot as a rigid body, so its pose
/// depends on the robot's heading as any planar displacement does: dx_s/dheading = -offset_y,
/// dy_s/dheading = offset_x.
template <typename Model, typename Scalar>
struct Mounted {
    static constexpr int kStates = Model::kStates;
    using Values = typename Model::Values;

    Model model;
    PlanarMounting<Scalar> mounting{};

    [[nodiscard]] auto linearize(const Pose<Scalar>& robot) const noexcept {
        using std::cos;
        using std::sin;
        const Scalar c = cos(robot[kHeading]), s = sin(robot[kHeading]);
        const Scalar offset_x = c * mounting.x_m - s * mounting.y_m;
        const Scalar offset_y = s * mounting.x_m + c * mounting.y_m;
        auto h = model.linearize(Pose<Scalar>(robot[kX] + offset_x, robot[kY] + offset_y,
                                              robot[kHeading] + mounting.yaw_rad));
        each<Values::RowsAtCompileTime>([&](int i) {
            h.jacobian(i, kHeading) += h.jacobian(i, kY) * offset_x - h.jacobian(i, kX) * offset_y;
        });
        return h;
    }

    [[nodiscard]] Values minus(const Values& z, const Values& predicted) const noexcept {
        return model.minus(z, predicted);
    }
};

}  // namespace pilotage
