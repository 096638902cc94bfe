#pragma once
/// \file
/// The facade: samples in, in any order within the history's window; pose and reports out.

#include <cstddef>
#include <cstdint>

#include "pilotage/dead_reckoning.hpp"
#include "pilotage/filter/ekf.hpp"
#include "pilotage/fuse_sighting.hpp"
#include "pilotage/history.hpp"
#include "pilotage/marker_map.hpp"
#include "pilotage/motion/odometer.hpp"
#include "pilotage/params.hpp"
#include "pilotage/samples.hpp"
#include "pilotage/verdict.hpp"

namespace pilotage {

/// What the status promises; the values are status_t's.
enum class Status : std::int8_t {
    waiting = 0,         ///< for a pose or for motion
    initializing = 1,    ///< a pose is assumed, no sighting has confirmed it
    ok = 2,              ///< the error is inside the covariance, and that is below the alert limit
    dead_reckoning = 3,  ///< no sighting for a while, or less sure than the alert limit asks
    ambiguous = 4,
    lost = 5,
};

/// The pose at the newest motion sample.
struct Estimate {
    std::int64_t utime = 0;
    Pose<double> pose = Pose<double>::Zero();
    Matrix<double, 3> covariance = Matrix<double, 3>::Zero();
    double v_m_s = 0, omega_rad_s = 0;
    Status status = Status::waiting;
    std::int32_t resets = 0;
};

/// Hears what becomes of every sample: each starts `pending`, and may change its verdict more than
/// once as late samples arrive. Every sighting is reported in full each time it is judged.
class Listener {
   public:
    virtual void on_verdict(const Sample& sample, Verdict before, Verdict now) = 0;
    virtual void on_sighting(const SightingReport& report) = 0;

   protected:
    ~Listener() = default;
};

/// Localizes on known markers with dead reckoning in between. N = 3 (pose) or 6 (with calibration
/// states).
///
/// The estimate depends on the set of samples within the window, not on the order of their arrival:
/// a sample that comes late is put in its place and everything after it is computed again. Nothing
/// is allocated after construction, nothing throws, and no clock is read.
template <typename Scalar, int N>
class Localizer {
   public:
    /// \param listener outlives the localizer
    Localizer(const Params& params, MarkerMap map, Listener& listener);

    /// Takes a sample; sightings wait for the motion sample after them.
    /// \return whether the newest motion sample is a newer one than before: time to publish the
    /// estimate
    bool add(const Sample& sample) noexcept;

    /// No more motion will come: what still waits for it is rejected as no_motion.
    void finish() noexcept;

    /// False until a pose is configured or set.
    [[nodiscard]] bool has_pose() const noexcept { return initialized_; }
    /// False until a pose is known and the first motion sample has come.
    [[nodiscard]] bool started() const noexcept { return initialized_ && newest().started; }
    [[nodiscard]] Estimate estimate() const noexcept;

    /// State and covariance at the newest motion sample (StateIndex order).
    [[nodiscard]] const Ekf<Scalar, N>& filter() const noexcept { return newest().filter; }

   private:
    /// All that decides the future, at one moment.
    struct Track {
        Ekf<Scalar, N> filter;
        GyroIntegral gyro;
        TickCounter ticks;
        std::int64_t utime = 0;
        std::int64_t last_fix_utime = 0;
        Increment<Scalar> motion;  // of the last motion sample
        std::int32_t resets = 0;
        bool started = false;    // a motion sample has come
        bool confirmed = false;  // a sighting has been accepted
    };

    /// A sample, what became of it, and for a motion sample the track after it.
    struct Node {
        Sample sample;
        Verdict verdict;
        std::int32_t revision;
        Track track;
    };

    // Intake.
    [[nodiscard]] Verdict examine(const Sample& sample) const noexcept;
    bool insert(const Sample& sample) noexcept;
    bool refuse(const Sample& sample, Verdict verdict, double value, double limit) noexcept;
    void forget_before(std::int64_t horizon) noexcept;
    void forget_step() noexcept;
    void forget_front() noexcept;

    // Computing again from a place in the history.
    void recompute(std::size_t place) noexcept;
    void advance(Track& track, std::size_t from, std::size_t to) noexcept;
    [[nodiscard]] Increment<Scalar> measured_motion(Track& track, Node& motion) noexcept;
    void correct(Track& track, Node& node) noexcept;
    void dismiss(Node& node, Verdict verdict) noexcept;
    void settle(Node& node, Verdict verdict) noexcept;

    [[nodiscard]] std::size_t motion_before(std::size_t place) const noexcept;
    [[nodiscard]] std::size_t first_motion() const noexcept;
    [[nodiscard]] const Track& newest() const noexcept;
    [[nodiscard]] Status status(const Track& track) const noexcept;

    Params params_;
    MarkerMap map_;
    Listener* listener_;
    Policy policies_[Params::kMaxSensors];
    History<Node> history_;
    Track base_;  // what came before the first sample of the history
    bool initialized_ = false;
};

extern template class Localizer<double, kPoseStates>;
extern template class Localizer<double, kCalibratedStates>;
extern template class Localizer<float, kPoseStates>;
extern template class Localizer<float, kCalibratedStates>;

}  // namespace pilotage
