#include "input.hpp"

#include <cmath>

namespace pilotage {

namespace {

/// Of any two times, also where their difference does not fit in 64 bits.
double seconds_from(std::int64_t from_us, std::int64_t to_us) noexcept {
    return (static_cast<double>(to_us) - static_cast<double>(from_us)) * 1e-6;
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

std::int64_t Input::date(std::int64_t utime, std::int64_t received) noexcept {
    // Stamps may be anything: those of no clock do not move the map, and sums wrap instead of
    // overflowing.
    constexpr std::int64_t limit = std::int64_t{1} << 61;
    const auto of_a_clock = [](std::int64_t t) { return -limit <= t && t <= limit; };
    std::int64_t time =
        of_a_clock(utime) && of_a_clock(received) ? clock_.map(utime, received) : utime;
    if (params_.time == TimePolicy::utime) time = utime;
    if (params_.time == TimePolicy::receive) time = received;
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(time) -
                                     static_cast<std::uint64_t>(latency_us_));
}

void Input::received(std::int64_t received, std::int32_t seq, std::size_t samples) noexcept {
    if (seen_) {
        // A sender that restarts counts from zero again, which is no loss.
        const std::int64_t gap = std::int64_t{seq} - last_seq_ - 1;
        if (gap > 0) lost_ += gap;
        constexpr double smoothing = 0.05;
        const double dt_s = seconds_from(last_received_, received);
        interval_s_ += (interval_s_ == 0 ? 1 : smoothing) * (dt_s - interval_s_);
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

std::int64_t Input::samples() const noexcept {
    std::int64_t sum = 0;
    for (const std::int64_t n : verdicts_) sum += n;
    for (const std::int64_t n : faults_) sum += n;
    return sum;
}

input_status_t Input::status(std::int64_t now) const {
    input_status_t s;
    s.name = name_;
    s.channel = params_.channel;
    s.rate_hz = interval_s_ >= 1e-6 ? 1 / interval_s_ : NAN;
    s.age_s = seen_ ? seconds_from(last_received_, now) : NAN;
    s.received = samples();
    s.fused = count(Verdict::fused);
    s.pending = count(Verdict::pending);
    s.lost = lost_;
    s.repeated = 0;
    s.clock_offset_us = clock_.offset_us();
    s.clock_skew_ppm = NAN;
    s.clock_steps = 0;
    s.noise_scale = 1;
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
