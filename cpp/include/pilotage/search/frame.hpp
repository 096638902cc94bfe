#pragma once
/// \file
/// A pose as a frame of the plane: carries poses and points out of it and into it.

#include <cmath>

#include "pilotage/state.hpp"

namespace pilotage {

using Point = Vector<double, 2>;  ///< x [m], y [m]

[[nodiscard]] inline double cross(const Point& a, const Point& b) noexcept {
    return a[0] * b[1] - a[1] * b[0];
}

/// v turned by an angle of which `turn` is (cosine, sine).
[[nodiscard]] inline Point turned(const Point& turn, const Point& v) noexcept {
    return {turn[0] * v[0] - turn[1] * v[1], turn[1] * v[0] + turn[0] * v[1]};
}

/// A pose with the cosine and sine of its heading, which everything seen from it shares.
struct Frame {
    double x, y, heading, c, s;

    explicit Frame(const Pose<double>& pose) noexcept
        : x(pose[kX]),
          y(pose[kY]),
          heading(pose[kHeading]),
          c(std::cos(heading)),
          s(std::sin(heading)) {}

    /// The frame at `origin` that is turned by an angle of which `turn` is (cosine, sine).
    Frame(const Point& origin, const Point& turn) noexcept
        : x(origin[0]),
          y(origin[1]),
          heading(direction_of(turn[0], turn[1])),
          c(turn[0]),
          s(turn[1]) {}

    [[nodiscard]] Pose<double> pose() const noexcept { return {x, y, heading}; }

    /// A pose given in this frame, in the frame that this one is given in.
    [[nodiscard]] Pose<double> out_of(const Pose<double>& inner) const noexcept {
        return {x + c * inner[kX] - s * inner[kY], y + s * inner[kX] + c * inner[kY],
                wrap(heading + inner[kHeading])};
    }

    /// The other way round.
    [[nodiscard]] Pose<double> into(const Pose<double>& outer) const noexcept {
        const double dx = outer[kX] - x, dy = outer[kY] - y;
        return {c * dx + s * dy, c * dy - s * dx, wrap(outer[kHeading] - heading)};
    }
};

}  // namespace pilotage
