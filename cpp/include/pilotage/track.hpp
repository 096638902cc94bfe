#pragma once
/// \file
/// The estimate at one moment with all that decides its future, and how it is carried on: by
/// motion.

#include <cstdint>

#include "pilotage/checkpoint.hpp"
#include "pilotage/dead_reckoning.hpp"
#include "pilotage/filter/agreement.hpp"
#include "pilotage/filter/ekf.hpp"
#include "pilotage/judge.hpp"
#include "pilotage/motion/motion_check.hpp"
#include "pilotage/motion/odometer.hpp"
#include "pilotage/noise_scale.hpp"
#include "pilotage/params.hpp"
#include "pilotage/samples.hpp"
#include "pilotage/search/frame.hpp"
#include "pilotage/verdict.hpp"

namespace pilotage {

/// Where dead reckoning alone has brought the robot, and how unsure that is by now.
struct Drift {
    Pose<double> odometry_from_map = {0, 0, 0};  ///< changes only where the pose is corrected
    double position_m2 = 0, heading_rad2 = 0;    ///< variances gathered so far, each axis
};

template <typename Scalar, int N>
struct Track {
    Ekf<Scalar, N> filter;
    GyroIntegral gyro;
    TickCounter ticks;
    MotionCheck check;
    Agreement agreement;
    MarkerSet agreeing;  ///< of which those in a row are, until it is confirmed
    Judgement judgement;
    Drift drift;
    std::int64_t utime = 0;
    std::int64_t agreed_utime = 0;      ///< of the last sighting that agreed
    std::int64_t tilt_utime = 0;        ///< when it was settled, where tilt is a state
    std::int64_t search_due_utime = 0;  ///< other poses are not looked for before
    std::int64_t evidence_since = 0;    ///< nothing older speaks of this pose
    Increment<Scalar> motion;           ///< of the last motion sample that took time
    Vector<Scalar, 2> driven = {0, 0};  ///< (distance [m], turn [rad]) of the last motion sample
    NoiseScale noise;                   ///< stays as it was begun unless params.noise.adapts()
    std::int32_t resets = 0;            ///< of the pose, by a message or a search
    std::int32_t found = 0;             ///< of them, by a search
    bool started = false;               ///< a motion sample has come
    bool located = false;    ///< the pose is an estimate; else the filter only adds up the motion
    bool confirmed = false;  ///< sightings agree with it, and with no other pose
    bool restored = false;   ///< begun from a checkpoint

    [[nodiscard]] Pose<double> pose() const noexcept {
        return filter.state().template head<3>().template cast<double>();
    }
    [[nodiscard]] Matrix<double, 3> covariance() const noexcept {
        return filter.covariance().template topLeftCorner<3, 3>().template cast<double>();
    }

    /// Where dead reckoning alone has brought the robot.
    [[nodiscard]] Pose<double> odometry() const noexcept {
        return Frame(drift.odometry_from_map).out_of(pose());
    }
    /// After the pose was corrected: dead reckoning is still there.
    void keep_odometry(const Pose<double>& odometry) noexcept {
        drift.odometry_from_map = Frame(odometry).out_of(Frame(pose()).into({0, 0, 0}));
    }
};

/// Carries tracks on. Holds what does not change.
template <typename Scalar, int N>
class Tracker {
   public:
    using Track = pilotage::Track<Scalar, N>;

    explicit Tracker(const Params& params) noexcept;

    [[nodiscard]] const Params& params() const noexcept { return params_; }

    /// A track that knows no pose, calibration as configured, before any motion.
    [[nodiscard]] Track anywhere() const noexcept;

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
    [[nodiscard, gnu::flatten]] Increment<Scalar> measure(Track& track, const Sample& motion,
                                                          Verdict& verdict) const noexcept;

    /// Moves the estimate.
    [[gnu::flatten]] void drive(Track& track, const Increment<Scalar>& u) const noexcept;

    /// The track at a later time if the robot goes on as it does; past motion.max_gap_s only how
    /// fast it may be is known.
    [[nodiscard]] Track predicted(Track track, std::int64_t utime) const noexcept;

   private:
    [[nodiscard]] Increment<Scalar> by_wheels(Track& track, const EncoderTicks& ticks, double dt_s,
                                              RotationStep& rotation,
                                              Verdict& verdict) const noexcept;
    [[nodiscard]] Increment<Scalar> by_velocity(const BodyVelocity& velocity, double dt_s,
                                                RotationStep& rotation) const noexcept;
    [[gnu::noinline, gnu::cold]] void drive_as_learned(Track& track,
                                                       const Increment<Scalar>& u) const noexcept;
    void move(Ekf<Scalar, N>& filter, const Increment<Scalar>& u) const noexcept;
    [[gnu::noinline, gnu::cold]] void move_unscented(Ekf<Scalar, N>& filter,
                                                     const Increment<Scalar>& u) const noexcept;
    [[nodiscard, gnu::noinline, gnu::cold]] Pose<double> judged_window(Track& track) const noexcept;
    [[nodiscard, gnu::noinline, gnu::cold]] Pose<double> farthest(const Track& track, double time_s,
                                                                  bool turn_known) const noexcept;
    [[nodiscard]] Pose<Scalar> useful(const Ekf<Scalar, N>& filter,
                                      const Pose<double>& doubt) const noexcept;
    void doubt(Ekf<Scalar, N>& filter, const Pose<double>& variances) const noexcept;
    [[nodiscard]] RotationTolerance tolerance(const Track& track) const noexcept;
    [[nodiscard]] double gyro_bias(const Track& track) const noexcept;
    void learn_bias(Track& track) const noexcept;

    Params params_;
    double tick_rad_;  // rotation by one tick of one wheel
};

extern template class Tracker<double, kPoseStates>;
extern template class Tracker<double, kCalibratedStates>;
extern template class Tracker<double, kTiltedStates>;
extern template class Tracker<float, kPoseStates>;
extern template class Tracker<float, kCalibratedStates>;

}  // namespace pilotage
