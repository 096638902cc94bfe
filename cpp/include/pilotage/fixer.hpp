#pragma once
/// \file
/// What corrects a track: sightings of markers, a pose from outside, a pose that a search found.

#include "pilotage/association.hpp"
#include "pilotage/search/pose_search.hpp"
#include "pilotage/track.hpp"
#include "pilotage/wall_map.hpp"

namespace pilotage {

/// Holds what does not change. The search is lent to it: its workspace is large.
template <typename Scalar, int N>
class Fixer {
   public:
    using Track = pilotage::Track<Scalar, N>;

    Fixer(const Params& params, MarkerMap map, WallMap walls);

    /// Finds which markers a gathered frame of a sensor is of.
    void recognise(const Track& track, int sensor, Associator<Scalar>& frame) const noexcept;

    /// Fuses a sighting as one of the marker that was found for it, if there is a pose.
    [[nodiscard]] SightingReport sight(Track& track, const Sample& sample,
                                       const Association& of) const noexcept;

    /// Fuses what was measured without a marker. Where there is no pose, a whole pose is one.
    [[nodiscard]] SightingReport fix(Track& track, const Sample& sample) const noexcept;

    /// A sighting just made, as a search wants it.
    /// \pre `track` is as it was before the sighting was fused
    [[nodiscard]] Evidence evidence(const Track& track, const Sample& sample,
                                    const PoseSearch& search) const noexcept;

    /// Whether to look for other poses that explain the sightings.
    [[nodiscard]] bool doubtful(const Track& track) const noexcept;
    /// How many of the latest sightings of each marker to do it with.
    [[nodiscard]] static int evidence_wanted(const Track& track) noexcept {
        constexpr int few = 6;  // where the robot may have been carried off, or its motion is wrong
        return track.confirmed ? few : Evidence::kMost;
    }
    /// Looks for them, and takes the one that the judge prefers to the estimate.
    /// \param newest_first sightings since track.evidence_since
    void search(Track& track, const Evidence* newest_first, int count,
                PoseSearch& search) const noexcept;

    /// Takes a pose given from outside.
    void reset(Track& track, const PoseReset& to) const noexcept;

   private:
    [[nodiscard]] SightingReport fuse(Track& track, const Sample& sample) const noexcept;
    void follow(Track& track, const Pose<double>& odometry, const SightingReport& report,
                std::int32_t told) const noexcept;
    void agree(Track& track, std::int32_t told) const noexcept;
    [[nodiscard]] bool confirms(const Track& track) const noexcept;
    template <typename Variance>
    void learn(Track& track, const SightingReport& report,
               const Variance& variance_of) const noexcept;
    void place(Track& track, const Pose<double>& pose,
               const Matrix<double, 3>& covariance) const noexcept;

    Params params_;
    MarkerMap map_;
    WallMap walls_;
    Policy policies_[Params::kMaxSensors];
};

extern template class Fixer<double, kPoseStates>;
extern template class Fixer<double, kCalibratedStates>;
extern template class Fixer<double, kTiltedStates>;
extern template class Fixer<float, kPoseStates>;
extern template class Fixer<float, kCalibratedStates>;

}  // namespace pilotage
