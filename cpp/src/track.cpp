#include "pilotage/track.hpp"

#include <algorithm>
#include <cmath>

#include "pilotage/examine.hpp"
#include "pilotage/filter/ukf.hpp"

namespace pilotage {

namespace {

// How far a robot may be off that nobody measures, in sigmas.
constexpr double kLeastSpeed_m_s = 0.5;   // without a measured speed
constexpr double kLeastTurn_rad_s = 0.3;  // without a measured turn
constexpr double kCarried_m_s = 1;        // whoever carries it walks
constexpr double kCrooked = 0.3;          // of a distance driven unseen: how far off a plain arc
constexpr double kMoved_m = 0.5;          // while it was switched off
constexpr double kMoved_rad = 0.2;
// Beyond these, more doubt tells nothing more.
constexpr double kNoIdea_m = 10;
constexpr double kNoIdea_rad = 1;

constexpr int kLongSlip = 4;  // windows; after them the gyro may be stuck as well

double square(double v) noexcept {
    return v * v;
}

/// Variances of a pose that is off by so much.
Pose<double> variances(double sigma_m, double sigma_rad) noexcept {
    return {square(sigma_m), square(sigma_m), square(sigma_rad)};
}

/// Variances that are larger tell nothing more, and squares of them would overflow at last.
template <typename Scalar, int N>
Ekf<Scalar, N> bounded(const Ekf<Scalar, N>& filter) noexcept {
    const Matrix<Scalar, N>& p = filter.covariance();
    const auto most = [](int i) { return Scalar(i < kHeading ? kUnsurest : kUnsurestHeading); };
    if (!p.allFinite())
        return {filter.state(),
                diagonal(entries<Vector<Scalar, N>>([&](int i, int) { return most(i); }))};
    const auto shrink = entries<Vector<Scalar, N>>(
        [&](int i, int) { return p(i, i) > most(i) ? std::sqrt(most(i) / p(i, i)) : Scalar(1); });
    return {filter.state(), symmetric<Matrix<Scalar, N>>(
                                [&](int i, int j) { return shrink[i] * p(i, j) * shrink[j]; })};
}

/// So many times the first one's variance comes with the n-th of equal errors in a row: they add up
/// to one error of n times the size.
double growth(int n) noexcept {
    return 2 * n - 1;
}

}  // namespace

template <typename Scalar, int N>
Tracker<Scalar, N>::Tracker(const Params& params) noexcept
    : params_(params),
      tick_rad_(std::max(std::abs(params.wheels.left_m_per_tick),
                         std::abs(params.wheels.right_m_per_tick)) /
                params.wheels.track_width_m) {}

template <typename Scalar, int N>
Track<Scalar, N> Tracker<Scalar, N>::anywhere() const noexcept {
    Track track = start({0, 0, 0}, Matrix<double, 3>::Zero());
    track.located = false;
    return track;
}

template <typename Scalar, int N>
Track<Scalar, N> Tracker<Scalar, N>::start(const Pose<double>& pose,
                                           const Matrix<double, 3>& covariance) const noexcept {
    Track track;
    track.filter = start_filter<Scalar, N>(Pose<Scalar>(pose.template cast<Scalar>()),
                                           covariance.template cast<Scalar>(), params_);
    track.located = true;
    return track;
}

template <typename Scalar, int N>
Checkpoint Tracker<Scalar, N>::checkpoint(const Track& track) const noexcept {
    Checkpoint c;
    c.utime = track.utime;
    c.ticks = track.ticks.last();
    constexpr int kept = std::min(N, kCalibratedStates);  // a tilt does not last
    c.states = kept;
    c.state.template head<kept>() =
        track.filter.state().template head<kept>().template cast<double>();
    c.covariance.template topLeftCorner<kept, kept>() =
        track.filter.covariance().template topLeftCorner<kept, kept>().template cast<double>();
    return c;
}

template <typename Scalar, int N>
bool Tracker<Scalar, N>::restore(const Checkpoint& from, Track& track) const noexcept {
    const Matrix<double, kCalibratedStates>& p = from.covariance;
    if (!from.state.allFinite() || !p.allFinite() || from.state.cwiseAbs().maxCoeff() > kFarthest ||
        p.cwiseAbs().maxCoeff() > kUnsurest || !(p.isApprox(p.transpose())) || !is_covariance(p))
        return false;
    track = start(from.state.template head<3>(), p.template topLeftCorner<3, 3>());
    constexpr int kept = std::min(N, kCalibratedStates);
    if (from.states == kept) {
        Vector<Scalar, N> x = track.filter.state();
        Matrix<Scalar, N> full = track.filter.covariance();
        x.template head<kept>() = from.state.template head<kept>().template cast<Scalar>();
        full.template topLeftCorner<kept, kept>() =
            p.template topLeftCorner<kept, kept>().template cast<Scalar>();
        track.filter = {x, full};
    }
    track.ticks.start(from.ticks);
    track.restored = true;
    return true;
}

template <typename Scalar, int N>
void Tracker<Scalar, N>::begin(Track& track, const Sample& motion) const noexcept {
    track.utime = track.agreed_utime = motion.utime;
    track.tilt_utime = track.evidence_since = track.search_due_utime = motion.utime;
    track.started = true;
    (void)track.gyro.take(motion.utime, params_.motion.max_gap_s);
    if (params_.motion.source == MotionSource::encoders) {
        const EncoderTicks& now = motion.payload.ticks;
        const bool unmoved =
            track.restored && track.ticks.last() == now && (now.left != 0 || now.right != 0);
        track.ticks.start(now);
        track.confirmed = unmoved;
        if (unmoved) return;
    }
    if (track.restored) doubt(track.filter, variances(kMoved_m, kMoved_rad));
}

template <typename Scalar, int N>
Increment<Scalar> Tracker<Scalar, N>::measure(Track& track, const Sample& motion,
                                              Verdict& verdict) const noexcept {
    const MotionParams& params = params_.motion;
    const double dt_s = seconds_between<double>(track.utime, motion.utime);
    const std::optional<double> gyro_turn_rad = track.gyro.take(motion.utime, params.max_gap_s);
    verdict = Verdict::fused;
    Pose<double> doubt = Pose<double>::Zero();
    RotationStep rotation;
    Increment<Scalar> u = params.source == MotionSource::encoders
                              ? by_wheels(track, motion.payload.ticks, dt_s, rotation, verdict)
                              : by_velocity(motion.payload.velocity, dt_s, rotation);
    if (verdict == Verdict::counter_reset)
        doubt = farthest(track, dt_s, gyro_turn_rad.has_value());
    else if (dt_s > params.max_gap_s && params.source == MotionSource::encoders)
        doubt = variances(kCrooked * double(u.distance_m), 0);
    else if (dt_s > params.max_gap_s)
        doubt = farthest(track, dt_s - params.max_gap_s, gyro_turn_rad.has_value());

    if (gyro_turn_rad) {
        rotation.gyro_turn_rad = *gyro_turn_rad - gyro_bias(track) * dt_s;
        rotation.gyro_frozen = track.gyro.frozen();
        if (params.heading != HeadingSource::wheels && !track.check.gyro_suspect())
            take_turn(u, Scalar(*gyro_turn_rad), params.heading, params_.noise);
    }
    const bool stood = track.check.state() == MotionState::standing;
    const bool ended = track.check.add(rotation, tolerance(track));
    if (stood && track.check.state() == MotionState::standing) u = standstill(u);
    u.turn_rad += Scalar(track.check.released_rad());
    if (ended) doubt += judged_window(track);
    const Pose<Scalar> even = pose_process_noise(u, params_.noise);
    const Pose<Scalar> uneven = useful(track.filter, doubt);
    fill(u.process_noise, [&](int i, int) { return even[i] + uneven[i]; });
    if (dt_s > 0) track.motion = u;
    track.drift.position_m2 += double(u.covariance(0, 0) + u.process_noise[kX]);
    track.drift.heading_rad2 += double(u.covariance(1, 1) + u.process_noise[kHeading]);
    track.driven = calibrated_motion(track.filter.state(), u, params_);
    return u;
}

/// \param rotation receives what the wheels have to say of it
template <typename Scalar, int N>
Increment<Scalar> Tracker<Scalar, N>::by_wheels(Track& track, const EncoderTicks& ticks,
                                                double dt_s, RotationStep& rotation,
                                                Verdict& verdict) const noexcept {
    const bool ticked = !(ticks == track.ticks.last());
    double left_m = 0, right_m = 0;
    if (track.ticks.advance(ticks, dt_s, params_.wheels, left_m, right_m) == TickFault::reset)
        verdict = Verdict::counter_reset;
    const auto u = from_wheels(Scalar(left_m), Scalar(right_m), Scalar(dt_s),
                               Scalar(params_.wheels.track_width_m), params_.noise);
    rotation = {dt_s, ticked, double(u.distance_m), double(u.turn_rad), double(u.covariance(1, 1)),
                {},   false};
    return u;
}

/// Of a velocity message nobody says that its turn comes from wheels, so it is held against nothing
/// but a standstill.
template <typename Scalar, int N>
Increment<Scalar> Tracker<Scalar, N>::by_velocity(const BodyVelocity& velocity, double dt_s,
                                                  RotationStep& rotation) const noexcept {
    const bool moves = velocity.v_m_s != 0 || velocity.omega_rad_s != 0;
    auto u = from_velocity(Scalar(velocity.v_m_s), Scalar(velocity.omega_rad_s),
                           Scalar(std::fmin(dt_s, params_.motion.max_gap_s)), params_.noise);
    u.dt_s = Scalar(dt_s);
    rotation = {dt_s, moves, double(u.distance_m), double(u.turn_rad), moves ? kNoIdea_rad : 0,
                {},   false};
    return u;
}

/// What a whole window of motion brought to light, after the event: variances of the pose.
template <typename Scalar, int N>
Pose<double> Tracker<Scalar, N>::judged_window(Track& track) const noexcept {
    const MotionCheck::Window& window = track.check.window();
    const bool contradicted =
        track.agreement.disagrees() || track.judgement.finding != Finding::fine;
    Pose<double> doubt = Pose<double>::Zero();
    switch (track.check.state()) {
        case MotionState::standing:
            if (track.check.settled() && window.disagreement_rad == 0) learn_bias(track);
            break;
        case MotionState::lifted:
            // A gyro that the sightings contradict may have made the lift up, and the heading.
            doubt = variances(kCarried_m_s * window.duration_s, contradicted ? kNoIdea_rad : 0) *
                    growth(window.in_a_row);
            break;
        case MotionState::slipping: {
            const double off_rad = std::min(std::abs(window.disagreement_rad), kNoIdea_rad);
            const bool gyro_suspect = track.check.gyro_suspect();
            if (gyro_suspect && !window.by_gyro) break;  // the gyro is left out already
            const bool gyro_knows = params_.motion.heading == HeadingSource::gyro &&
                                    !gyro_suspect && window.in_a_row <= kLongSlip;
            doubt = variances(off_rad * (params_.wheels.track_width_m + window.distance_m) / 2,
                              gyro_knows ? 0 : off_rad);
            if (!gyro_suspect) doubt *= growth(window.in_a_row);
            break;
        }
        case MotionState::driving:
            // Wheels or gyro are off by less than one window shows, and the sightings tell as well.
            if (contradicted) doubt = variances(0, window.lasting_rad);
            break;
    }
    return doubt;
}

/// With the noise that the motion proved to have. Out of line, to keep the usual way short.
template <typename Scalar, int N>
void Tracker<Scalar, N>::drive_as_learned(Track& track, const Increment<Scalar>& u) const noexcept {
    const double scale = track.noise.motion();
    move(track.filter, with_noise_times(Scalar(scale * scale), u, params_.noise));
}

template <typename Scalar, int N>
void Tracker<Scalar, N>::move(Ekf<Scalar, N>& filter, const Increment<Scalar>& u) const noexcept {
    if (params_.filter == Filter::ukf)
        move_unscented(filter, u);
    else
        dead_reckon(filter, u, params_);
}

template <typename Scalar, int N>
void Tracker<Scalar, N>::move_unscented(Ekf<Scalar, N>& filter,
                                        const Increment<Scalar>& u) const noexcept {
    const auto motion = motion_of(filter.state(), u, params_);
    unscented_predict(filter, motion.model, motion.u, motion.gamma, motion.q);
}

template <typename Scalar, int N>
void Tracker<Scalar, N>::drive(Track& track, const Increment<Scalar>& u) const noexcept {
    if (params_.noise.adapts())
        drive_as_learned(track, u);
    else
        move(track.filter, u);
    if (!(track.filter.covariance().trace() <= Scalar(kUnsurestHeading)))
        track.filter = bounded(track.filter);
}

/// Variances of the pose after a time of which nothing is known but how fast the robot was.
template <typename Scalar, int N>
Pose<double> Tracker<Scalar, N>::farthest(const Track& track, double time_s,
                                          bool turn_known) const noexcept {
    double speed_m_s = kLeastSpeed_m_s, rate_rad_s = turn_known ? 0 : kLeastTurn_rad_s;
    if (const auto dt_s = double(track.motion.dt_s); dt_s > 0) {
        speed_m_s = std::max(speed_m_s, std::abs(double(track.motion.distance_m)) / dt_s);
        if (!turn_known)
            rate_rad_s = std::max(rate_rad_s, std::abs(double(track.motion.turn_rad)) / dt_s);
    }
    return variances(speed_m_s * time_s, rate_rad_s * time_s);
}

/// As much of it as brings the filter to having no idea.
template <typename Scalar, int N>
Pose<Scalar> Tracker<Scalar, N>::useful(const Ekf<Scalar, N>& filter,
                                        const Pose<double>& doubt) const noexcept {
    const double most[] = {square(kNoIdea_m), square(kNoIdea_m), square(kNoIdea_rad)};
    return entries<Pose<Scalar>>([&](int i, int) {
        const double room = std::max(0.0, most[i] - double(filter.covariance()(i, i)));
        return Scalar(std::min(doubt[i], room));
    });
}

template <typename Scalar, int N>
void Tracker<Scalar, N>::doubt(Ekf<Scalar, N>& filter,
                               const Pose<double>& variances) const noexcept {
    Increment<Scalar> u;
    u.process_noise = useful(filter, variances);
    dead_reckon(filter, u, params_);
}

template <typename Scalar, int N>
RotationTolerance Tracker<Scalar, N>::tolerance(const Track& track) const noexcept {
    RotationTolerance t;
    t.gyro_variance_per_s = square(params_.noise.gyro_rad_per_sqrt_s);
    if constexpr (N >= kCalibratedStates)
        t.gyro_bias_variance = double(track.filter.covariance()(kGyroBias, kGyroBias));
    if (params_.motion.source == MotionSource::encoders) t.tick_rad = tick_rad_;
    return t;
}

template <typename Scalar, int N>
double Tracker<Scalar, N>::gyro_bias(const Track& track) const noexcept {
    if constexpr (N >= kCalibratedStates) return double(track.filter.state()[kGyroBias]);
    return params_.gyro_bias.initial;
}

/// Zero-rotation update: what the gyro told of a robot that stood is its bias.
template <typename Scalar, int N>
void Tracker<Scalar, N>::learn_bias(Track& track) const noexcept {
    if constexpr (N >= kCalibratedStates) {
        const MotionCheck::Window& window = track.check.window();
        Vector<Scalar, 1> innovation, variance;
        innovation << Scalar(window.gyro_turn_rad / window.duration_s);
        variance << Scalar(square(params_.noise.gyro_rad_per_sqrt_s) / window.duration_s);
        Matrix<Scalar, 1, N> h = Matrix<Scalar, 1, N>::Zero();
        h(0, kGyroBias) = 1;
        const Pose<double> odometry = track.odometry();  // what is learned moves the pose as well
        (void)track.filter.correct_independent(innovation, h, variance, Policy{});
        track.keep_odometry(odometry);
    }
}

template <typename Scalar, int N>
Track<Scalar, N> Tracker<Scalar, N>::predicted(Track track, std::int64_t utime) const noexcept {
    const auto ahead_s = seconds_between<double>(track.utime, utime);
    if (!track.started || !(ahead_s > 0)) return track;
    const double known_s = std::min(ahead_s, params_.motion.max_gap_s);
    Increment<Scalar> u;
    if (track.motion.dt_s > 0) u = track.motion.part(Scalar(known_s) / track.motion.dt_s);
    u.dt_s = Scalar(ahead_s);
    u.process_noise = pose_process_noise(u, params_.noise) +
                      useful(track.filter, farthest(track, ahead_s - known_s, false));
    drive(track, u);
    track.utime = utime;
    return track;
}

template class Tracker<double, kPoseStates>;
template class Tracker<double, kCalibratedStates>;
template class Tracker<double, kTiltedStates>;
template class Tracker<float, kPoseStates>;
template class Tracker<float, kCalibratedStates>;

}  // namespace pilotage
