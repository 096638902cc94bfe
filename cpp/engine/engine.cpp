#include "engine.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "config_file.hpp"
#include "explain.hpp"
#include "words.hpp"

#ifndef PILOTAGE_VERSION
#error "the build defines PILOTAGE_VERSION"
#endif

namespace pilotage {

namespace {

constexpr std::int64_t kSecond = 1'000'000;
constexpr std::int64_t kEver = std::numeric_limits<std::int64_t>::max();

[[noreturn]] void fail(const char* what) {
    throw std::runtime_error(what);
}

Kind kind_of(Measures measures) noexcept {
    constexpr Kind kinds[] = {Kind::frame, Kind::fix, Kind::walls, Kind::pixels};
    return kinds[static_cast<int>(measures)];
}

/// The receive clock as far as sums and differences of its times fit in 64 bits: what reads a
/// damaged log may say anything.
std::int64_t within_time(std::int64_t received) noexcept {
    constexpr std::int64_t limit = std::int64_t{1} << 60;
    return std::clamp(received, -limit, limit);
}

}  // namespace

Engine::Engine(Config config, EngineOutput& output)
    : config_(std::move(config)),
      output_(&output),
      localizer_(make_localizer(config_.params, config_.map, config_.walls, *this)),
      pose_output_(config_.params.motion.slip_angle_rad, config_.output.jump_m,
                   config_.output.jump_rad),
      publisher_(config_, output) {
    for (std::size_t i = 0; i < config_.sensor_names.size(); ++i)
        inputs_.emplace_back(config_.sensor_names[i], config_.sensor_inputs[i],
                             kind_of(config_.params.sensors[i].measures), static_cast<int>(i));
    motion_ = inputs_.size();
    if (config_.params.motion.source == MotionSource::encoders)
        inputs_.emplace_back("encoders", config_.encoders, Kind::encoders);
    else
        inputs_.emplace_back("velocity", config_.velocity, Kind::velocity);
    gyro_ = inputs_.size();
    inputs_.emplace_back("gyro", config_.gyro, Kind::gyro);
    reset_ = inputs_.size();
    inputs_.emplace_back("pose_reset", config_.reset, Kind::reset);
}

void Engine::restore(const Bytes& checkpoint) {
    const checkpoint_t message = unpack(checkpoint);
    if (message.map_hash != hash_of(to_yaml(config_.map))) fail("belongs to another map");
    Checkpoint from = checkpoint_of(message);
    if (message.config_hash != hash_of(to_yaml(config_)))
        from.states = 0;  // its calibration may mean something else
    if (!std::visit([&](auto& localizer) { return localizer.restore(from); }, localizer_))
        fail("holds no pose");
}

void Engine::handle(std::string_view channel, std::int64_t received, const std::uint8_t* data,
                    std::size_t size) {
    received = within_time(received);
    now_ = received;
    const std::int64_t fingerprint = fingerprint_of(data, size);
    const Codec* codec = find_codec(fingerprint);
    decoded_.samples.clear();
    const bool whole = codec != nullptr && codec->decode(data, size, decoded_);
    if (codec != nullptr && codec->kind == Kind::tick && channel == kTickChannel) {
        if (whole) tick(decoded_.utime, decoded_.drops);
        return;
    }
    Input* input = input_for(channel, whole && names_sensor(codec->kind) ? &decoded_ : nullptr);
    if (input == nullptr || !acceptable(*input, codec, whole, fingerprint, size)) return;
    input->received(received, decoded_.seq, decoded_.samples.size());
    const Input::Date date = input->date(decoded_.utime, decoded_.seq, received);
    if (input->kind() == Kind::reset) {
        reset_seq_ = decoded_.seq;
        reset_answer_ = name(Verdict::pending);
    }
    if (input == &inputs_[motion_] && date.good) {
        follow_clock(date.utime, received);
        publish_due(date.utime);
    }
    if (take(*input, date) && started()) publish_moved();
    publish_due(kEver);
}

/// Whether the message is one that the input is for. If not, it is counted and named.
bool Engine::acceptable(Input& input, const Codec* codec, bool whole, std::int64_t fingerprint,
                        std::size_t size) {
    const std::string& channel = input.channel();
    if (codec == nullptr || codec->kind != input.kind()) {
        input.fault(MessageFault::wrong_type);
        complain("type on " + channel,
                 wrong_type(channel, expected_types(input.kind()),
                            codec != nullptr ? codec->type : "an unknown type", fingerprint));
        return false;
    }
    if (!whole) {
        input.fault(MessageFault::malformed);
        complain("form on " + channel,
                 channel + ": a broken " + codec->type + " of " + std::to_string(size) + " bytes");
        return false;
    }
    if (names_sensor(input.kind()) && input.name() != decoded_.sensor) {
        input.fault(MessageFault::unknown_sensor);
        complain("sensor on " + channel, unknown_sensor(channel, decoded_.sensor));
        return false;
    }
    return true;
}

/// Gives the samples of the message to the localizer, unless their stamp or the configuration
/// speaks against them. \return whether the newest motion sample is a newer one than before
bool Engine::take(const Input& input, const Input::Date& date) {
    for (Sample& sample : decoded_.samples) {
        sample.utime = date.utime;
        if (input.sensor() >= 0) sample.source = static_cast<std::uint8_t>(input.sensor());
    }
    Verdict verdict = Verdict::pending;
    if (!date.good) verdict = Verdict::clock;
    if (input.kind() == Kind::reset &&
        (config_.reset_policy == ResetPolicy::never ||
         (config_.reset_policy == ResetPolicy::not_ok && status_ == Status::ok)))
        verdict = Verdict::not_allowed;
    const auto& samples = decoded_.samples;
    return std::visit(
        [&](auto& localizer) {
            if (verdict == Verdict::pending) return localizer.add(samples.data(), samples.size());
            for (const Sample& sample : samples) localizer.refuse(sample, verdict);
            return false;
        },
        localizer_);
}

/// Where the clock that dates motion was set, time goes on from there.
void Engine::follow_clock(std::int64_t utime, std::int64_t received) {
    constexpr std::int64_t slack = kSecond / 4;
    const std::int64_t passed = received - moved_;
    moved_ = received;
    if (!inputs_[motion_].clock_was_set() || std::abs(utime - passed - estimate().utime) <= slack)
        return;
    std::visit([&](auto& localizer) { localizer.set_time(utime - passed); }, localizer_);
    clock_set_ = true;
}

/// The input of a channel; where several sensors share one, the one that the message names, else
/// the first.
Input* Engine::input_for(std::string_view channel, const Decoded* named) noexcept {
    Input* found = nullptr;
    for (Input& input : inputs_) {
        if (input.channel() != channel) continue;
        if (named == nullptr || !names_sensor(input.kind()) || input.name() == named->sensor)
            return &input;
        if (found == nullptr) found = &input;
    }
    return found;
}

void Engine::on_verdict(const Sample& sample, Verdict before, Verdict now) {
    switch (sample.stream) {
        case Stream::sighting:
        case Stream::fix:
        case Stream::beam:
            return inputs_[sample.source].judged(before, now);
        case Stream::motion:
            return inputs_[motion_].judged(before, now);
        case Stream::gyro:
            return inputs_[gyro_].judged(before, now);
        case Stream::reset:
            if (sample.seq == reset_seq_)
                reset_answer_ = now == Verdict::fused ? "accepted" : name(now);
            return inputs_[reset_].judged(before, now);
    }
}

void Engine::on_sighting(const SightingReport& report) {
    if (report.revision == 0)
        inputs_[report.sensor].reported(report, distance_to(config_.map.find(report.id)));
    publisher_.report(report);
}

/// Over ground, from the newest pose that was published; NaN of no marker.
double Engine::distance_to(const Marker* marker) const noexcept {
    if (marker == nullptr) return NAN;
    return std::hypot(marker->x_m - newest_pose_[kX], marker->y_m - newest_pose_[kY]);
}

/// The newest motion sample is a newer one than before.
void Engine::publish_moved() {
    const Estimate e = estimate();
    newest_pose_ = e.pose;
    const std::optional<Jump> jump = pose_output_.follow(e);
    if (e.disagreement_rad != 0) motion_problem_ = disagreement(e);
    if (jump && e.found != found_)
        tell("found", motion_problem_ = found_elsewhere(jump->before, jump->after));
    found_ = e.found;
    if (config_.output.rate_hz == 0) publisher_.pose(e, pose_output_.resets());
    publisher_.odometry(e, pose_output_.odometry());
    if (jump) publisher_.jump(*jump, e.utime, pose_output_.resets());
    if (clock_set_) next_pose_ = 0;  // now that the jump is announced, stamps may go back
    clock_set_ = false;
}

/// Poses at a rate of their own, as far as time has passed, of moments before `end`.
void Engine::publish_due(std::int64_t end) {
    if (config_.output.rate_hz == 0 || !started() || clock_set_) return;
    const auto period = static_cast<std::int64_t>(kSecond / config_.output.rate_hz);
    // By then the pose has been LOST for long; and our own clock may have been set.
    const double longest_s = 2 * config_.params.status.lost_after_s;
    const std::int64_t now =
        std::min(inputs_[motion_].now(now_),
                 estimate().utime + static_cast<std::int64_t>(longest_s * kSecond));
    if (next_pose_ == 0 || now - next_pose_ > kSecond + period) next_pose_ = now;
    for (; next_pose_ <= now && next_pose_ < end; next_pose_ += period)
        publisher_.pose(estimate(next_pose_), pose_output_.resets());
}

void Engine::tick(std::int64_t now, std::int64_t drops) {
    now = within_time(now);
    now_ = now;
    publish_due(kEver);
    if (tick_period() == kSecond || std::abs(now - status_made_) >= kSecond - tick_period() / 2) {
        status_made_ = now;
        review_inputs();
        publish_status(drops);
    }
    const auto interval = static_cast<std::int64_t>(config_.checkpoint_interval_s * kSecond);
    if (std::abs(now - checkpoint_made_) >= interval) make_checkpoint();
    journal_.flush(now_, [&](const std::string& line) { output_->notice(line); });
}

std::int64_t Engine::tick_period() const noexcept {
    constexpr double shortest_s = 0.001;
    double period_s = std::min(1.0, config_.checkpoint_interval_s);
    if (config_.output.rate_hz > 0) period_s = std::min(period_s, 1 / config_.output.rate_hz);
    return std::llround(std::max(period_s, shortest_s) * kSecond);
}

void Engine::review_inputs() {
    const Input& motion = inputs_[motion_];
    const auto motion_now =
        motion.seen() ? std::optional<std::int64_t>(motion.now(now_)) : std::nullopt;
    for (Input& input : inputs_) {
        const bool was_well = input.problem().empty();
        const std::string& now = input.review(now_, needed(input), motion_now);
        if (was_well == now.empty()) continue;
        const std::string what = now.empty() ? "well again; it was: " + input.trouble() : now;
        tell(input.name(), input.name() + " (" + input.channel() + "): " + what);
    }
}

void Engine::publish_status(std::int64_t drops) {
    const Estimate e = estimate(inputs_[motion_].now(now_));
    const Status state = e.status;
    status_t message;
    message.reason = reason(e);
    if (since_ == 0) since_ = now_;
    if (state != status_) {
        since_ = now_;
        tell("state", std::string("state ") + name(state) +
                          (message.reason.empty() ? "" : ": " + message.reason));
    }
    status_ = state;
    message.utime = now_;
    message.state = static_cast<std::int8_t>(state);
    message.since = since_;
    message.motion = name(e.motion);
    message.resets = pose_output_.resets();
    message.reset_seq = reset_seq_;
    message.reset_answer = reset_answer_;
    message.checkpoint_age_s =
        checkpoints_ > 0 ? static_cast<double>(now_ - checkpoint_made_) * 1e-6 : NAN;
    message.drops = drops;
    message.version = PILOTAGE_VERSION;
    message.n_inputs = static_cast<std::int32_t>(inputs_.size());
    for (const Input& input : inputs_) message.inputs.push_back(input.status(now_));
    const NoiseScale noise = std::visit([](const auto& l) { return l.noise(); }, localizer_);
    for (std::size_t i = 0; i < config_.sensor_names.size(); ++i)
        message.inputs[i].noise_scale = noise.sensor(static_cast<int>(i));
    message.inputs[motion_].noise_scale = noise.motion();
    publisher_.status(message);
    motion_problem_.clear();
}

void Engine::make_checkpoint() {
    const Status status = estimate().status;
    if (status != Status::ok && status != Status::dead_reckoning) return;
    checkpoint_t message;
    fill(message, std::visit([](const auto& l) { return l.checkpoint(); }, localizer_));
    message.seq = checkpoints_++;
    message.made = checkpoint_made_ = now_;
    message.version = PILOTAGE_VERSION;
    message.config_hash = hash_of(to_yaml(config_));
    message.map_hash = hash_of(to_yaml(config_.map));
    output_->checkpoint(pack(message));
}

void Engine::finish() {
    std::visit([](auto& localizer) { localizer.finish(); }, localizer_);
}

Estimate Engine::estimate() const {
    return std::visit([](const auto& localizer) { return localizer.estimate(); }, localizer_);
}

Estimate Engine::estimate(std::int64_t utime) const {
    return std::visit([&](const auto& localizer) { return localizer.estimate(utime); }, localizer_);
}

bool Engine::started() const {
    return std::visit([](const auto& localizer) { return localizer.started(); }, localizer_);
}

std::set<std::string> Engine::channels() const {
    std::set<std::string> names;
    for (const Input& input : inputs_) names.insert(input.channel());
    return names;
}

/// Whether the estimate suffers when this input is silent.
bool Engine::needed(const Input& input) const noexcept {
    if (&input == &inputs_[gyro_]) return config_.params.motion.heading != HeadingSource::wheels;
    return &input != &inputs_[reset_];
}

std::string Engine::waiting_for() const {
    std::string missing;
    const auto want = [&](const std::string& what) {
        missing += (missing.empty() ? "" : ", ") + what;
    };
    const bool has_pose =
        std::visit([](const auto& localizer) { return localizer.has_pose(); }, localizer_);
    if (!has_pose)
        want("markers enough to find the pose (or pose_reset_t on " + config_.reset.channel +
             ", or initial: in the configuration)");
    const auto input_want = [&](const Input& input) {
        if (needed(input) && !input.seen())
            want(expected_types(input.kind()) + " on " + input.channel());
    };
    input_want(inputs_[motion_]);
    input_want(inputs_[gyro_]);
    for (std::size_t i = 0; i < config_.sensor_names.size(); ++i) input_want(inputs_[i]);
    return missing;
}

/// Why the state is not OK, or what is still missing.
std::string Engine::reason(const Assessment& assessment) const {
    std::string text = explain(assessment);
    const auto add = [&](const std::string& more) {
        if (!more.empty()) text += (text.empty() ? "" : "; ") + more;
    };
    if (const std::string missing = waiting_for(); !missing.empty()) add("waiting for " + missing);
    add(motion_problem_);
    for (const Input& input : inputs_)
        if (!input.problem().empty()) add(input.name() + ": " + input.problem());
    return text;
}

/// Of a bad message: there may be many like it.
void Engine::complain(const std::string& subject, const std::string& line) {
    journal_.note(subject, line, 1, now_, [&](const std::string& said) { output_->notice(said); });
}

/// Of a change: one may follow upon another.
void Engine::tell(const std::string& subject, const std::string& line) {
    journal_.note(subject, line, 6, now_, [&](const std::string& said) { output_->notice(said); });
}

}  // namespace pilotage
