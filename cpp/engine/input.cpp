#include "input.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pilotage/sensing/line_of_sight.hpp"
#include "words.hpp"

namespace pilotage {

namespace {

/// Of any two times, also where their difference does not fit in 64 bits.
double seconds_from(std::int64_t from_us, std::int64_t to_us) noexcept {
    return (static_cast<double>(to_us) - static_cast<double>(from_us)) * 1e-6;
}

/// a - b, which wraps instead of overflowing: stamps may be anything.
std::int64_t earlier(std::int64_t a, std::int64_t b) noexcept {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) - static_cast<std::uint64_t>(b));
}

}  // namespace

const char* name(MessageFault fault) noexcept {
    constexpr const char* names[kMessageFaults] = {"wrong_type", "malformed", "unknown_sensor"};
    return names[static_cast<int>(fault)];
}

Input::Input(std::string name, const InputParams& params, Kind kind, int sensor)
    : name_(std::move(name)),
      params_(params),
      kind_(kind),
      sensor_(sensor),
      latency_us_(std::llround(params.latency_s * 1e6)) {}

Input::Date Input::date(std::int64_t utime, std::int32_t seq, std::int64_t received) noexcept {
    const SenderClock::Stamp stamp = clock_.look(utime, seq, received);
    followed_ = stamp == SenderClock::Stamp::followed;
    std::int64_t time = clock_.mapped(utime);
    if (params_.time == TimePolicy::utime) time = utime;
    if (params_.time == TimePolicy::receive) time = received;
    const bool good = params_.time == TimePolicy::receive || stamp != SenderClock::Stamp::jumped;
    return {earlier(time, latency_us_), good};
}

std::int64_t Input::now(std::int64_t received) const noexcept {
    const std::int64_t offset = params_.time == TimePolicy::utime ? clock_.offset_us() : 0;
    return earlier(earlier(received, offset), latency_us_);
}

void Input::received(std::int64_t received, std::int32_t seq, std::size_t samples) noexcept {
    if (seen_) {
        // A sender that restarts counts from zero again, which is no loss.
        const std::int64_t gap = std::int64_t{seq} - last_seq_ - 1;
        if (gap > 0) lost_ += gap;
        const double dt_s = std::fmax(0, seconds_from(last_received_, received));
        if (interval_s_ == 0) interval_s_ = usual_interval_s_ = dt_s;
        const double counted_s = std::fmin(dt_s, 5 * interval_s_);  // an outage is no rate
        interval_s_ += 0.05 * (counted_s - interval_s_);
        usual_interval_s_ += std::fmin(0.05, dt_s / 60) * (counted_s - usual_interval_s_);
    }
    seen_ = true;
    last_seq_ = seq;
    last_received_ = received;
    verdicts_[static_cast<int>(Verdict::pending)] += static_cast<std::int64_t>(samples);
}

void Input::fault(MessageFault fault) noexcept {
    ++faults_[static_cast<int>(fault)];
}

void Input::judged(Verdict before, Verdict now) noexcept {
    --verdicts_[static_cast<int>(before)];
    ++verdicts_[static_cast<int>(now)];
}

void Input::reported(const SightingReport& report, double distance_m) noexcept {
    if (report.verdict != Verdict::fused && report.verdict != Verdict::gate) return;
    const double contradicts = report.agrees ? 0 : 1;
    contradiction_ += 0.02 * (contradicts - contradiction_);
    if (kind_ != Kind::frame && kind_ != Kind::pixels) return;
    double& of_marker = contradiction_by_marker_[report.id];
    of_marker += 0.2 * (contradicts - of_marker);
    if (kind_ == Kind::frame && report.agrees && report.sigma[kElevation] > 0)
        elevations_.add(report.innovation[kElevation], report.sigma[kElevation], distance_m);
}

std::int64_t Input::samples() const noexcept {
    std::int64_t sum = 0;
    for (const std::int64_t n : counts()) sum += n;
    return sum;
}

Input::Counts Input::counts() const noexcept {
    Counts all;
    std::copy(verdicts_.begin(), verdicts_.end(), all.begin());
    std::copy(faults_.begin(), faults_.end(), all.begin() + kVerdicts);
    return all;
}

double Input::age_s(std::int64_t now) const noexcept {
    return seen_ ? std::fmax(0, seconds_from(last_received_, now)) : NAN;
}

const std::string& Input::review(std::int64_t now, bool needed,
                                 std::optional<std::int64_t> motion_now) {
    std::string found = find_problem(now, needed, motion_now);
    if (problem_.empty() && !found.empty()) trouble_ = found;
    problem_ = std::move(found);
    reviewed_ = counts();
    reviewed_repeated_ = clock_.repeated();
    reviewed_steps_ = clock_.steps();
    reviewed_lost_ = lost_;
    return problem_;
}

std::string Input::find_problem(std::int64_t now, bool needed,
                                std::optional<std::int64_t> motion_now) const {
    constexpr double patience_s = 0.6, intervals = 3.5;
    std::string rejected = rejections();
    if (needed && seen_ && age_s(now) > std::fmax(patience_s, intervals * interval_s_))
        return rejected.empty() ? words("silent for %.1f s", age_s(now)) : rejected;
    if (std::string clock = clock_problem(); !clock.empty()) return clock;
    if (!rejected.empty()) return rejected;
    if (std::string ahead = seen_ && motion_now ? ahead_of(*motion_now, now) : ""; !ahead.empty())
        return ahead;
    if (std::string rate = rate_problem(); !rate.empty()) return rate;
    if (std::string wrong = elevations_.problem(); !wrong.empty()) return wrong;
    return contradictions();
}

