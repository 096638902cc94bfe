#pragma once
/// \file
/// The facade: samples in, in any order within the history's window; pose and reports out.

#include <cstddef>
#include <cstdint>
#include <limits>

#include "pilotage/fixer.hpp"
#include "pilotage/history.hpp"
#include "pilotage/search/memory.hpp"
#include "pilotage/search/pose_search.hpp"
#include "pilotage/status.hpp"
#include "pilotage/track.hpp"

namespace pilotage {

/// The pose at the newest motion sample, or predicted from there, and how far to trust it.
struct Estimate : Assessment {
    std::int64_t utime = 0;
    Pose<double> pose = Pose<double>::Zero();
    Matrix<double, 3> covariance = Matrix<double, 3>::Zero();
    double v_m_s = 0, omega_rad_s = 0;
    Vector<double, 2> driven = {0, 0};  ///< (distance [m], turn [rad]) of the newest motion sample
    MotionState motion = MotionState::driving;
    double disagreement_rad = 0;  ///< of wheels less gyro, over the latest half second; 0 if small
    bool gyro_left_out = false;   ///< its turn is not believed
    std::int32_t resets = 0;      ///< of the pose, by a message or a search
    std::int32_t found = 0;       ///< of them, by a search
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

/// Localizes on known markers with dead reckoning in between. N = 3 (pose), 6 (with calibration
/// states) or 8 (with pitch and roll).
///
/// The estimate depends on the set of samples within the window, not on the order of their arrival:
/// a sample that comes late is put in its place and everything after it is computed again. Nothing
/// is allocated after construction, nothing throws, and no clock is read.
template <typename Scalar, int N>
class Localizer {
   public:
    /// \param listener outlives the localizer
    Localizer(const Params& params, MarkerMap map, Listener& listener, WallMap walls = {});

    /// Takes samples, those of a message together, so that a late frame is computed once; sightings
    /// wait for the motion sample after them.
    /// \return whether the newest motion sample is a newer one than before: time to publish the
    /// estimate
    bool add(const Sample* samples, std::size_t count) noexcept;
    bool add(const Sample& sample) noexcept { return add(&sample, 1); }

    /// Turns a sample away for a reason from outside. \return false
    bool refuse(const Sample& sample, Verdict verdict) noexcept {
        return refuse(sample, verdict, std::numeric_limits<double>::quiet_NaN(),
                      std::numeric_limits<double>::quiet_NaN());
    }

    /// No more motion will come: what still waits for it is rejected as no_motion.
    void finish() noexcept;

    /// The clock that dates motion was set: the newest motion sample counts as taken at `utime`.
    /// What is older can no longer change, what waits is rejected as no_motion.
    void set_time(std::int64_t utime) noexcept;

    /// False until a pose is configured, set or found.
    [[nodiscard]] bool has_pose() const noexcept { return newest().located; }
    /// False until a pose is known and the first motion sample has come.
    [[nodiscard]] bool started() const noexcept { return newest().located && newest().started; }

    /// The estimate at the newest motion sample.
    [[nodiscard]] Estimate estimate() const noexcept;
    /// The estimate at `utime`, predicted if that is later than the newest motion sample.
    [[nodiscard]] Estimate estimate(std::int64_t utime) const noexcept;

    /// State and covariance at the newest motion sample (StateIndex order).
    [[nodiscard]] const Ekf<Scalar, N>& filter() const noexcept { return newest().filter; }

    /// Estimated over configured noise, at the newest motion sample.
    [[nodiscard]] const NoiseScale& noise() const noexcept { return newest().noise; }

    [[nodiscard]] Checkpoint checkpoint() const noexcept { return tracker_.checkpoint(newest()); }
    /// \pre no sample has been added
    /// \return false, and nothing has changed, if the checkpoint is no state of a filter
    [[nodiscard]] bool restore(const Checkpoint& from) noexcept;

   private:
    using Track = pilotage::Track<Scalar, N>;

    /// A sample, what became of it, and for a motion sample the track after it.
    struct Node {
        Sample sample;
        Verdict verdict;
        std::int32_t revision;
        bool seen;  ///< there is `evidence`
        Evidence evidence;
        Track track;
    };

    // Intake.
    static constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();
    bool welcome(const Sample& sample) noexcept;
    std::size_t insert(const Sample& sample) noexcept;
    bool refuse(const Sample& sample, Verdict verdict, double value, double limit) noexcept;
    void forget_before(std::int64_t horizon) noexcept;
    void forget_step() noexcept;
    void forget_front() noexcept;

    // Computing again from a place in the history.
    void recompute(std::size_t& place) noexcept;
    void advance(Track& track, std::size_t from, std::size_t to) noexcept;
    void begin(Track& track, std::size_t from, std::size_t to) noexcept;
    [[nodiscard]] std::size_t recognise(const Track& track, std::size_t from,
                                        std::size_t to) noexcept;
    void correct(Track& track, Node& node, const Association& of) noexcept;
    void report(Node& node, SightingReport report) noexcept;
    void reset(Track& track, Node& node) noexcept;
    void search(Track& track, std::size_t newest) noexcept;
    void dismiss(Node& node, Verdict verdict) noexcept;
    void settle(Node& node, Verdict verdict) noexcept;

    [[nodiscard]] std::size_t motion_before(std::size_t place) const noexcept;
    [[nodiscard]] std::size_t first_motion() const noexcept;
    [[nodiscard]] const Track& track_at(std::size_t motion) const noexcept;
    [[nodiscard]] const Track& newest() const noexcept;
    /// Where the history begins.
    [[nodiscard]] Track& past() noexcept { return history_.past().track; }
    [[nodiscard]] Estimate describe(const Track& track, double silent_s) const noexcept;

    Tracker<Scalar, N> tracker_;
    Fixer<Scalar, N> fixer_;
    PoseSearch search_;
    Listener* listener_;
    History<Node> history_;
    Associator<Scalar> frame_;
    Memory memory_;  // of sightings older than the history
};

extern template class Localizer<double, kPoseStates>;
extern template class Localizer<double, kCalibratedStates>;
extern template class Localizer<double, kTiltedStates>;
extern template class Localizer<float, kPoseStates>;
extern template class Localizer<float, kCalibratedStates>;

}  // namespace pilotage
