#pragma once
/// \file
/// Where the robot is, given its heading, by two sightings: lines and circles about the markers,
/// shifted by what the robot drove since.

#include <cmath>

#include "pilotage/search/heading_equation.hpp"

namespace pilotage {

/// Up to two places in frame map.
struct Places {
    Point place[2];
    int count = 0;

    void add(const Point& p) noexcept { place[count++] = p; }
};

/// The robot's place by a clue whose marker is a point, if its heading has the direction `turn`.
[[nodiscard]] inline Point place_by_point(const Clue& clue, const Point& turn) noexcept {
    return clue.marker - turned(turn, clue.point());
}

/// Whether the marker is where the bearing points, not behind.
[[nodiscard]] inline bool ahead(const Clue& ray, const Point& place, const Point& turn) noexcept {
    return turned(turn, ray.along).dot(ray.marker - place - turned(turn, ray.place)) > 0;
}

/// Where two clues put the robot, if its heading has the direction (cosine, sine) `turn`. A marker
/// behind a bearing is none.
[[nodiscard]] inline Places meet(const Clue& one, const Clue& two, const Point& turn) noexcept {
    // The robot is where a ray from `centre` against `along` leads, at `distance_m` from it.
    const Point centre = one.marker - turned(turn, one.place);
    const Point apart = two.marker - turned(turn, two.place) - centre;
    Places places;
    if (one.has_direction && two.has_direction) {
        const Point u = turned(turn, one.along), v = turned(turn, two.along);
        const double sine = cross(u, v);
        // apart = s2 v - s1 u
        const double s1 = -cross(apart, v) / sine, s2 = -cross(apart, u) / sine;
        if (s1 > 0 && s2 > 0) places.add(centre - s1 * u);
        return places;
    }
    if (one.has_direction || two.has_direction) {
        const Clue& ray = one.has_direction ? one : two;
        const Clue& circle = one.has_direction ? two : one;
        const Point from = one.has_direction ? centre : centre + apart;
        const Point to = one.has_direction ? apart : Point(-apart);  // the circle's centre
        const Point u = turned(turn, ray.along);
        const double nearest = -u.dot(to), aside = cross(u, to);
        const double squared = circle.distance_m * circle.distance_m - aside * aside;
        if (squared < 0) return places;
        for (const double half : {std::sqrt(squared), -std::sqrt(squared)})
            if (nearest + half > 0) places.add(from - (nearest + half) * u);
        return places;
    }
    const double base_squared = apart.squaredNorm();
    if (!(base_squared > 0)) return places;
    const double r1 = one.distance_m * one.distance_m, r2 = two.distance_m * two.distance_m;
    const double along = (r1 - r2 + base_squared) / (2 * base_squared);
    const double aside = std::sqrt(std::max(0.0, r1 / base_squared - along * along));
    // Circles that just miss each other by noise meet halfway.
    constexpr double slack = 1.1;
    const double reach = slack * (one.distance_m + two.distance_m);
    const double gap = std::abs(one.distance_m - two.distance_m) / slack;
    if (base_squared > reach * reach || base_squared < gap * gap) return places;
    const Point normal(-apart[1], apart[0]);
    places.add(centre + along * apart + aside * normal);
    if (aside > 0) places.add(centre + along * apart - aside * normal);
    return places;
}

}  // namespace pilotage
