#pragma once
/// \file
/// Headings in closed form from two or three sightings, also of different times.
///
/// In the robot's frame of now the marker m stands at R'(m - t), where t is the robot's place and R
/// its rotation. A bearing says that this lies on a line, a distance that it lies on a circle. Two
/// bearings, or one point, give R't linearly in the cosine and sine of the heading. What remains of
/// the third sighting then is one equation, \f$a \cos\theta + b \sin\theta = c\f$.

#include <cmath>

#include "pilotage/search/clue.hpp"

namespace pilotage {

/// Up to two directions, as (cosine, sine).
struct Headings {
    Point direction[2];
    int count = 0;
};

/// \f$a \cos\theta + b \sin\theta = c\f$
struct HeadingEquation {
    double a = 0, b = 0, c = 0;

    /// Both headings. Where noise leaves the equation just without a solution, the nearest to one.
    [[nodiscard]] Headings solve() const noexcept {
        constexpr double slack = 1.1;
        const double squared = a * a + b * b;
        Headings result;
        if (!(squared > 0) || std::abs(c) > slack * std::sqrt(squared)) return result;
        const double along = c / squared;
        const double root = std::sqrt(std::max(0.0, squared - c * c)) / squared;
        for (const double side : {root, -root}) {
            Point& direction = result.direction[result.count++];
            direction = Point(a * along - b * side, b * along + a * side).normalized();
            if (root == 0) break;
        }
        return result;
    }
};

/// Three bearings. From one place (c = 0) this is the problem that ToTal solves (V. Pierlot and M.
/// Van Droogenbroeck, "A New Three Object Triangulation Algorithm for Mobile Robot Positioning",
/// IEEE Transactions on Robotics 30(3), 2014). Its D, which is zero on the circle through the
/// markers where no pose follows, is \f$(a^2 + b^2) / (\lambda_1 \lambda_2 \lambda_3)\f$.
///
/// With the lines' normals \f$n_i\f$, \f$\lambda_1 = n_2 \times n_3\f$ and so on round, \f$\sum
/// \lambda_i n_i = 0\f$ takes R't out of \f$n_i \cdot (R'm_i - R't - p_i) = 0\f$.
struct ThreeBearings {
    Point weighted[3];  ///< \f$\lambda_i n_i\f$
    double c = 0;

    /// \pre they have directions
    ThreeBearings(const View& first, const View& second, const View& third) noexcept {
        const View* views[] = {&first, &second, &third};
        for (int i = 0; i < 3; ++i) {
            const Point& along = views[i]->along;
            weighted[i] = cross(views[(i + 1) % 3]->along, views[(i + 2) % 3]->along) *
                          Point(-along[1], along[0]);
            c += weighted[i].dot(views[i]->place.head<2>());
        }
    }

    /// How far the bearings are from having two of one direction: the sine between the nearest two.
    [[nodiscard]] double spread() const noexcept {
        return std::sqrt(std::min(
            {weighted[0].squaredNorm(), weighted[1].squaredNorm(), weighted[2].squaredNorm()}));
    }

    [[nodiscard]] HeadingEquation of(const Point& m1, const Point& m2,
                                     const Point& m3) const noexcept {
        return {weighted[0].dot(m1) + weighted[1].dot(m2) + weighted[2].dot(m3),
                cross(weighted[0], m1) + cross(weighted[1], m2) + cross(weighted[2], m3), c};
    }
};

/// A point and another marker's bearing or, where that has none, its distance.
/// \pre point.is_point(), and `other` has one of the two
[[nodiscard]] inline HeadingEquation point_and(const Clue& point, const Clue& other) noexcept {
    const Point apart = other.marker - point.marker;   // R' of it is seen from the robot
    const Point offset = point.point() - other.place;  // R' apart + offset: sensor to marker
    if (other.has_direction) {
        const Point normal(-other.along[1], other.along[0]);
        return {normal.dot(apart), cross(normal, apart), -normal.dot(offset)};
    }
    const double squared = other.distance_m * other.distance_m;
    return {2 * offset.dot(apart), 2 * cross(offset, apart),
            squared - apart.squaredNorm() - offset.squaredNorm()};
}

}  // namespace pilotage
