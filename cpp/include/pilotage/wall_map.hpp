#pragma once
/// \file
/// The walls of a world, and what a beam meets among them.

#include <limits>
#include <utility>
#include <vector>

#include "pilotage/state.hpp"

namespace pilotage {

/// A straight piece of wall in frame map.
struct Wall {
    double from_x_m, from_y_m, to_x_m, to_y_m;
};

/// Where a beam meets a wall; without one the range is infinite.
template <typename Scalar>
struct WallHit {
    Scalar range_m = kNothing;
    Vector<Scalar, 2> normal = Vector<Scalar, 2>::Zero();  ///< as long as the wall, of either side

    [[nodiscard]] bool any() const noexcept { return range_m < kNothing; }

   private:
    static constexpr float kNothing = std::numeric_limits<float>::infinity();
};

/// Walls in any order, boundary and obstacles alike; built once, then only read.
class WallMap {
   public:
    WallMap() = default;
    explicit WallMap(std::vector<Wall> walls) : walls_(std::move(walls)) {}

    [[nodiscard]] const std::vector<Wall>& walls() const noexcept { return walls_; }

    /// The nearest wall ahead.
    /// \param x_m, y_m where the beam starts, frame map
    /// \param forward its direction, a unit vector
    template <typename Scalar>
    [[nodiscard]] WallHit<Scalar> cast(const Scalar& x_m, const Scalar& y_m,
                                       const Vector<Scalar, 2>& forward) const noexcept {
        WallHit<Scalar> nearest;
        for (const Wall& wall : walls_) {
            const Vector<Scalar, 2> from(Scalar(wall.from_x_m) - x_m, Scalar(wall.from_y_m) - y_m);
            const Vector<Scalar, 2> to(Scalar(wall.to_x_m) - x_m, Scalar(wall.to_y_m) - y_m);
            const Scalar from_left = cross(forward, from), to_left = cross(forward, to);
            // A corner lies on one side of the beam for both of its walls, so none slips between.
            if ((from_left > 0) == (to_left > 0)) continue;
            const Vector<Scalar, 2> along = to - from;
            const Scalar share = from_left / (from_left - to_left);
            const Scalar range = dot(forward, from) + share * dot(forward, along);
            if (range > 0 && range < nearest.range_m) nearest = {range, {-along[1], along[0]}};
        }
        return nearest;
    }

   private:
    template <typename Scalar>
    [[nodiscard]] static Scalar dot(const Vector<Scalar, 2>& a,
                                    const Vector<Scalar, 2>& b) noexcept {
        return a[0] * b[0] + a[1] * b[1];
    }

    /// Positive where b is to the left of a.
    template <typename Scalar>
    [[nodiscard]] static Scalar cross(const Vector<Scalar, 2>& a,
                                      const Vector<Scalar, 2>& b) noexcept {
        return a[0] * b[1] - a[1] * b[0];
    }

    std::vector<Wall> walls_;
};

}  // namespace pilotage
