#pragma once
/// \file
/// Planar motion by a distance and a turn: what every wheeled robot's odometry comes down to.

#include <cmath>

#include "pilotage/congruence.hpp"
#include "pilotage/state.hpp"

namespace pilotage {

/// f(x, u) with its Jacobians by the pose (every planar motion's has the structure of HeadingShear) and by
/// the input.
template <typename Scalar, int Inputs>
struct MotionStep {
    Pose<Scalar> next;
    HeadingShear<Scalar> a;
    Matrix<Scalar, 3, Inputs> b;
};

/// How long a chord belongs to a distance driven while turning.
enum class Chord {
    midpoint,  ///< the distance itself, eqs. 16 and 17 of Kiriy and Buehler 2002
    arc,       ///< exact for constant rates, so a step cut in two ends where the whole step ends
};

/// u = (distance [m], turn [rad]); eqs. 16 to 18 of Kiriy and Buehler 2002 for Chord::midpoint.
/// Runnable example: tests/cpp/motion/test_unicycle.cpp.
template <typename Scalar, Chord kChord>
struct Unicycle {
    /// Direction of travel of the mid-axis relative to the heading (side slip, or a heading that is defined
    /// by something else than the wheels).
    Scalar slip_angle_rad = 0;

    [[nodiscard]] MotionStep<Scalar, 2> linearize(const Pose<Scalar>& x,
                                                  const Vector<Scalar, 2>& u) const noexcept {
        using std::cos;
        using std::sin;
        const Scalar distance = u[0], turn = u[1];
        const Scalar direction = x[kHeading] + turn / 2 + slip_angle_rad;
        const Scalar c = cos(direction), s = sin(direction);
        Scalar chord = 1, chord_by_turn = 0;  // per metre driven
        if constexpr (kChord == Chord::arc) chord_of(turn, chord, chord_by_turn);
        const Scalar dx = distance * chord * c, dy = distance * chord * s;
        MotionStep<Scalar, 2> step;
        step.next << x[kX] + dx, x[kY] + dy, wrap<Scalar>(x[kHeading] + turn);
        step.a = {dx, dy};
        step.b << chord * c, distance * chord_by_turn * c - dy / 2,  //
            chord * s, distance * chord_by_turn * s + dx / 2,        //
            Scalar(0), Scalar(1);
        return step;
    }

   private:
    /// sin(t/2) / (t/2) and its derivative by t; a series below 0.1 rad, where the quotient loses digits.
    static void chord_of(const Scalar& turn, Scalar& chord, Scalar& chord_by_turn) noexcept {
        using std::abs;
        using std::cos;
        using std::sin;
        const Scalar half = turn / 2, h2 = half * half;
        if (abs(turn) < Scalar(0.1)) {
            chord = 1 - h2 / 6 * (1 - h2 / 20 * (1 - h2 / 42 * (1 - h2 / 72)));
            chord_by_turn = -half / 6 * (1 - h2 / 10 * (1 - h2 / 28 * (1 - h2 / 54)));
        } else {
            chord = sin(half) / half;
            chord_by_turn = (cos(half) - chord) / turn;
        }
    }
};

}  // namespace pilotage
