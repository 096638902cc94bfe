#include "pilotage/localizer.hpp"

#include <cmath>

namespace pilotage {

namespace {

constexpr std::int64_t kMicroseconds = 1'000'000;
constexpr std::int64_t kLastTime = std::int64_t{1}
                                   << 60;   // differences of such times fit in 64 bits
constexpr double kFastestTurn_rad_s = 100;  // no ground robot turns faster
constexpr double kFarthest = 1e7;           // m or rad, no pose is farther off
constexpr double kUnsurest =
    1e9;  // m^2 or rad^2; of more, rounding would leave negative variances behind
constexpr double kChiSquare95 = 5.991464547107979;  // of two degrees of freedom

/// What is wrong with the numbers of a reset; `pending` if nothing.
Verdict examine_numbers(const PoseReset& reset) noexcept {
    bool finite = true, plausible = true;
    const auto look = [&](double v, double limit) {
        finite = finite && std::isfinite(v);
        plausible = plausible && std::abs(v) <= limit;
    };
    for (const double v : reset.pose) look(v, kFarthest);
    for (const double v : reset.covariance) look(v, kUnsurest);
    return !finite ? Verdict::bad_value : plausible ? Verdict::pending : Verdict::implausible;
}

Matrix<double, 3> covariance_of(const PoseReset& reset) noexcept {
    Matrix<double, 3> p;
    for (int i = 0, at = 0; i < 3; ++i)
        for (int j = 0; j <= i; ++j) p(i, j) = p(j, i) = reset.covariance[at++];
    return p;
}

bool usable(const Sighting& sighting) noexcept {
    int measured = 0;
    for (int i = 0; i < 3; ++i) {
        if (std::isinf(sighting.value[i])) return false;
        if (std::isnan(sighting.value[i])) continue;
        ++measured;
        const double sigma = sighting.sigma[i];
        if (!std::isnan(sigma) && !(sigma > 0 && std::isfinite(sigma))) return false;
    }
    return measured > 0;
}

/// Motion samples hold a track, the others only what was said about them.
bool is_motion(const Sample& sample) noexcept {
    return sample.stream == Stream::motion;
}

}  // namespace

template <typename Scalar, int N>
Localizer<Scalar, N>::Localizer(const Params& params, MarkerMap map, Listener& listener)
    : params_(params),
      map_(std::move(map)),
      listener_(&listener),
      history_(static_cast<std::size_t>(params.history.capacity)) {
    for (int i = 0; i < params.sensor_count; ++i) {
        const MarkerSensorParams& sensor = params.sensors[i];
        policies_[i] = Policy::make(sensor.fusion, sensor.gate_false_reject, sensor.student_t_dof);
    }
    const InitialParams& start = params.initial;
    if (std::isnan(start.x_m) || std::isnan(start.y_m) || std::isnan(start.heading_rad)) return;
    const auto square = [](double sigma) { return Scalar(sigma * sigma); };
    const Vector<Scalar, 3> variances(square(start.sigma_position_m),
                                      square(start.sigma_position_m),
                                      square(start.sigma_heading_rad));
    base_.filter =
        start_filter<Scalar, N>({Scalar(start.x_m), Scalar(start.y_m), Scalar(start.heading_rad)},
                                variances.asDiagonal(), params_);
    initialized_ = true;
}

template <typename Scalar, int N>
bool Localizer<Scalar, N>::add(const Sample& sample) noexcept {
    const Verdict first = examine(sample);
    if (first != Verdict::pending) return refuse(sample, first, NAN, NAN);
    if (!initialized_ && sample.stream == Stream::reset) {
        base_.filter = start_filter<Scalar, N>(
            Pose<Scalar>(Vector<double, 3>(sample.payload.reset.pose).template cast<Scalar>()),
            covariance_of(sample.payload.reset).template cast<Scalar>(), params_);
        initialized_ = true;
        listener_->on_verdict(sample, Verdict::pending, Verdict::fused);
        return false;
    }
    if (!initialized_) return refuse(sample, Verdict::not_initialized, NAN, NAN);
    const double age_s = seconds_between<double>(sample.utime, newest().utime);
    if (newest().started && age_s > params_.history.window_s)
        return refuse(sample, Verdict::late, age_s, params_.history.window_s);
    return insert(sample);
}

/// What is wrong with a sample by itself; `pending` if nothing.
template <typename Scalar, int N>
Verdict Localizer<Scalar, N>::examine(const Sample& sample) const noexcept {
    if (sample.utime < -kLastTime || sample.utime > kLastTime) return Verdict::bad_value;
    const Sample::Payload& payload = sample.payload;
    switch (sample.stream) {
        case Stream::reset: {
            if (const Verdict v = examine_numbers(payload.reset); v != Verdict::pending) return v;
            const bool covariance =
                Ldlt<double, 3>(covariance_of(payload.reset), 1e-12).semidefinite();
            return covariance ? Verdict::pending : Verdict::bad_value;
        }
        case Stream::gyro:
            if (!std::isfinite(payload.gyro.rate_rad_s)) return Verdict::bad_value;
            return std::abs(payload.gyro.rate_rad_s) > kFastestTurn_rad_s ? Verdict::implausible
                                                                          : Verdict::pending;
        case Stream::motion: {
            if (params_.motion.source == MotionSource::encoders) return Verdict::pending;
            const BodyVelocity& velocity = payload.velocity;
            if (!std::isfinite(velocity.v_m_s) || !std::isfinite(velocity.omega_rad_s))
                return Verdict::bad_value;
            return std::abs(velocity.v_m_s) > params_.wheels.max_speed_m_s ||
                           std::abs(velocity.omega_rad_s) > kFastestTurn_rad_s
                       ? Verdict::implausible
                       : Verdict::pending;
        }
        case Stream::sighting:
            return usable(payload.sighting) ? Verdict::pending : Verdict::bad_value;
    }
    return Verdict::bad_value;
}

template <typename Scalar, int N>
bool Localizer<Scalar, N>::refuse(const Sample& sample, Verdict verdict, double value,
                                  double limit) noexcept {
    if (sample.stream == Stream::sighting) {
        SightingReport report = blank_report(sample, verdict);
        report.value = value;
        report.limit = limit;
        listener_->on_sighting(report);
    }
    listener_->on_verdict(sample, Verdict::pending, verdict);
    return false;
}

template <typename Scalar, int N>
bool Localizer<Scalar, N>::insert(const Sample& sample) noexcept {
    if (history_.full()) forget_step();
    if (base_.started && sample.utime <= base_.utime)
        return refuse(sample, Verdict::late, seconds_between<double>(sample.utime, newest().utime),
                      seconds_between<double>(base_.utime, newest().utime));
    bool duplicate = false;
    const std::size_t place = history_.place(sample, duplicate);
    if (duplicate) return refuse(sample, Verdict::duplicate, NAN, NAN);
    Node& node = history_.insert(place);
    node.sample = sample;
    node.verdict = Verdict::pending;
    node.revision = 0;
    if (sample.stream == Stream::gyro) settle(node, Verdict::fused);
    if (!is_motion(sample)) {
        if (place + 1 < history_.size()) recompute(place);
        return false;
    }
    const bool newest_motion = motion_before(history_.size()) == place;
    recompute(place);
    forget_before(newest().utime -
                  static_cast<std::int64_t>(params_.history.window_s * kMicroseconds));
    return newest_motion;
}

/// Drops motion steps that no sample within the window can change any more.
template <typename Scalar, int N>
void Localizer<Scalar, N>::forget_before(std::int64_t horizon) noexcept {
    while (history_.size() > 0 && history_[0].sample.utime < horizon) {
        const std::size_t end = first_motion();
        if (end == history_.size() || history_[end].sample.utime >= horizon) return;
        forget_step();
    }
}

/// Drops the oldest samples up to a motion sample, where `base_` then stands; where there is none,
/// what waits longest.
template <typename Scalar, int N>
void Localizer<Scalar, N>::forget_step() noexcept {
    const std::size_t end = first_motion();
    for (std::size_t left = end == history_.size() ? 1 : end + 1; left > 0; --left) forget_front();
}

/// Drops the oldest sample; what it brought stays in `base_`.
template <typename Scalar, int N>
void Localizer<Scalar, N>::forget_front() noexcept {
    Node& front = history_[0];
    if (is_motion(front.sample))
        base_ = front.track;
    else if (front.sample.stream == Stream::gyro)
        base_.gyro.add(front.sample.utime, front.sample.payload.gyro.rate_rad_s,
                       params_.motion.max_gap_s);
    else if (front.verdict == Verdict::pending)
        dismiss(front, Verdict::no_motion);
    history_.pop_front();
}

template <typename Scalar, int N>
void Localizer<Scalar, N>::finish() noexcept {
    for (std::size_t i = 0; i < history_.size(); ++i)
        if (history_[i].verdict == Verdict::pending) dismiss(history_[i], Verdict::no_motion);
}

/// Computes the track anew from the last motion sample before `place`.
template <typename Scalar, int N>
void Localizer<Scalar, N>::recompute(std::size_t place) noexcept {
    const std::size_t before = motion_before(place);
    std::size_t done = before == history_.size() ? 0 : before + 1;
    Track track = before == history_.size() ? base_ : history_[before].track;
    for (std::size_t i = done; i < history_.size(); ++i) {
        if (!is_motion(history_[i].sample)) continue;
        advance(track, done, i);
        history_[i].track = track;
        done = i + 1;
    }
}

/// From the motion sample before `from` to the one at `to`, through the sightings in between.
template <typename Scalar, int N>
void Localizer<Scalar, N>::advance(Track& track, std::size_t from, std::size_t to) noexcept {
    Node& motion = history_[to];
    for (std::size_t i = from; i < to; ++i) {
        const Sample& sample = history_[i].sample;
        if (sample.stream == Stream::gyro)
            track.gyro.add(sample.utime, sample.payload.gyro.rate_rad_s, params_.motion.max_gap_s);
    }
    Increment<Scalar> rest = measured_motion(track, motion);
    const auto move_to = [&](std::int64_t utime) {
        const auto left_s = seconds_between<Scalar>(track.utime, motion.sample.utime);
        const auto dt_s = seconds_between<Scalar>(track.utime, utime);
        track.utime = utime;
        if (dt_s <= 0) return;
        const Scalar fraction = dt_s / left_s;
        dead_reckon(track.filter, rest.part(fraction), params_);
        rest = rest.part(1 - fraction);
    };
    for (std::size_t i = from; i < to; ++i) {
        Node& node = history_[i];
        if (node.sample.stream == Stream::gyro) continue;
        if (!track.started && node.sample.stream != Stream::reset) {
            dismiss(node, Verdict::before_motion);
            continue;
        }
        if (track.started) move_to(node.sample.utime);
        correct(track, node);
    }
    track.utime = motion.sample.utime;
    if (track.started && (rest.dt_s > 0 || rest.distance_m != 0 || rest.turn_rad != 0))
        dead_reckon(track.filter, rest, params_);
    track.started = true;
}

/// The motion that ends at a motion sample, and the counters that the next one starts from.
template <typename Scalar, int N>
Increment<Scalar> Localizer<Scalar, N>::measured_motion(Track& track, Node& motion) noexcept {
    const std::int64_t now = motion.sample.utime;
    const MotionParams& params = params_.motion;
    const std::optional<double> gyro_turn_rad = track.gyro.take(now, params.max_gap_s);
    Verdict verdict = Verdict::fused;
    Increment<Scalar> u;
    const double dt_s = seconds_between<double>(track.utime, now);
    if (params.source == MotionSource::velocity) {
        const BodyVelocity& velocity = motion.sample.payload.velocity;
        const auto held_s = Scalar(std::fmin(dt_s, params.max_gap_s));
        if (track.started)
            u = from_velocity(Scalar(velocity.v_m_s), Scalar(velocity.omega_rad_s), held_s,
                              params_.noise);
    } else if (track.started) {
        double left_m = 0, right_m = 0;
        const TickFault fault =
            track.ticks.advance(motion.sample.payload.ticks, dt_s, params_.wheels, left_m, right_m);
        if (fault == TickFault::reset) verdict = Verdict::counter_reset;
        u = from_wheels(Scalar(left_m), Scalar(right_m), Scalar(dt_s),
                        Scalar(params_.wheels.track_width_m), params_.noise);
    } else {
        track.ticks.start(motion.sample.payload.ticks);
    }
    settle(motion, verdict);
    if (!track.started) return u;
    u.dt_s = Scalar(dt_s);
    if (gyro_turn_rad && params.heading != HeadingSource::wheels)
        u = with_gyro(u, Scalar(*gyro_turn_rad), params.heading, params_.noise);
    if (dt_s > 0) track.motion = u;
    return u;
}

/// Fuses a sighting, or takes a pose given from outside.
template <typename Scalar, int N>
void Localizer<Scalar, N>::correct(Track& track, Node& node) noexcept {
    const Sample& sample = node.sample;
    if (sample.stream == Stream::reset) {
        const PoseReset& to = sample.payload.reset;
        Vector<Scalar, N> x = track.filter.state();
        Matrix<Scalar, N> p = track.filter.covariance();
        x.template head<3>() = Vector<double, 3>(to.pose).template cast<Scalar>();
        x[kHeading] = wrap(x[kHeading]);
        p.template topRows<3>().setZero();
        p.template leftCols<3>().setZero();
        p.template topLeftCorner<3, 3>() = covariance_of(to).template cast<Scalar>();
        track.filter = Ekf<Scalar, N>(x, p);
        ++track.resets;
        track.confirmed = false;
        settle(node, Verdict::fused);
        return;
    }
    SightingReport report = fuse_sighting(track.filter, sample, map_,
                                          params_.sensors[sample.source], policies_[sample.source]);
    if (report.verdict == Verdict::fused) {
        track.confirmed = true;
        track.last_fix_utime = sample.utime;
    }
    report.revision = node.revision++;
    listener_->on_sighting(report);
    settle(node, report.verdict);
}

/// Says no to a sample that has a place in the history.
template <typename Scalar, int N>
void Localizer<Scalar, N>::dismiss(Node& node, Verdict verdict) noexcept {
    if (node.sample.stream == Stream::sighting) {
        SightingReport report = blank_report(node.sample, verdict);
        report.revision = node.revision++;
        listener_->on_sighting(report);
    }
    settle(node, verdict);
}

template <typename Scalar, int N>
void Localizer<Scalar, N>::settle(Node& node, Verdict verdict) noexcept {
    if (node.verdict != verdict) listener_->on_verdict(node.sample, node.verdict, verdict);
    node.verdict = verdict;
}

/// The last motion sample before `place`, or size() if there is none.
template <typename Scalar, int N>
std::size_t Localizer<Scalar, N>::motion_before(std::size_t place) const noexcept {
    while (place > 0)
        if (is_motion(history_[--place].sample)) return place;
    return history_.size();
}

/// The first motion sample, or size() if there is none.
template <typename Scalar, int N>
std::size_t Localizer<Scalar, N>::first_motion() const noexcept {
    std::size_t i = 0;
    while (i < history_.size() && !is_motion(history_[i].sample)) ++i;
    return i;
}

template <typename Scalar, int N>
const typename Localizer<Scalar, N>::Track& Localizer<Scalar, N>::newest() const noexcept {
    const std::size_t motion = motion_before(history_.size());
    return motion == history_.size() ? base_ : history_[motion].track;
}

template <typename Scalar, int N>
Status Localizer<Scalar, N>::status(const Track& track) const noexcept {
    if (!initialized_ || !track.started) return Status::waiting;
    if (!track.confirmed) return Status::initializing;
    const auto p = track.filter.covariance().template topLeftCorner<2, 2>().template cast<double>();
    const double mean = (p(0, 0) + p(1, 1)) / 2, half = (p(0, 0) - p(1, 1)) / 2;
    const double largest_variance = mean + std::sqrt(half * half + p(1, 0) * p(1, 0));
    const double radius_squared = kChiSquare95 * largest_variance;
    const bool sure = radius_squared <= params_.status.alert_limit_m * params_.status.alert_limit_m;
    const bool fixed = seconds_between<double>(track.last_fix_utime, track.utime) <=
                       params_.status.dead_reckoning_after_s;
    return sure && fixed ? Status::ok : Status::dead_reckoning;
}

template <typename Scalar, int N>
Estimate Localizer<Scalar, N>::estimate() const noexcept {
    const Track& track = newest();
    Estimate e;
    e.utime = track.utime;
    e.pose = track.filter.state().template head<3>().template cast<double>();
    e.covariance = track.filter.covariance().template topLeftCorner<3, 3>().template cast<double>();
    if (track.motion.dt_s > 0) {
        const auto driven = calibrated_motion(track.filter.state(), track.motion, params_);
        e.v_m_s = double(driven[0] / track.motion.dt_s);
        e.omega_rad_s = double(driven[1] / track.motion.dt_s);
    }
    e.status = status(track);
    e.resets = track.resets;
    return e;
}

template class Localizer<double, kPoseStates>;
template class Localizer<double, kCalibratedStates>;
template class Localizer<float, kPoseStates>;
template class Localizer<float, kCalibratedStates>;

}  // namespace pilotage
