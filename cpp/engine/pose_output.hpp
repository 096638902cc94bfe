#pragma once
/// \file
/// What a controller needs besides the pose: where dead reckoning alone would be, and when the pose
/// jumped.

#include <optional>

#include "pilotage/localizer.hpp"

namespace pilotage {

/// A pose that moved without the robot moving.
struct Jump {
    Pose<double> before, after;
    const char* cause;
};

/// Follows the estimates from one motion sample to the next. What the robot drove in between is
/// known, so anything else the pose did is a jump.
class PoseOutput {
   public:
    PoseOutput(double slip_angle_rad, double jump_m, double jump_rad)
        : motion_{slip_angle_rad}, jump_m_(jump_m), jump_rad_(jump_rad) {}

    /// Takes the estimate at the next motion sample.
    [[nodiscard]] std::optional<Jump> follow(const Estimate& e) noexcept {
        odometry_ = started_ ? moved(odometry_, e.driven) : Pose<double>::Zero();
        const Pose<double> before = started_ ? moved(pose_, e.driven) : e.pose;
        const bool reset = e.resets != resets_, clock = started_ && e.utime < utime_;
        const Pose<double> off = minus<double, 3>(e.pose, before);
        const bool found = e.found != found_;
        const bool far =
            std::hypot(off[kX], off[kY]) > jump_m_ || std::abs(off[kHeading]) > jump_rad_;
        started_ = true;
        pose_ = e.pose;
        utime_ = e.utime;
        resets_ = e.resets;
        found_ = e.found;
        if (!reset && !clock && !far) return std::nullopt;
        if (!reset) ++jumps_;
        const char* cause = found ? "found" : reset ? "reset" : clock ? "clock" : "correction";
        return Jump{before, e.pose, cause};
    }

    /// Pure dead reckoning since the first motion sample.
    [[nodiscard]] const Pose<double>& odometry() const noexcept { return odometry_; }
    /// Resets and jumps so far.
    [[nodiscard]] std::int32_t resets() const noexcept { return resets_ + jumps_; }

   private:
    [[nodiscard]] Pose<double> moved(const Pose<double>& pose,
                                     const Vector<double, 2>& driven) const noexcept {
        return motion_.linearize(pose, driven).next;
    }

    RobotMotion<double> motion_;
    double jump_m_, jump_rad_;
    Pose<double> pose_ = Pose<double>::Zero(), odometry_ = Pose<double>::Zero();
    std::int64_t utime_ = 0;
    std::int32_t resets_ = 0, found_ = 0, jumps_ = 0;
    bool started_ = false;
};

}  // namespace pilotage
