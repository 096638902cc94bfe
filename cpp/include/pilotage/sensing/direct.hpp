#pragma once
/// \file
/// States that are measured as they are: fixes of the pose from outside, and sensors of the
/// velocities.

#include <algorithm>

#include "pilotage/sensing/measurement.hpp"
#include "pilotage/velocity_state.hpp"

namespace pilotage {

/// `Count` states from `First` on. A sensor that is not where the robot's frame is measures its own
/// pose: Mounted (mounted.hpp) makes an antenna's lever arm and a compass's offset of it.
template <typename Scalar, int First, int Count>
struct Direct {
    static constexpr int kStates = std::max(kPoseStates, First + Count);
    using Values = Vector<Scalar, Count>;

    [[nodiscard]] Measurement<Scalar, Count, kStates> linearize(
        const Vector<Scalar, kStates>& x) const noexcept {
        Measurement<Scalar, Count, kStates> h;
        h.value = x.template segment<Count>(First);
        h.jacobian.setZero();
        h.jacobian.template middleCols<Count>(First).setIdentity();
        return h;
    }

    /// Measured less predicted; a heading wraps.
    [[nodiscard]] Values minus(const Values& z, const Values& predicted) const noexcept {
        return entries<Values>([&](int i, int) {
            const Scalar difference = z[i] - predicted[i];
            return First + i == kHeading ? wrap(difference) : difference;
        });
    }
};

template <typename Scalar>
using PositionFix = Direct<Scalar, kX, 2>;  ///< x, y [m] in frame map
template <typename Scalar>
using HeadingFix = Direct<Scalar, kHeading, 1>;  ///< rad, from +x of frame map
template <typename Scalar>
using PoseFix = Direct<Scalar, kX, 3>;  ///< x, y [m], heading [rad]
template <typename Scalar>
using Speed = Direct<Scalar, kSpeed, 1>;  ///< m/s, from encoders
template <typename Scalar>
using YawRate = Direct<Scalar, kYawRate, 1>;  ///< rad/s, from a gyro

}  // namespace pilotage
