#pragma once
/// \file
/// Planar motion by a distance and a turn: what every wheeled robot's odometry comes down to.

#include <cmath>

#include "pilotage/congruence.hpp"
#include "pilotage/state.hpp"

namespace pilotage {

/// f(x, u) with its Jacobians by the pose (every planar motion's has the structure of HeadingShear)
/// and by the input.
template <typename Scalar, int Inputs>
struct MotionStep {
    Pose<Scalar> next;
    HeadingShear<Scalar> a;
    Matrix<Scalar, 3, Inputs> b;
};

/// Which chord stands for a distance driven while turning.
enum class Chord {
    midpoint,  ///< the distance along the mid heading, eqs. 16 and 17 of Kiriy and Buehler 2002
    arc,       ///< exact for constant rates, so a step cut in two ends where the whole step ends
    tangent,   ///< the distance along the heading at the start: a move, then a turn on the spot
};

/// u = (distance [m], turn [rad]); eqs. 16 to 18 of Kiriy and Buehler 2002 for Chord::midpoint.
/// Runnable example: tests/cpp/motion/test_unicycle.cpp.
template <typename Scalar, Chord kChord>
struct Unicycle {
    /// Direction of travel of the mid-axis relative to the heading (side slip, or a heading that is
    /// defined by something else than the wheels).
    Scalar slip_angle_rad = 0;

    [[nodiscard]] MotionStep<Scalar, 2> linearize(const Pose<Scalar>& x,
                                                  const Vector<Scalar, 2>& u) const noexcept {
        using std::cos;
        using std::sin;
        const Scalar distance = u[0], turn = u[1];
        const Scalar lean =
            Scalar(kChord == Chord::tangent ? 0 : 0.5);  // of the chord, by the turn
        const Scalar direction = x[kHeading] + turn * lean + slip_angle_rad;
        const Scalar c = cos(direction), s = sin(direction);
        Scalar chord = 1, chord_by_turn = 0;  // per metre driven
        if constexpr (kChord == Chord::arc) chord_of(turn, chord, chord_by_turn);
        const Scalar forward_x = chord * c, forward_y = chord * s;  // per metre driven
        const Scalar dx = distance * forward_x, dy = distance * forward_y;
        const Scalar longer = times(distance, chord_by_turn);
        MotionStep<Scalar, 2> step;
        step.next[kX] = x[kX] + dx;
        step.next[kY] = x[kY] + dy;
        step.next[kHeading] = wrap<Scalar>(x[kHeading] + turn);
        step.a = {dx, dy};
        step.b(kX, 0) = forward_x;
        step.b(kY, 0) = forward_y;
        step.b(kHeading, 0) = 0;
        step.b(kX, 1) = times(c, longer) + times(dy, -lean);
        step.b(kY, 1) = times(s, longer) + times(dx, lean);
        step.b(kHeading, 1) = 1;
        return step;
    }

   private:
    /// sin(t/2) / (t/2) and its derivative by t; a series below 0.1 rad, where the quotient loses
    /// digits.
    static void chord_of(const Scalar& turn, Scalar& chord, Scalar& chord_by_turn) noexcept {
        using std::abs;
        using std::cos;
        using std::sin;
        const Scalar half = turn / 2, h2 = half * half;
        if (abs(turn) < Scalar(0.1)) {
            const auto part = [&](int divisor) { return h2 * Scalar(1.0 / divisor); };
            chord = 1 - part(6) * (1 - part(20) * (1 - part(42) * (1 - part(72))));
            chord_by_turn =
                half * Scalar(-1.0 / 6) * (1 - part(10) * (1 - part(28) * (1 - part(54))));
        } else {
            chord = sin(half) / half;
            chord_by_turn = (cos(half) - chord) / turn;
        }
    }
};

/// The assignment's robot: u = (d [m], a [rad]) is a straight move, then a turn on the spot.
template <typename Scalar>
using MoveAndTurn = Unicycle<Scalar, Chord::tangent>;

}  // namespace pilotage
