#pragma once
/// \file
/// Which marker each sighting of a frame is of, where the sensor does not say.
///
/// A sighting may be of the markers within the gate (individual compatibility, nearest neighbour by
/// Mahalanobis distance first), or of none: another robot, a reflection. The frame's sightings are
/// assigned together (joint_search.hpp). Where a nearly as likely assignment says otherwise a
/// sighting is left out: a wrong marker costs more than a sighting.
///
/// Pixels with a radius are of what is projected nearest instead (nearest_projection.hpp).

#include <cstdint>
#include <vector>

#include "pilotage/association/joint_search.hpp"
#include "pilotage/marker_map.hpp"
#include "pilotage/params.hpp"
#include "pilotage/samples.hpp"
#include "pilotage/verdict.hpp"

namespace pilotage {

/// What a sighting is of.
struct Association {
    std::int32_t id = kUnknownId;        ///< of the marker to hold it against
    Verdict verdict = Verdict::pending;  ///< or why there is none: no_match, ambiguous_match
};

/// Takes its memory at construction. Gather a frame, resolve it, ask.
template <typename Scalar>
class Associator {
   public:
    /// Of a larger frame, so many are taken together at a time.
    static constexpr int kMaxSightings = JointSearch<Scalar>::kMaxContenders;

    Associator() : contenders_(kMaxSightings) {}

    void begin_frame() noexcept { size_ = unknown_ = 0; }
    /// \pre not full
    /// \param sighting stays where it is until the frame is resolved
    void add(const Sighting& sighting) noexcept {
        sightings_[size_] = &sighting;
        found_[size_++] = {sighting.id, Verdict::pending};
        if (sighting.id == kUnknownId) ++unknown_;
    }
    [[nodiscard]] bool full() const noexcept { return size_ == kMaxSightings; }
    [[nodiscard]] bool any_unknown() const noexcept { return unknown_ > 0; }

    /// Finds the markers of the sightings without id. Those with one keep it, and their marker is
    /// no choice for others.
    /// \param robot pose at the frame's time, with its covariance
    /// \param tilt_variance by which the body's tilt adds to that of elevations [rad^2]
    /// \param stated_scale on the sigmas that sightings state; those of `sensor` hold as they are
    void resolve(const Pose<Scalar>& robot, const Matrix<Scalar, 3>& covariance,
                 const MarkerMap& map, const SensorParams& sensor, const Policy& policy,
                 Scalar tilt_variance = 0, double stated_scale = 1) noexcept;

    /// Of the i-th sighting added.
    [[nodiscard]] const Association& operator[](std::size_t i) const noexcept { return found_[i]; }

    /// Pose updates that the last search took.
    [[nodiscard]] int nodes() const noexcept { return nodes_; }

   private:
    void resolve_nearest(const Pose<Scalar>& robot, const MarkerMap& map,
                         const SensorParams& sensor) noexcept;
    [[nodiscard]] bool seen_by_id(std::int32_t id) const noexcept;
    void decide(const JointSearch<Scalar>& search, Contender<Scalar>* const* contenders,
                int size) noexcept;

    const Sighting* sightings_[kMaxSightings];
    Association found_[kMaxSightings];
    int size_ = 0, unknown_ = 0, nodes_ = 0;
    std::vector<Contender<Scalar>> contenders_;
};

extern template class Associator<double>;
extern template class Associator<float>;

}  // namespace pilotage
