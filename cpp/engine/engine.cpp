#include "engine.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#ifndef PILOTAGE_VERSION
#error "the build defines PILOTAGE_VERSION"
#endif

namespace pilotage {

namespace {

std::string hex(std::int64_t fingerprint) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(fingerprint));
    return text;
}

/// A name from outside as it may stand in a line for a person.
std::string printable(std::string name) {
    constexpr std::size_t enough = 60;
    if (name.size() > enough) name = name.substr(0, enough) + "...";
    for (char& c : name)
        if (c < ' ' || c > '~') c = '?';
    return name;
}

using AnyLocalizer =
    std::variant<Localizer<double, kPoseStates>, Localizer<double, kCalibratedStates>>;

AnyLocalizer make_localizer(const Config& config, Listener& listener) {
    if (config.params.calibrates())
        return AnyLocalizer(std::in_place_index<1>, config.params, config.map, listener);
    return AnyLocalizer(std::in_place_index<0>, config.params, config.map, listener);
}

}  // namespace

Engine::Engine(Config config, EngineOutput& output)
    : config_(std::move(config)), output_(&output), localizer_(make_localizer(config_, *this)) {
    for (std::size_t i = 0; i < config_.sensor_names.size(); ++i)
        inputs_.emplace_back(config_.sensor_names[i], config_.sensor_inputs[i], Kind::frame,
                             static_cast<int>(i));
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

void Engine::handle(std::string_view channel, std::int64_t received, const std::uint8_t* data,
                    std::size_t size) {
    now_ = std::max(now_, received);
    const std::int64_t fingerprint = fingerprint_of(data, size);
    const Codec* codec = find_codec(fingerprint);
    decoded_.samples.clear();
    const bool whole = codec != nullptr && codec->decode(data, size, decoded_);
    if (codec != nullptr && codec->kind == Kind::tick && channel == kTickChannel) {
        if (whole) tick(decoded_.utime, decoded_.drops);
        return;
    }
    Input* input = input_for(channel, whole && codec->kind == Kind::frame ? &decoded_ : nullptr);
    if (input == nullptr) return;
    if (codec == nullptr || codec->kind != input->kind())
        return wrong_type(*input, fingerprint, codec);
    if (!whole) {
        input->fault(MessageFault::malformed);
        notice_once("malformed " + input->channel(),
                    input->channel() + ": a broken " + codec->type + " of " + std::to_string(size) +
                        " bytes (this and later ones are counted in the status)");
        return;
    }
    if (input->kind() == Kind::frame && input->name() != decoded_.sensor) {
        input->fault(MessageFault::unknown_sensor);
        const std::string sensor = printable(decoded_.sensor);
        notice_once("sensor " + sensor,
                    input->channel() + ": a frame of sensor '" + sensor +
                        "', which the configuration does not name; add sensors." + sensor);
        return;
    }
    input->received(received, decoded_.seq, decoded_.samples.size());
    const std::int64_t time = input->date(decoded_.utime, received);
    bool moved = false;
    for (Sample& sample : decoded_.samples) {
        sample.utime = time;
        if (input->sensor() >= 0) sample.source = static_cast<std::uint8_t>(input->sensor());
        moved |= std::visit([&](auto& localizer) { return localizer.add(sample); }, localizer_);
    }
    if (moved) publish_pose();
}

/// The input of a channel; where several sensors share one, the one that the frame names, else the
/// first.
Input* Engine::input_for(std::string_view channel, const Decoded* frame) noexcept {
    Input* found = nullptr;
    for (Input& input : inputs_) {
        if (input.channel() != channel) continue;
        if (frame == nullptr || input.kind() != Kind::frame || input.name() == frame->sensor)
            return &input;
        if (found == nullptr) found = &input;
    }
    return found;
}

void Engine::wrong_type(Input& input, std::int64_t fingerprint, const Codec* codec) {
    input.fault(MessageFault::wrong_type);
    notice_once(
        "type " + input.channel(),
        input.channel() + ": expected " + expected_type(input.kind()) + ", got " +
            (codec != nullptr ? codec->type : "an unknown type") + " with fingerprint " +
            hex(fingerprint) +
            "; is this the right channel, and is the sender built with the same .lcm files?");
}

void Engine::on_verdict(const Sample& sample, Verdict before, Verdict now) {
    switch (sample.stream) {
        case Stream::sighting:
            return inputs_[sample.source].judged(before, now);
        case Stream::motion:
            return inputs_[motion_].judged(before, now);
        case Stream::gyro:
            return inputs_[gyro_].judged(before, now);
        case Stream::reset:
            return inputs_[reset_].judged(before, now);
    }
}

void Engine::on_sighting(const SightingReport& report) {
    output_->sighting(report);
    report_.utime = report.utime;
    report_.seq = reports_++;
    report_.revision = report.revision;
    report_.sensor = config_.sensor_names[report.sensor];
    report_.frame_seq = report.frame_seq;
    report_.index = report.index;
    report_.id = report.id;
    std::copy_n(report.innovation, 3, report_.innovation);
    std::copy_n(report.sigma, 3, report_.sigma);
    report_.nis = report.nis;
    report_.dof = report.dof;
    report_.weight = report.weight;
    report_.accepted = report.verdict == Verdict::fused;
    report_.reason = report_.accepted ? "" : name(report.verdict);
    report_.value = report.value;
    report_.limit = report.limit;
    report_.unit = unit(report.verdict);
    publish(config_.output.report, report_);
}

void Engine::publish_pose() {
    const Estimate e = estimate();
    output_->pose(e);
    pose_.utime = e.utime;
    pose_.seq = poses_++;
    pose_.x = e.pose[kX];
    pose_.y = e.pose[kY];
    pose_.heading = e.pose[kHeading];
    std::copy_n(e.covariance.data(), 9, pose_.covariance);
    pose_.v = e.v_m_s;
    pose_.omega = e.omega_rad_s;
    pose_.status = static_cast<std::int8_t>(e.status);
    pose_.resets = e.resets;
    publish(config_.output.pose, pose_);
}

void Engine::tick(std::int64_t now, std::int64_t drops) {
    now_ = std::max(now_, now);
    const Estimate e = estimate();
    if (e.status != status_ || statuses_ == 0) since_ = now_;
    status_ = e.status;
    status_t message;
    message.utime = now_;
    message.seq = statuses_++;
    message.state = static_cast<std::int8_t>(e.status);
    message.reason = waiting_for();
    message.since = since_;
    message.motion = "driving";
    message.resets = e.resets;
    message.reset_seq = -1;
    message.checkpoint_age_s = NAN;
    message.drops = drops;
    message.version = PILOTAGE_VERSION;
    message.n_inputs = static_cast<std::int32_t>(inputs_.size());
    for (const Input& input : inputs_) message.inputs.push_back(input.status(now_));
    publish(config_.output.status, message);
}

void Engine::finish() {
    std::visit([](auto& localizer) { localizer.finish(); }, localizer_);
}

Estimate Engine::estimate() const {
    return std::visit([](const auto& localizer) { return localizer.estimate(); }, localizer_);
}

std::set<std::string> Engine::channels() const {
    std::set<std::string> names;
    for (const Input& input : inputs_) names.insert(input.channel());
    return names;
}

std::string Engine::waiting_for() const {
    std::string missing;
    const auto want = [&](const std::string& what) {
        missing += (missing.empty() ? "" : ", ") + what;
    };
    const auto input_want = [&](const Input& input) {
        if (!input.seen())
            want(std::string(expected_type(input.kind())) + " on " + input.channel());
    };
    const bool has_pose =
        std::visit([](const auto& localizer) { return localizer.has_pose(); }, localizer_);
    if (!has_pose)
        want("a start pose (pose_reset_t on " + config_.reset.channel +
             ", or initial: in the configuration)");
    input_want(inputs_[motion_]);
    if (config_.params.motion.heading != HeadingSource::wheels) input_want(inputs_[gyro_]);
    for (std::size_t i = 0; i < config_.sensor_names.size(); ++i) input_want(inputs_[i]);
    return missing;
}

/// Says a line unless the same was said before; a peer that invents names does not fill the memory.
void Engine::notice_once(const std::string& what, const std::string& text) {
    constexpr std::size_t enough = 100;
    if (said_.size() < enough && said_.insert(what).second) output_->notice(text);
}

template <typename Message>
void Engine::publish(const std::string& channel, const Message& message) {
    encode(message, buffer_);
    output_->message(channel, buffer_.data(), buffer_.size());
}

}  // namespace pilotage
