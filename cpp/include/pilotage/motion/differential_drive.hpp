#pragma once
/// \file
/// The first paper's robot: two encoder wheels, and a gyro that may give the heading.
/// E. Kiriy and M. Buehler, "Three-state Extended Kalman Filter for Mobile Robot Localization",
/// 2002.

#include "pilotage/motion/unicycle.hpp"

namespace pilotage {

/// u = (left travel [m], right travel [m]): heading from the wheels. Eqs. 16 to 20, with A of eq.
/// 21; eq. 22 is the unicycle's B times the derivatives of eqs. 19 and 20.
///
/// Also eqs. 31 to 35 of Tamas et al. 2008 as they should read: the turn is the difference of the
/// wheels over their distance, without the arctan, and the heading that of the middle of the turn.
template <typename Scalar>
struct DifferentialDrive {
    Scalar track_width_m;

    [[nodiscard]] MotionStep<Scalar, 2> linearize(const Pose<Scalar>& x,
                                                  const Vector<Scalar, 2>& u) const noexcept {
        const Scalar to_turn = 1 / track_width_m;
        const Vector<Scalar, 2> driven((u[1] + u[0]) / 2, (u[1] - u[0]) * to_turn);
        auto step = Unicycle<Scalar, Chord::midpoint>{}.linearize(x, driven);
        each<3>([&](int i) {
            const Scalar by_distance = step.b(i, 0) / 2, by_turn = step.b(i, 1) * to_turn;
            step.b(i, 0) = by_distance - by_turn;
            step.b(i, 1) = by_distance + by_turn;
        });
        return step;
    }
};

/// u = (left travel [m], right travel [m], turn by the gyro [rad]): heading from the gyro. Eqs. 16
/// to 19; the printed eq. 22 does not hold here: the wheels move the pose along the heading only,
/// and the gyro has a column of its own.
template <typename Scalar>
struct GyroDrive {
    [[nodiscard]] MotionStep<Scalar, 3> linearize(const Pose<Scalar>& x,
                                                  const Vector<Scalar, 3>& u) const noexcept {
        const Vector<Scalar, 2> driven((u[1] + u[0]) / 2, u[2]);
        const auto step = Unicycle<Scalar, Chord::midpoint>{}.linearize(x, driven);
        MotionStep<Scalar, 3> result;
        result.a = {step.a.dx, step.a.dy};
        each<3>([&](int i) {
            result.next[i] = step.next[i];
            result.b(i, 0) = result.b(i, 1) = step.b(i, 0) / 2;
            result.b(i, 2) = step.b(i, 1);
        });
        return result;
    }
};

}  // namespace pilotage