std::string Input::rate_problem() const {
    const auto lost = lost_ - reviewed_lost_;
    std::int64_t fresh = samples();
    for (const std::int64_t n : reviewed_) fresh -= n;
    if (lost > 2 && 10 * lost > fresh)
        return words("lost %lld messages, by gaps in seq", static_cast<long long>(lost));
    if (kind_ != Kind::reset && interval_s_ > 3 * usual_interval_s_)
        return words("slow: %.1f Hz, usually %.1f Hz", 1 / interval_s_, 1 / usual_interval_s_);
    return "";
}

std::string Input::contradictions() const {
    const std::string all =
        words("%.0f %% of the latest %s contradict the pose", 100 * contradiction_,
              kind_ == Kind::frame || kind_ == Kind::pixels ? "sightings" : "measurements");
    if (contradiction_ > 0.5) return all;
    for (const auto& [id, share] : contradiction_by_marker_)
        if (share > 0.7)
            return words(
                "the sightings of marker %d contradict the pose: is it where the map "
                "has it?",
                static_cast<int>(id));
    return contradiction_ > 0.08 ? all : "";
}

std::string Input::clock_problem() const {
    if (params_.time == TimePolicy::receive) return "";
    constexpr double us = 1e-6;
    if (const auto steps = clock_.steps() - reviewed_steps_; steps > 0)
        return words("its clock was set, by %.3f s", -static_cast<double>(clock_.jump_us()) * us);
    if (count(Verdict::clock) > reviewed_[static_cast<int>(Verdict::clock)])
        return words("stamps jump by %.3f s", -static_cast<double>(clock_.jump_us()) * us);
    if (clock_.still_us() > 500'000)
        return words("the stamp has stood still for %.1f s",
                     static_cast<double>(clock_.still_us()) * us);
    if (clock_.repeated() - reviewed_repeated_ >= 3) return "stamps repeat";
    constexpr double worst_ppm = 500;
    if (std::abs(clock_.skew_ppm()) > worst_ppm)
        return words("its clock runs %.0f ppm %s", std::abs(clock_.skew_ppm()),
                     clock_.skew_ppm() > 0 ? "slow" : "fast");
    return "";
}

/// Of samples that the motion's samples may never reach.
std::string Input::ahead_of(std::int64_t motion_now, std::int64_t now_received) const {
    constexpr double most_s = 0.5;  // no message arrives before its time
    const double ahead_s = seconds_from(motion_now, now(now_received));
    if (ahead_s <= most_s) return "";
    return words("its samples are dated %.1f s ahead of the motion's: are the clocks in step?",
                 ahead_s);
}

/// What most of the samples since the last review were rejected for, if most were.
std::string Input::rejections() const {
    const Counts now = counts();
    std::int64_t fresh = 0, rejected = 0, most = 0;
    int reason = 0;
    for (int i = 0; i < static_cast<int>(now.size()); ++i) {
        const auto at = static_cast<std::size_t>(i);
        const std::int64_t n = now[at] - reviewed_[at];
        fresh += n;
        if (i <= static_cast<int>(Verdict::fused) || n <= 0) continue;
        rejected += n;
        if (n > most) {
            most = n;
            reason = i;
        }
    }
    const bool jumped = now[static_cast<std::size_t>(Verdict::counter_reset)] >
                        reviewed_[static_cast<std::size_t>(Verdict::counter_reset)];
    if (rejected < 1 || (2 * rejected < fresh && !jumped)) return "";
    const char* word = reason < kVerdicts
                           ? pilotage::name(static_cast<Verdict>(reason))
                           : pilotage::name(static_cast<MessageFault>(reason - kVerdicts));
    return words("%lld of %lld rejected: %s", static_cast<long long>(rejected),
                 static_cast<long long>(std::max(fresh, rejected)), word);
}

input_status_t Input::status(std::int64_t now) const {
    input_status_t s;
    s.name = name_;
    s.channel = params_.channel;
    s.problem = problem_;
    s.rate_hz = interval_s_ >= 1e-6 ? 1 / interval_s_ : NAN;
    s.age_s = age_s(now);
    s.received = samples();
    s.fused = count(Verdict::fused);
    s.pending = count(Verdict::pending);
    s.lost = lost_;
    s.repeated = clock_.repeated();
    s.clock_offset_us = clock_.offset_us();
    s.clock_skew_ppm = clock_.skew_ppm();
    s.clock_steps = clock_.steps();
    s.noise_scale = 1;  // the engine knows more
    const auto add = [&](const char* reason, std::int64_t count) {
        if (count == 0) return;
        reason_count_t entry;
        entry.reason = reason;
        entry.count = count;
        s.rejected.push_back(entry);
    };
    for (int v = static_cast<int>(Verdict::fused) + 1; v < kVerdicts; ++v)
        add(pilotage::name(static_cast<Verdict>(v)), verdicts_[static_cast<std::size_t>(v)]);
    for (int f = 0; f < kMessageFaults; ++f)
        add(pilotage::name(static_cast<MessageFault>(f)), faults_[static_cast<std::size_t>(f)]);
    s.n_rejected = static_cast<std::int32_t>(s.rejected.size());
    return s;
}

}  // namespace pilotage
