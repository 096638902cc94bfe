#pragma once
/// \file
/// Holds the wheels' rotation against the gyro's: standstill, slip and lift.

#include <cmath>
#include <cstdint>
#include <optional>

namespace pilotage {

/// What wheels and gyro together say of the motion.
enum class MotionState : std::uint8_t {
    driving,
    standing,  ///< neither wheels nor gyro move
    slipping,  ///< the wheels turn the robot by another angle than the gyro
    lifted,    ///< the gyro turns while the wheels stand still
};

/// Rotation over one step, as wheels and gyro have it.
struct RotationStep {
    double dt_s = 0;
    bool ticked = false;  ///< a wheel moved
    double distance_m = 0;
    double wheel_turn_rad = 0, wheel_variance = 0;
    std::optional<double> gyro_turn_rad;  ///< less the bias; none where the gyro was silent
    bool gyro_frozen = false;             ///< its rate has not changed for a while
};

/// How sure the comparison may be.
struct RotationTolerance {
    double gyro_variance_per_s = 0;  ///< of the turn
    double gyro_bias_variance = 0;
    double tick_rad = 0;  ///< rotation of the robot by one tick of one wheel
};

/// Judges windows of half a second: long enough for the gyro's noise to fall below a tick, short
/// enough to tell in time.
class MotionCheck {
   public:
    /// What a window brought to light.
    struct Window {
        double duration_s = 0, distance_m = 0;
        double gyro_turn_rad = 0;     ///< less the bias
        double disagreement_rad = 0;  ///< wheels less gyro, 0 where they agree
        double lasting_rad = 0;       ///< its mean of late, 0 where noise explains that
        bool by_gyro = true;          ///< the gyro was trusted in it
        int in_a_row = 0;             ///< windows with the same verdict
    };

    /// \return whether a window has ended; `window()` and `state()` then speak of it
    bool add(const RotationStep& step, const RotationTolerance& tolerance) noexcept {
        released_rad_ = 0;
        if (step.ticked && (state_ == MotionState::standing || state_ == MotionState::lifted)) {
            if (state_ == MotionState::standing && !gyro_suspect_)
                released_rad_ = disbelieved_rad_ + open_.gyro_turn_rad;
            become(MotionState::driving);
            open_ = Sums{};
        }
        open_.duration_s += step.dt_s;
        open_.distance_m += std::abs(step.distance_m);
        open_.ticked = open_.ticked || step.ticked;
        open_.wheel_turn_rad += step.wheel_turn_rad;
        open_.wheel_variance += step.wheel_variance;
        open_.heard = open_.heard && step.gyro_turn_rad;
        open_.frozen = open_.frozen || step.gyro_frozen;
        if (step.gyro_turn_rad) {
            open_.gyro_turn_rad += *step.gyro_turn_rad;
            if (step.dt_s > 0)
                open_.fastest_rad_s =
                    std::fmax(open_.fastest_rad_s, std::abs(*step.gyro_turn_rad) / step.dt_s);
        }
        if (open_.duration_s < kWindow_s) return false;
        judge(tolerance, step.gyro_turn_rad.value_or(0));
        open_ = Sums{};
        return true;
    }

    [[nodiscard]] MotionState state() const noexcept { return state_; }
    [[nodiscard]] const Window& window() const noexcept { return window_; }
    /// Whether it has stood for so long that it does not just creep from tick to tick.
    [[nodiscard]] bool settled() const noexcept {
        return state_ == MotionState::standing && window_.in_a_row > kSettling;
    }
    /// What the gyro told since the last whole window of standstill, or since it began where that
    /// has not settled, and was not believed then: the robot moves.
    [[nodiscard]] double released_rad() const noexcept { return released_rad_; }
    /// The gyro contradicts the wheels as slip and lift do not explain: by a larger turn than
    /// theirs, one the other way, one that never changes, or one that nobody could carry out.
    [[nodiscard]] bool gyro_suspect() const noexcept { return gyro_suspect_; }

