#include "pilotage/localizer.hpp"

#include <algorithm>
#include <cmath>

#include "pilotage/assess.hpp"
#include "pilotage/examine.hpp"
#include "pilotage/sighting_report.hpp"

namespace pilotage {

namespace {

constexpr std::int64_t kMicroseconds = 1'000'000;

/// Motion samples hold a track, the others only what was said about them.
bool is_motion(const Sample& sample) noexcept {
    return sample.stream == Stream::motion;
}

}  // namespace

template <typename Scalar, int N>
Localizer<Scalar, N>::Localizer(const Params& params, MarkerMap map, Listener& listener,
                                WallMap walls)
    : tracker_(params),
      fixer_(params, map, std::move(walls)),
      search_(params, std::move(map)),
      listener_(&listener),
      history_(static_cast<std::size_t>(params.history.capacity)) {
    past() = tracker_.anywhere();
    const InitialParams& start = params.initial;
    if (std::isnan(start.x_m) || std::isnan(start.y_m) || std::isnan(start.heading_rad)) return;
    const Pose<double> sigma(start.sigma_position_m, start.sigma_position_m,
                             start.sigma_heading_rad);
    past() =
        tracker_.start({start.x_m, start.y_m, start.heading_rad}, sigma.cwiseAbs2().asDiagonal());
}

template <typename Scalar, int N>
bool Localizer<Scalar, N>::restore(const Checkpoint& from) noexcept {
    return tracker_.restore(from, past());
}

template <typename Scalar, int N>
bool Localizer<Scalar, N>::add(const Sample* samples, std::size_t count) noexcept {
    bool moved = false;
    std::size_t changed = kNowhere;  // the first place since the tracks were computed
    for (const Sample* sample = samples; sample != samples + count; ++sample) {
        if (!welcome(*sample)) continue;
        if (history_.full()) {
            recompute(changed);  // what goes has to be right
            forget_step();
        }
        const std::size_t place = insert(*sample);
        changed = std::min(changed, place);
        if (place == kNowhere || !is_motion(*sample)) continue;
        moved |= motion_before(history_.size()) == place;
        recompute(changed);
        forget_before(newest().utime - static_cast<std::int64_t>(
                                           tracker_.params().history.window_s * kMicroseconds));
    }
    recompute(changed);
    return moved;
}

/// Whether a sample has a place in the history, unless it is there already. What has none is
/// answered here.
template <typename Scalar, int N>
bool Localizer<Scalar, N>::welcome(const Sample& sample) noexcept {
    const Verdict first = examine(sample, tracker_.params());
    if (first != Verdict::pending) return refuse(sample, first, NAN, NAN);
    if (!has_pose() && !newest().started && sample.stream == Stream::reset) {
        fixer_.reset(past(), sample.payload.reset);
        listener_->on_verdict(sample, Verdict::pending, Verdict::fused);
        return false;
    }
    const double age_s = seconds_between<double>(sample.utime, newest().utime);
    const double window_s = tracker_.params().history.window_s;
    return !(newest().started && age_s > window_s) ||
           refuse(sample, Verdict::late, age_s, window_s);
}

template <typename Scalar, int N>
bool Localizer<Scalar, N>::refuse(const Sample& sample, Verdict verdict, double value,
                                  double limit) noexcept {
    if (is_measurement(sample.stream)) {
        SightingReport report = blank_report(sample, verdict);
        report.value = value;
        report.limit = limit;
        listener_->on_sighting(report);
    }
    listener_->on_verdict(sample, Verdict::pending, verdict);
    return false;
}

/// Puts a sample into its place, without computing anything.
/// \pre the history is not full
/// \return the place, or kNowhere if it was refused
template <typename Scalar, int N>
std::size_t Localizer<Scalar, N>::insert(const Sample& sample) noexcept {
    if (past().started && sample.utime <= past().utime) {
        refuse(sample, Verdict::late, seconds_between<double>(sample.utime, newest().utime),
               seconds_between<double>(past().utime, newest().utime));
        return kNowhere;
    }
    bool duplicate = false;
    const std::size_t place = history_.place(sample, duplicate);
    if (duplicate) {
        refuse(sample, Verdict::duplicate, NAN, NAN);
        return kNowhere;
    }
    Node& node = history_.insert(place);
    node.sample = sample;
    node.verdict = Verdict::pending;
    node.revision = 0;
    node.seen = false;
    if (sample.stream == Stream::gyro) settle(node, Verdict::fused);
    return place;
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

/// Drops the oldest samples up to a motion sample, where the past then ends; where there is none,
/// what waits longest.
template <typename Scalar, int N>
void Localizer<Scalar, N>::forget_step() noexcept {
    const std::size_t end = first_motion();
    for (std::size_t left = end == history_.size() ? 1 : end + 1; left > 0; --left) forget_front();
}

/// Drops the oldest sample; what it brought stays in the past.
template <typename Scalar, int N>
void Localizer<Scalar, N>::forget_front() noexcept {
    Node& front = history_[0];
    if (is_motion(front.sample)) return history_.pass_front();
    if (front.sample.stream == Stream::gyro)
        past().gyro.add(front.sample.utime, front.sample.payload.gyro.rate_rad_s,
                        tracker_.params().motion.max_gap_s);
    else if (front.verdict == Verdict::pending)
        dismiss(front, Verdict::no_motion);
    else if (front.seen)
        memory_.add({front.sample.utime, front.evidence});
    history_.pop_front();
}

template <typename Scalar, int N>
void Localizer<Scalar, N>::set_time(std::int64_t utime) noexcept {
    const Track now = newest();
    finish();
    while (history_.size() > 0) history_.pop_front();
    memory_ = {};
    Track& track = past() = now;
    const std::int64_t by = utime - track.utime;
    for (std::int64_t* time : {&track.utime, &track.agreed_utime, &track.tilt_utime,
                               &track.search_due_utime, &track.evidence_since})
        *time += by;
    track.gyro.restart(utime);
}

template <typename Scalar, int N>
void Localizer<Scalar, N>::finish() noexcept {
    for (std::size_t i = 0; i < history_.size(); ++i)
        if (history_[i].verdict == Verdict::pending) dismiss(history_[i], Verdict::no_motion);
}

/// Computes the tracks anew from the last motion sample before `place`, which then is kNowhere.
template <typename Scalar, int N>
void Localizer<Scalar, N>::recompute(std::size_t& place) noexcept {
    if (place == kNowhere) return;
    const std::size_t before = motion_before(place);
    place = kNowhere;
    const Track* last = &track_at(before);
    std::size_t done = before == history_.size() ? 0 : before + 1;
    for (std::size_t i = done; i < history_.size(); ++i) {
        if (!is_motion(history_[i].sample)) continue;
        Track& track = history_[i].track = *last;
        advance(track, done, i);
        last = &track;
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
            track.gyro.add(sample.utime, sample.payload.gyro.rate_rad_s,
                           tracker_.params().motion.max_gap_s);
    }
    if (!track.started) return begin(track, from, to);
    Verdict verdict = Verdict::fused;
    Increment<Scalar> rest = tracker_.measure(track, motion.sample, verdict);
    const auto move_to = [&](std::int64_t utime) {
        const auto left_s = seconds_between<Scalar>(track.utime, motion.sample.utime);
        const auto dt_s = seconds_between<Scalar>(track.utime, utime);
        track.utime = utime;
        if (dt_s <= 0) return;
        const Scalar fraction = dt_s / left_s;
        tracker_.drive(track, rest.part(fraction));
        rest = rest.part(1 - fraction);
    };
    bool seen = false;  // something in this frame
    for (std::size_t i = from, frame = from, frame_end = from; i < to; ++i) {
        Node& node = history_[i];
        if (node.sample.stream == Stream::gyro) continue;
        move_to(node.sample.utime);
        if (node.sample.stream == Stream::reset) {
            reset(track, node);
            continue;
        }
        if (node.sample.stream != Stream::sighting) {
            report(node, fixer_.fix(track, node.sample));
            const bool last = i + 1 == to || !same_frame(node.sample, history_[i + 1].sample);
            if (last && fixer_.doubtful(track)) search(track, i);
            continue;
        }
        if (i >= frame_end) {
            seen = false;
            frame = i;
            frame_end = recognise(track, i, to);
        }
        correct(track, node, frame_[i - frame]);
        seen = seen || node.seen;
        const bool frame_ends = i + 1 == frame_end;
        if (frame_ends && seen && fixer_.doubtful(track)) search(track, i);
    }
    track.utime = motion.sample.utime;
    if (rest.dt_s > 0 || rest.distance_m != 0 || rest.turn_rad != 0) tracker_.drive(track, rest);
    settle(motion, verdict);
}

/// The first motion sample: what was seen before it has no motion to be placed in.
template <typename Scalar, int N>
void Localizer<Scalar, N>::begin(Track& track, std::size_t from, std::size_t to) noexcept {
    for (std::size_t i = from; i < to; ++i) {
        Node& node = history_[i];
        if (node.sample.stream == Stream::reset)
            reset(track, node);
        else if (is_measurement(node.sample.stream))
            dismiss(node, Verdict::before_motion);
    }
    tracker_.begin(track, history_[to].sample);
    settle(history_[to], Verdict::fused);
}

/// Takes a pose given from outside.
template <typename Scalar, int N>
void Localizer<Scalar, N>::reset(Track& track, Node& node) noexcept {
    fixer_.reset(track, node.sample.payload.reset);
    settle(node, Verdict::fused);
}

/// Gathers the frame of the sighting at `from` and finds its markers. \return the frame's end
template <typename Scalar, int N>
std::size_t Localizer<Scalar, N>::recognise(const Track& track, std::size_t from,
                                            std::size_t to) noexcept {
    const Sample& first = history_[from].sample;
    frame_.begin_frame();
    std::size_t i = from;
    do frame_.add(history_[i].sample.payload.sighting);
    while (++i < to && same_frame(first, history_[i].sample) && !frame_.full());
    fixer_.recognise(track, first.source, frame_);
    return i;
}

/// Fuses a sighting as one of the marker that was found for it; the sample itself stays as it came,
/// so that a late one may change what is found.
template <typename Scalar, int N>
void Localizer<Scalar, N>::correct(Track& track, Node& node, const Association& of) noexcept {
    node.evidence = fixer_.evidence(track, node.sample, search_);
    SightingReport result = fixer_.sight(track, node.sample, of);
    node.seen = result.verdict != Verdict::unknown_marker;
    result.given_id = node.sample.payload.sighting.id;
    report(node, result);
}

/// Tells what became of a measurement.
template <typename Scalar, int N>
void Localizer<Scalar, N>::report(Node& node, SightingReport report) noexcept {
    report.revision = node.revision++;
    listener_->on_sighting(report);
    settle(node, report.verdict);
}

/// Looks for other poses that explain the latest sightings, up to the one at `newest`.
template <typename Scalar, int N>
void Localizer<Scalar, N>::search(Track& track, std::size_t newest) noexcept {
    Evidence evidence[Evidence::kMost];
    int count = 0, looked_at = 0;
    const auto take = [&](std::int64_t utime, const Evidence& e) {
        if (++looked_at > Memory::kCapacity || count == Evidence::kMost ||
            utime < track.evidence_since)
            return;
        const auto same = [&](const Evidence& other) { return other.sighting.id == e.sighting.id; };
        if (e.sighting.id >= 0 &&
            std::count_if(evidence, evidence + count, same) >= fixer_.evidence_wanted(track))
            return;
        evidence[count++] = e;
    };
    for (std::size_t i = newest + 1; i-- > 0;)
        if (history_[i].seen) take(history_[i].sample.utime, history_[i].evidence);
    memory_.each_newest_first([&](const Memory::Item& item) { take(item.utime, item.evidence); });
    fixer_.search(track, evidence, count, search_);
}

/// Says no to a sample that has a place in the history.
template <typename Scalar, int N>
void Localizer<Scalar, N>::dismiss(Node& node, Verdict verdict) noexcept {
    if (is_measurement(node.sample.stream)) return report(node, blank_report(node.sample, verdict));
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

/// At a motion sample, or where the past ends if the place is size().
template <typename Scalar, int N>
const typename Localizer<Scalar, N>::Track& Localizer<Scalar, N>::track_at(
    std::size_t motion) const noexcept {
    return (motion == history_.size() ? history_.past() : history_[motion]).track;
}

template <typename Scalar, int N>
const typename Localizer<Scalar, N>::Track& Localizer<Scalar, N>::newest() const noexcept {
    return track_at(motion_before(history_.size()));
}

template <typename Scalar, int N>
Estimate Localizer<Scalar, N>::describe(const Track& track, double silent_s) const noexcept {
    Estimate e;
    e.utime = track.utime;
    e.pose = track.pose();
    e.covariance = track.covariance();
    e.driven = track.driven.template cast<double>();
    if (track.motion.dt_s > 0 && silent_s <= tracker_.params().motion.max_gap_s) {
        const auto driven =
            calibrated_motion(track.filter.state(), track.motion, tracker_.params());
        e.v_m_s = double(driven[0] / track.motion.dt_s);
        e.omega_rad_s = double(driven[1] / track.motion.dt_s);
    }
    static_cast<Assessment&>(e) = assess(track, tracker_.params(), silent_s);
    e.motion = track.check.state();
    e.disagreement_rad = track.check.window().disagreement_rad;
    e.gyro_left_out = track.check.gyro_suspect();
    e.resets = track.resets;
    e.found = track.found;
    return e;
}

template <typename Scalar, int N>
Estimate Localizer<Scalar, N>::estimate() const noexcept {
    return describe(newest(), 0);
}

template <typename Scalar, int N>
Estimate Localizer<Scalar, N>::estimate(std::int64_t utime) const noexcept {
    const double silent_s = std::fmax(0, seconds_between<double>(newest().utime, utime));
    return describe(tracker_.predicted(newest(), utime), newest().started ? silent_s : 0);
}

template class Localizer<double, kPoseStates>;
template class Localizer<double, kCalibratedStates>;
template class Localizer<double, kTiltedStates>;
template class Localizer<float, kPoseStates>;
template class Localizer<float, kCalibratedStates>;

}  // namespace pilotage
