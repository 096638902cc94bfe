// Poses from the fewest sightings that give one: of them, only the best will be looked at closely.

#include <cmath>

#include "pilotage/search/heading_equation.hpp"
#include "pilotage/search/meet.hpp"
#include "pilotage/search/pose_search.hpp"
#include "pilotage/search/rigid_fit.hpp"

namespace pilotage {

/// Two points, or a point and something else of another marker.
void PoseSearch::propose_by_points() noexcept {
    const auto propose = [&](const Clue& one, const Clue& two) {
        if (one.marker == two.marker || !(one.is_point() || two.is_point())) return;
        if (one.is_point() && two.is_point()) {
            if (!same_distance(one, two)) return;
            const Point turn = turn_by(one, two);
            return consider(place_by(one, two, turn), turn);
        }
        const Clue& point = one.is_point() ? one : two;
        const Headings headings = point_and(point, one.is_point() ? two : one).solve();
        for (int i = 0; i < headings.count; ++i)
            consider(place_by_point(point, headings.direction[i]), headings.direction[i]);
    };
    each_subset<2>(seed_count_, turn_, [&](const Subset<2>& pair) {
        const int before = considered_;
        each_clue(seed(pair[0]), [&](const Clue& one) {
            work(markers());
            each_clue(seed(pair[1]), [&](const Clue& two) { propose(one, two); });
        });
        return go_on(before);
    });
}

/// Three bearings of different markers.
void PoseSearch::propose_by_bearings() noexcept {
    constexpr double kLeastSpread = 0.1;
    const auto propose = [&](const HeadingEquation& equation, const Clue& one, const Clue& two,
                             const Clue& last) {
        const Headings headings = equation.solve();
        for (int i = 0; i < headings.count; ++i) {
            const Point& turn = headings.direction[i];
            const Places places = meet(one, two, turn);
            if (places.count > 0 && ahead(last, places.place[0], turn))
                consider(places.place[0], turn);
        }
    };
    each_subset<3>(seed_count_, turn_, [&](const Subset<3>& triple) {
        for (const int i : triple)
            if (!seed(i).has(kBearing) || seed(i).has(kRange)) return true;
        const ThreeBearings three(seed(triple[0]), seed(triple[1]), seed(triple[2]));
        if (three.spread() < kLeastSpread) return true;
        const int before = considered_;
        each_ray(seed(triple[0]), [&](const Clue& one) {
            each_ray(seed(triple[1]), [&](const Clue& two) {
                if (two.marker == one.marker || !work(kWork * markers())) return;
                each_ray(seed(triple[2]), [&](const Clue& last) {
                    if (last.marker == one.marker || last.marker == two.marker) return;
                    propose(three.of(one.marker, two.marker, last.marker), one, two, last);
                });
            });
        });
        return go_on(before);
    });
}

/// Two sightings that leave a curve of poses: headings all round.
void PoseSearch::propose_by_arcs() noexcept {
    constexpr int kArcs = 3;
    int arcs = 0;
    std::uint64_t used = 0;  // each arc by other sightings
    each_subset<2>(seed_count_, turn_, [&](const Subset<2>& pair) {
        const View &one = seed(pair[0]), &two = seed(pair[1]);
        const bool rays = one.has(kBearing) && two.has(kBearing);
        const std::uint64_t both = std::uint64_t{1} << pair[0] | std::uint64_t{1} << pair[1];
        const bool known = one.marker != nullptr && two.marker != nullptr;
        if ((used & both) != 0 || (known && one.marker == two.marker) || (rays && !known))
            return true;
        each_clue(one, [&](const Clue& first) {
            each_clue(two, [&](const Clue& second) {
                if (first.marker != second.marker && work_ > 0) propose_arc(first, second);
            });
        });
        used |= both;
        return ++arcs < kArcs && work_ > 0;
    });
}

void PoseSearch::propose_arc(const Clue& one, const Clue& two) noexcept {
    constexpr int kRays = 48, kCircles = 12;  // headings: a bearing tells it more sharply
    if (one.is_point() || two.is_point()) return;
    const int steps = one.has_direction && two.has_direction ? kRays : kCircles;
    for (int i = 0; i < steps; ++i) {
        const double heading = 2 * kPi<double> * i / steps;
        const Point turn(std::cos(heading), std::sin(heading));
        const Places places = meet(one, two, turn);
        work(kWork);
        for (int k = 0; k < places.count; ++k) consider(places.place[k], turn);
    }
}

}  // namespace pilotage
