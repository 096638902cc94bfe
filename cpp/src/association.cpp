#include "pilotage/association.hpp"

#include "pilotage/association/nearest_projection.hpp"
#include "pilotage/association/reach.hpp"
#include "pilotage/noise_scale.hpp"

namespace pilotage {

namespace {

/// Puts a pairing into its place by likelihood. \return whether there was room
template <typename Scalar>
bool insert(Contender<Scalar>& c, const Pairing<Scalar>& pairing) noexcept {
    if (c.size == Contender<Scalar>::kMaxPairings) return false;
    int at = c.size++;
    for (; at > 0 && c.pairings[at - 1].log_odds < pairing.log_odds; --at)
        c.pairings[at] = c.pairings[at - 1];
    c.pairings[at] = pairing;
    return true;
}

/// What Reach takes for a pixel. A tilt of the body turns a bearing by the tangent of the
/// elevation; where that is steep, a bearing tells nothing.
Sighting seen_about(const Sighting& pixel, const SensorParams& sensor, double tilt_variance) {
    constexpr double steep = 3;
    Sighting angles = angles_of(pixel, sensor);
    const double slope = std::abs(std::tan(angles.value[kElevation]));
    if (slope > steep) angles.value[kBearing] = NAN;
    angles.sigma[kBearing] = std::hypot(angles.sigma[kBearing], slope * std::sqrt(tilt_variance));
    return angles;
}

}  // namespace

/// The paper's way: see nearest_projection.hpp.
template <typename Scalar>
void Associator<Scalar>::resolve_nearest(const Pose<Scalar>& robot, const MarkerMap& map,
                                         const SensorParams& sensor) noexcept {
    const Sighting* unknown[kMaxSightings];
    int index[kMaxSightings];
    std::size_t count = 0;
    for (int i = 0; i < size_; ++i) {
        if (sightings_[i]->id != kUnknownId) continue;
        index[count] = i;
        unknown[count++] = sightings_[i];
    }
    NearestProjection<Scalar> nearest[kMaxSightings];
    find_nearest_projections(robot, map, sensor, sensor.association_radius_pixel, unknown, count,
                             nearest, [&](std::int32_t id) { return !seen_by_id(id); });
    for (std::size_t i = 0; i < count; ++i)
        found_[index[i]] = {nearest[i].id,
                            nearest[i].id == kUnknownId ? Verdict::no_match : Verdict::pending};
    nodes_ = 0;
}

template <typename Scalar>
bool Associator<Scalar>::seen_by_id(std::int32_t id) const noexcept {
    for (int i = 0; i < size_; ++i)
        if (sightings_[i]->id == id) return true;
    return false;
}

template <typename Scalar>
void Associator<Scalar>::resolve(const Pose<Scalar>& robot, const Matrix<Scalar, 3>& covariance,
                                 const MarkerMap& map, const SensorParams& sensor,
                                 const Policy& policy, Scalar tilt_variance,
                                 double stated_scale) noexcept {
    const bool pixels = sensor.measures == Measures::pixels;
    if (pixels && sensor.association_radius_pixel > 0) return resolve_nearest(robot, map, sensor);
    const SensorPlace<Scalar> place(robot, covariance, sensor);
    const Deviation<Scalar> before(Vector<Scalar, 3>::Zero(), covariance);
    Contender<Scalar>* contenders[kMaxSightings];
    int size = 0;
    for (int i = 0; i < size_; ++i) {
        const Sighting sighting = scaled(*sightings_[i], stated_scale);
        if (sighting.id != kUnknownId) continue;
        Contender<Scalar>& c = contenders_[size];
        c.size = 0;
        c.index = i;
        bool crowded = false;
        const Sighting about =
            pixels ? seen_about(sighting, sensor, double(tilt_variance)) : sighting;
        const Reach<Scalar> reach(place, about, sensor, policy);
        const std::int32_t label = map.wanted_label(sighting.label);
        for (const Marker& marker : map.markers()) {
            if (label >= 0 && marker.label != label) continue;
            if (!reach.holds(marker)) continue;
            Pairing<Scalar> pairing = pair_up(robot, marker, sighting, sensor, tilt_variance);
            Deviation<Scalar> after = before;
            const Support<Scalar> support = take(after, pairing);
            if (!support.possible || policy.beyond_gate(double(support.nis), pairing.dof)) continue;
            if (size_ > unknown_ && seen_by_id(marker.id)) continue;
            pairing.log_odds = support.log_odds;
            crowded = !insert(c, pairing) || crowded;
        }
        found_[i].verdict = crowded ? Verdict::ambiguous_match : Verdict::no_match;
        if (crowded || c.size == 0) continue;
        // Those with the fewest choices first; in their order where as many.
        int at = size++;
        for (; at > 0 && contenders[at - 1]->size > c.size; --at)
            contenders[at] = contenders[at - 1];
        contenders[at] = &c;
    }
    JointSearch<Scalar> search(contenders, size, policy);
    search.run(covariance);
    nodes_ = search.nodes();
    decide(search, contenders, size);
}

/// Takes from the likeliest assignment what no other contradicts: none that is nearly as likely
/// or, where not all could be searched, none at all.
template <typename Scalar>
void Associator<Scalar>::decide(const JointSearch<Scalar>& search,
                                Contender<Scalar>* const* contenders, int size) noexcept {
    const auto counts = [&](const Contender<Scalar>& c, int pairing) {
        return !search.complete() || search.close(c, pairing);
    };
    for (int i = 0; i < size; ++i) {
        const Contender<Scalar>& c = *contenders[i];
        const std::int32_t id = c.id(c.best);
        bool contested = false;
        for (int k = 0; k < c.size; ++k) contested = contested || (k != c.best && counts(c, k));
        for (int j = 0; j < size; ++j)
            for (int k = 0; k < contenders[j]->size; ++k)
                contested = contested ||
                            (j != i && contenders[j]->id(k) == id && counts(*contenders[j], k));
        Association& found = found_[c.index];
        if (contested)
            found.verdict = Verdict::ambiguous_match;
        else if (id != kUnknownId)
            found = {id, Verdict::pending};
    }
}

template class Associator<double>;
template class Associator<float>;

}  // namespace pilotage
