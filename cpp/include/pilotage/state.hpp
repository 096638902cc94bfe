#pragma once
/// \file
/// The state: pose in frame map, then the calibration states. Its own plus and minus wrap the
/// heading; with each measurement model's minus they are the only places where an angle wraps.

#include <Eigen/Core>

#include "pilotage/angle.hpp"
#include "pilotage/entrywise.hpp"

namespace pilotage {

template <typename Scalar, int Size>
using Vector = Eigen::Matrix<Scalar, Size, 1>;

template <typename Scalar, int Rows, int Cols = Rows>
using Matrix = Eigen::Matrix<Scalar, Rows, Cols>;

/// Pose: x [m], y [m], heading [rad].
template <typename Scalar>
using Pose = Vector<Scalar, 3>;

/// Places in the state vector.
enum StateIndex : int {
    kX = 0,              ///< m, frame map
    kY = 1,              ///< m, frame map
    kHeading = 2,        ///< rad, counter-clockwise from +x
    kGyroBias = 3,       ///< rad/s, subtracted from the measured rate
    kDistanceScale = 4,  ///< true distance over measured distance
    kRotationScale = 5,  ///< true turn over measured turn
    kPitch = 6,          ///< rad, of the body against the ground, nose up
    kRoll = 7,           ///< rad, of the body against the ground, left side up
};

inline constexpr int kPoseStates = 3;
inline constexpr int kCalibratedStates = 6;
inline constexpr int kTiltedStates = 8;

/// The covariance of independent components, given their variances.
template <typename Scalar, int N>
[[nodiscard]] Matrix<Scalar, N> diagonal(const Vector<Scalar, N>& variances) noexcept {
    return symmetric<Matrix<Scalar, N>>(
        [&](int i, int j) { return i == j ? variances[i] : Scalar(0); });
}

/// x + dx.
template <typename Scalar, int N>
[[nodiscard]] Vector<Scalar, N> plus(const Vector<Scalar, N>& x,
                                     const Vector<Scalar, N>& dx) noexcept {
    auto result = entries<Vector<Scalar, N>>([&](int i, int) { return x[i] + dx[i]; });
    result[kHeading] = wrap(result[kHeading]);
    return result;
}

/// The dx with plus(b, dx) = a.
template <typename Scalar, int N>
[[nodiscard]] Vector<Scalar, N> minus(const Vector<Scalar, N>& a,
                                      const Vector<Scalar, N>& b) noexcept {
    auto result = entries<Vector<Scalar, N>>([&](int i, int) { return a[i] - b[i]; });
    result[kHeading] = wrap(result[kHeading]);
    return result;
}

/// Where a filter's state lives: what its plus and minus are. This is the robot's, above.
struct HeadingSpace {
    template <typename State>
    [[nodiscard]] static State plus(const State& x, const State& dx) noexcept {
        return pilotage::plus(x, dx);
    }
    template <typename State>
    [[nodiscard]] static State minus(const State& a, const State& b) noexcept {
        return pilotage::minus(a, b);
    }
};

/// No entry is an angle.
struct PlainSpace {
    template <typename State>
    [[nodiscard]] static State plus(const State& x, const State& dx) noexcept {
        return x + dx;
    }
    template <typename State>
    [[nodiscard]] static State minus(const State& a, const State& b) noexcept {
        return a - b;
    }
};

}  // namespace pilotage