   private:
    static constexpr double kWindow_s = 0.5;
    static constexpr int kSettling = 4;  ///< windows without a tick; a creeping robot has none
    static constexpr double kSigmas = 4.5;
    static constexpr double kWild_rad_s = 6;     // who carries a robot does not turn like this
    static constexpr double kScaleError = 0.15;  ///< of the wheels' turn, which every skid has

    struct Sums {
        double duration_s = 0, distance_m = 0;
        double wheel_turn_rad = 0, wheel_variance = 0, gyro_turn_rad = 0;
        double fastest_rad_s = 0;  // by the gyro
        bool ticked = false, heard = true, frozen = false;
    };

    /// What wheels less gyro come to over some eight windows: a gyro that is off by less than one
    /// window's noise shows in many.
    class Trend {
       public:
        void add(double difference_rad, double variance, double slack_rad) noexcept {
            sum_ = kKept * sum_ + difference_rad;
            variance_ = kKept * kKept * variance_ + variance;
            slack_ = kKept * slack_ + slack_rad;
        }

        /// A window's share of it; 0 where noise explains it.
        [[nodiscard]] double mean() const noexcept {
            return std::abs(sum_) > kSigmas * std::sqrt(variance_) + slack_ ? (1 - kKept) * sum_
                                                                            : 0;
        }

       private:
        static constexpr double kKept = 0.875;
        double sum_ = 0, variance_ = 0, slack_ = 0;
    };

    /// \param last_turn_rad by the gyro in the window's last step, which is believed if the robot
    /// turns out not to stand
    void judge(const RotationTolerance& t, double last_turn_rad) noexcept {
        const double time_s = open_.duration_s;
        const double variance = open_.wheel_variance + t.gyro_variance_per_s * time_s +
                                t.gyro_bias_variance * time_s * time_s;
        const double slack = 2 * t.tick_rad + kScaleError * std::abs(open_.wheel_turn_rad);
        const double difference = open_.wheel_turn_rad - open_.gyro_turn_rad;
        const bool agree =
            !open_.heard || std::abs(difference) <= kSigmas * std::sqrt(variance) + slack;
        const bool suspected = gyro_suspect_, stood = state_ == MotionState::standing;
        // A wheel that spins while the robot slowly turns the other way is a slip as well.
        const double share = open_.gyro_turn_rad * open_.wheel_turn_rad < 0 ? 0.5 : 1;
        const bool no_slip =
            open_.frozen || std::abs(open_.gyro_turn_rad) > share * std::abs(open_.wheel_turn_rad);
        const bool no_lift = suspected || open_.fastest_rad_s > kWild_rad_s;
        gyro_suspect_ = !agree && (open_.ticked ? no_slip : no_lift);
        become(open_.ticked
                   ? (agree ? MotionState::driving : MotionState::slipping)
                   : (agree || gyro_suspect_ ? MotionState::standing : MotionState::lifted));
        if (stood && state_ == MotionState::lifted)
            released_rad_ = open_.gyro_turn_rad - last_turn_rad;
        const bool stands_on = stood && state_ == MotionState::standing && agree;
        disbelieved_rad_ =
            stands_on && window_.in_a_row < kSettling ? disbelieved_rad_ + open_.gyro_turn_rad : 0;
        window_.by_gyro = !suspected;
        window_.duration_s = time_s;
        window_.distance_m = open_.distance_m;
        window_.gyro_turn_rad = open_.heard ? open_.gyro_turn_rad : 0;
        window_.disagreement_rad = agree ? 0 : difference;
        if (open_.ticked && open_.heard) trend_.add(difference, variance, slack);
        window_.lasting_rad = open_.ticked ? trend_.mean() : 0;
        ++window_.in_a_row;
    }

    void become(MotionState state) noexcept {
        if (state != state_) window_.in_a_row = 0;
        state_ = state;
    }

    MotionState state_ = MotionState::driving;
    bool gyro_suspect_ = false;
    double released_rad_ = 0, disbelieved_rad_ = 0;
    Sums open_;
    Trend trend_;
    Window window_;
};

}  // namespace pilotage
