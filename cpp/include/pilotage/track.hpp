#pragma once
/// \file
/// The estimate at one moment with all that decides its future, and how it is carried on: by
/// motion, by sightings, by a pose from outside.

#include <cstdint>

#include "pilotage/association.hpp"
#include "pilotage/checkpoint.hpp"
#include "pilotage/dead_reckoning.hpp"
#include "pilotage/filter/agreement.hpp"
#include "pilotage/filter/ekf.hpp"
#include "pilotage/fuse_sighting.hpp"
#include "pilotage/marker_map.hpp"
#include "pilotage/motion/motion_check.hpp"
#include "pilotage/motion/odometer.hpp"
#include "pilotage/params.hpp"
#include "pilotage/samples.hpp"
#include "pilotage/verdict.hpp"

namespace pilotage {

/// What the status promises; the values are status_t's.
enum class Status : std::int8_t {
    waiting = 0,         ///< for a pose or for motion
    initializing = 1,    ///< a pose is assumed, sightings have not confirmed it
    ok = 2,              ///< the error is inside the covariance, and that is below the alert limit
    dead_reckoning = 3,  ///< no sighting for a while, or less sure than the alert limit asks
    ambiguous = 4,
    lost = 5,  ///< not to be used: the sightings contradict it, or its error has no bound
};

/// Why the status is not ok.
enum class Reason : std::uint8_t {
    none,
    no_pose,
    no_motion,
    unconfirmed,   ///< sightings that agree, so far
    disagreement,  ///< mean NIS per degree of freedom
    no_sighting,   ///< seconds without one that agrees
    unsure,        ///< 95 % radius [m]
    motion_gap,    ///< seconds without motion
};

struct Assessment {
    Status status = Status::waiting;
    Reason reason = Reason::no_pose;
    double value = 0, limit = 0;  ///< what decided, in the unit of the reason
};

/// Another idea of the pose, begun when the sightings contradict the estimate: it starts from
/// having no idea and believes motion little, so that it settles where the sightings agree with
/// each other, if they do.
template <typename Scalar, int N>
struct Alternative {
    bool active = false;
    Ekf<Scalar, N> filter;
    Agreement agreement;
    std::uint64_t markers = 0;  ///< a bit for each marker that agreed with it

    Alternative() = default;
    Alternative(const Alternative& other) noexcept { *this = other; }
    /// Mostly there is none, and then nothing to copy.
    Alternative& operator=(const Alternative& other) noexcept {
        active = other.active;
        if (!active) return *this;
        filter = other.filter;
        agreement = other.agreement;
        markers = other.markers;
        return *this;
    }
};

template <typename Scalar, int N>
struct Track {
    Ekf<Scalar, N> filter;
    Alternative<Scalar, N> alternative;
    GyroIntegral gyro;
    TickCounter ticks;
    MotionCheck check;
    Agreement agreement;
    std::int64_t utime = 0;
    std::int64_t agreed_utime = 0;      ///< of the last sighting that agreed
    Increment<Scalar> motion;           ///< of the last motion sample that took time
    Vector<Scalar, 2> driven = {0, 0};  ///< (distance [m], turn [rad]) of the last motion sample
    std::int32_t resets = 0;
    bool started = false;   ///< a motion sample has come
    bool restored = false;  ///< begun from a checkpoint
};

/// Carries tracks on. Holds what does not change.
template <typename Scalar, int N>
class Tracker {
   public:
    using Track = pilotage::Track<Scalar, N>;

    Tracker(const Params& params, MarkerMap map);

    [[nodiscard]] const Params& params() const noexcept { return params_; }

    /// A track at a pose with its covariance, calibration as configured, before any motion.
    [[nodiscard]] Track start(const Pose<double>& pose,
                              const Matrix<double, 3>& covariance) const noexcept;

    [[nodiscard]] Checkpoint checkpoint(const Track& track) const noexcept;
    /// A track at a checkpoint, before any motion; its calibration counts only if it has the same
    /// states. The pose is a hypothesis until sightings agree, or the encoders turn out not to have
    /// moved.
    /// \return false, and `track` as it was, if the checkpoint is no state of a filter
    [[nodiscard]] bool restore(const Checkpoint& from, Track& track) const noexcept;

    /// Takes the first motion sample, from which the next one counts.
    void begin(Track& track, const Sample& motion) const noexcept;

    /// The motion that ends at a motion sample, and the counters that the next one starts from.
    /// \pre the track has begun
    /// \param verdict fused or counter_reset
    [[nodiscard]] Increment<Scalar> measure(Track& track, const Sample& motion,
                                            Verdict& verdict) const noexcept;

    /// Moves the estimate.
    void drive(Track& track, const Increment<Scalar>& u) const noexcept {
        dead_reckon(track.filter, u, params_);
        if (track.alternative.active) dead_reckon(track.alternative.filter, u, params_);
    }

    /// Finds which markers a gathered frame of a sensor is of.
    void recognise(const Track& track, int sensor, Associator<Scalar>& frame) const noexcept;

    /// Fuses a sighting.
    [[nodiscard]] SightingReport sight(Track& track, const Sample& sample) const noexcept;

    /// Takes a pose given from outside.
    void reset(Track& track, const PoseReset& to) const noexcept;

    /// The track at a later time if the robot goes on as it does; past motion.max_gap_s only how
    /// fast it may be is known.
    [[nodiscard]] Track predicted(Track track, std::int64_t utime) const noexcept;

    /// \param silent_s since the last motion sample
    [[nodiscard]] Assessment assess(const Track& track, double silent_s) const noexcept;

   private:
    [[nodiscard]] Increment<Scalar> by_wheels(Track& track, const EncoderTicks& ticks, double dt_s,
                                              RotationStep& rotation,
                                              Verdict& verdict) const noexcept;
    [[nodiscard]] Increment<Scalar> by_velocity(const BodyVelocity& velocity, double dt_s,
                                                RotationStep& rotation) const noexcept;
    [[nodiscard]] Pose<double> judged_window(Track& track) const noexcept;
    [[nodiscard]] Pose<double> farthest(const Track& track, double time_s,
                                        bool turn_known) const noexcept;
    [[nodiscard]] Pose<Scalar> useful(const Ekf<Scalar, N>& filter,
                                      const Pose<double>& doubt) const noexcept;
    void doubt(Ekf<Scalar, N>& filter, const Pose<double>& variances) const noexcept;
    void consider(Track& track, const Sample& sample) const noexcept;
    [[nodiscard]] RotationTolerance tolerance(const Track& track) const noexcept;
    [[nodiscard]] double gyro_bias(const Track& track) const noexcept;
    void learn_bias(Track& track) const noexcept;

    Params params_;
    MarkerMap map_;
    Policy policies_[Params::kMaxSensors];
    double tick_rad_;  // rotation by one tick of one wheel
    int enough_;       // markers that have to agree on an alternative
};

extern template class Tracker<double, kPoseStates>;
extern template class Tracker<double, kCalibratedStates>;
extern template class Tracker<float, kPoseStates>;
extern template class Tracker<float, kCalibratedStates>;

}  // namespace pilotage
