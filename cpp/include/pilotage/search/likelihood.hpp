#pragma once
/// \file
/// How likely a sighting is from a pose: a Gaussian about what geometry predicts, or clutter.

#include <cmath>
#include <limits>

#include "pilotage/search/evidence.hpp"
#include "pilotage/sensing/bearing.hpp"
#include "pilotage/sensing/elevation.hpp"
#include "pilotage/sensing/range.hpp"

namespace pilotage {

/// A sighting held against one marker.
struct Match {
    /// One component: measured less predicted, 1 / variance, and the prediction's derivatives by
    /// the robot's x, y and heading of now.
    struct Row {
        double residual, information, by_x, by_y, by_heading;
    };
    Row rows[3];
    int count = 0;
    double nis = 0;
    double spread = 1;  ///< product of 2 pi variance

    /// Of the measured values.
    [[nodiscard]] double density() const noexcept { return std::exp(-nis / 2) / std::sqrt(spread); }
};

/// \param sensor pose of the sensor at the sighting in frame map, if the robot is at `robot` now
/// \param widen factor on all variances
[[nodiscard, gnu::always_inline]] inline Match held_against(const Marker& marker, const View& view,
                                                            const Frame& robot,
                                                            const Pose<double>& sensor,
                                                            double widen) noexcept {
    Match match;
    const LineOfSight<double> sight(sensor,
                                    {marker.x_m, marker.y_m, marker.z_m - view.sensor->z_m});
    if (!(sight.ground >= view.sensor->min_distance_m)) {
        match.nis = std::numeric_limits<double>::infinity();
        return match;
    }
    // The survey's error reaches the measurement as the sensor's place does.
    const double place_m2 = view.place_m2 + marker.sigma_m * marker.sigma_m;
    const auto add = [&](const auto& component) {
        constexpr auto c = std::decay_t<decltype(component)>::kIndex;
        if (!view.has(c)) return;
        const Prediction<double> p = component.predict(sight);
        const double difference = view.sighting->value[c] - p.value;
        const double variance =
            widen * (view.variance[c] + place_m2 * (p.by_x * p.by_x + p.by_y * p.by_y) +
                     view.place_rad2 * p.by_heading * p.by_heading);
        Match::Row& row = match.rows[match.count++];
        row.residual = std::decay_t<decltype(component)>::kWraps ? wrap(difference) : difference;
        row.information = 1 / variance;
        row.by_x = p.by_x;
        row.by_y = p.by_y;
        // As sensing/mounted.hpp has it: the sensor's place of then moves with the robot of now.
        row.by_heading =
            p.by_heading + p.by_y * (sensor[kX] - robot.x) - p.by_x * (sensor[kY] - robot.y);
        match.nis += row.residual * row.residual * row.information;
        match.spread *= 2 * kPi<double> * variance;
    };
    add(Bearing<double>{});
    add(Elevation<double>{});
    add(Range<double>{view.sensor->range_scale, view.sensor->range_offset_m});
    return match;
}

/// False where the sighting is far from what the marker would show, at a small part of the cost of
/// finding out how far.
[[nodiscard]] inline bool near(const Marker& marker, const View& view, const Pose<double>& sensor,
                               const Point& along, double widen) noexcept {
    const double limit = 36 * widen;  // six sigma
    const double dx = marker.x_m - sensor[kX], dy = marker.y_m - sensor[kY];
    const double ground_squared = dx * dx + dy * dy;
    const double place_m2 = view.place_m2 + marker.sigma_m * marker.sigma_m;
    if (view.has(kBearing)) {
        const double ahead = along[0] * dx + along[1] * dy, aside = along[0] * dy - along[1] * dx;
        const double variance_m2 =
            (view.variance[kBearing] + view.place_rad2) * ground_squared + place_m2;
        if (ahead < 0 || aside * aside > limit * variance_m2) return false;
    }
    if (view.has(kRange)) {
        const double dz = marker.z_m - view.sensor->z_m;
        const double scale = view.sensor->range_scale;
        const double off = scale * std::sqrt(ground_squared + dz * dz) +
                           view.sensor->range_offset_m - view.sighting->value[kRange];
        if (off * off > limit * (view.variance[kRange] + scale * scale * place_m2)) return false;
    }
    return true;
}

/// What a pose makes of a sighting.
struct Explanation {
    double log_likelihood = 0;
    double belief = 0;  ///< probability that it is of the marker that fits best
    const Marker* marker = nullptr;
    Match match;  ///< with that marker
};

/// The mixture \f$(1 - \epsilon) \frac{1}{n} \sum_m N(z; h_m(T), \Sigma) + \epsilon\, u(z)\f$ over
/// the n markers that the sighting can be of, with \f$\epsilon\f$ = kClutter and u uniform.
/// \param robot pose now in frame map
[[nodiscard, gnu::always_inline]] inline Explanation explain(const View& view, const Frame& robot,
                                                             const MarkerMap& map,
                                                             double widen = 1) noexcept {
    Explanation result;
    const Pose<double> sensor = robot.out_of(view.place);
    double likelihood = view.clutter, best = 0;
    const auto hold = [&](const Marker& marker) {
        const Match match = held_against(marker, view, robot, sensor, widen);
        const double part = view.share * match.density();
        likelihood += part;
        if (part > best) {
            best = part;
            result.marker = &marker;
            result.match = match;
        }
    };
    const Point along = turned({robot.c, robot.s}, view.along);
    const auto try_one = [&](const Marker& marker) {
        if (near(marker, view, sensor, along, widen)) hold(marker);
    };
    if (view.marker != nullptr) {
        try_one(*view.marker);
    } else {
        for (const Marker& marker : map.markers())
            if (view.may_be_of(marker)) try_one(marker);
    }
    result.log_likelihood = best > 0 ? std::log(likelihood) : view.log_clutter;
    result.belief = best / likelihood;
    return result;
}

}  // namespace pilotage
