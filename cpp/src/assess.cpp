#include "pilotage/assess.hpp"

#include <algorithm>
#include <cmath>

namespace pilotage {

namespace {

constexpr double kChiSquare95 = 5.991464547107979;  // of two degrees of freedom

/// Largest standard deviation of the position in any direction, squared.
double largest_position_variance(const Matrix<double, 3>& p) noexcept {
    const double mean = (p(0, 0) + p(1, 1)) / 2, half = (p(0, 0) - p(1, 1)) / 2;
    return mean + std::hypot(half, p(1, 0));
}

}  // namespace

template <typename Scalar, int N>
Assessment assess(const Track<Scalar, N>& track, const Params& params, double silent_s) noexcept {
    const StatusParams& p = params.status;
    const Judgement& j = track.judgement;
    const Agreement& agreement = track.agreement;
    const Assessment rival{Status::ambiguous, Reason::rival, j.margin, judging::kDecisive};
    if (!track.started) return {Status::waiting, Reason::no_motion, 0, 0};
    if (j.finding == Finding::ambiguous) return rival;
    if (!track.located)
        return j.finding == Finding::elsewhere
                   ? Assessment{Status::initializing, Reason::found,
                                double(std::min(j.held, judging::kFrames)),
                                double(judging::kFrames)}
                   : Assessment{Status::waiting, Reason::no_pose, 0, 0};
    if (j.finding == Finding::elsewhere)
        return {Status::lost, Reason::elsewhere, j.margin, judging::kDecisive};
    if (agreement.disagrees())
        return {track.confirmed ? Status::lost : Status::initializing, Reason::disagreement,
                agreement.mean(), Agreement::kTooMuch};
    if (!track.confirmed)
        return {Status::initializing,
                agreement.confirms() && track.agreeing.count() < judging::kConfirmingMarkers
                    ? Reason::one_marker
                    : Reason::unconfirmed,
                double(agreement.in_a_row()), double(Agreement::kConfirming)};
    const double radius_m = std::sqrt(kChiSquare95 * largest_position_variance(track.covariance()));
    const double unfixed_s = seconds_between<double>(track.agreed_utime, track.utime);
    if (silent_s > p.lost_after_s)
        return {Status::lost, Reason::motion_gap, silent_s, p.lost_after_s};
    if (!(radius_m <= p.lost_limit_m))
        return {Status::lost, Reason::unsure, radius_m, p.lost_limit_m};
    if (silent_s > params.motion.max_gap_s)
        return {Status::dead_reckoning, Reason::motion_gap, silent_s, params.motion.max_gap_s};
    if (unfixed_s > p.dead_reckoning_after_s)
        return {Status::dead_reckoning, Reason::no_sighting, unfixed_s, p.dead_reckoning_after_s};
    if (!(radius_m <= p.alert_limit_m))
        return {Status::dead_reckoning, Reason::unsure, radius_m, p.alert_limit_m};
    return {Status::ok, Reason::none, 0, 0};
}

template Assessment assess(const Track<double, kPoseStates>&, const Params&, double) noexcept;
template Assessment assess(const Track<double, kCalibratedStates>&, const Params&, double) noexcept;
template Assessment assess(const Track<double, kTiltedStates>&, const Params&, double) noexcept;
template Assessment assess(const Track<float, kPoseStates>&, const Params&, double) noexcept;
template Assessment assess(const Track<float, kCalibratedStates>&, const Params&, double) noexcept;

}  // namespace pilotage
