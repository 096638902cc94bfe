#include "node.hpp"

#include <lcm/lcm.h>
#include <sys/time.h>

#include <cctype>
#include <cstdio>
#include <stdexcept>

#include "engine/config_file.hpp"
#include "kernel_drops.hpp"
#include "pilotage/setup_t.hpp"
#include "pilotage/tick_t.hpp"

namespace pilotage {

namespace {

constexpr std::int64_t kSecond = 1'000'000;

/// The clock that LCM stamps arrivals with.
std::int64_t wall_clock() {
    timeval now{};
    gettimeofday(&now, nullptr);
    return now.tv_sec * kSecond + now.tv_usec;
}

void say(const std::string& text) {
    std::fprintf(stderr, "pilotage-node: %s\n", text.c_str());
}

/// LCM subscribes by regular expression, we by name.
std::string literally(const std::string& channel) {
    std::string pattern;
    for (const char c : channel) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_') pattern += '\\';
        pattern += c;
    }
    return pattern;
}

}  // namespace

Node::Node(const Config& config, lcm_t* lcm, const Options& options)
    : lcm_(lcm), engine_(config, *this) {
    Bytes checkpoint;
    if (!options.checkpoint.empty()) checkpoint = restore(options.checkpoint);
    if (!options.record.empty()) begin_recording(options.record, checkpoint);
    for (const std::string& channel : engine_.channels()) {
        lcm_subscription_t* subscription =
            lcm_subscribe(lcm_, literally(channel).c_str(), &Node::received, this);
        if (subscription == nullptr) throw std::runtime_error("LCM cannot subscribe to " + channel);
        // LCM's queue of 30 drops the newest messages in silence; ours has no end.
        lcm_subscription_set_queue_capacity(subscription, 0);
    }
}

/// \return what the engine began with, for the recording
Bytes Node::restore(const std::string& path) {
    checkpoints_ = std::make_unique<FileKeeper>(
        path, [](const std::string& error) { say(error + "; the checkpoint is not kept"); });
    try {
        Bytes bytes = read_bytes(path);
        if (bytes.empty()) return {};
        engine_.restore(bytes);
        say("begins with the pose of " + path + "; sightings are to confirm it");
        return bytes;
    } catch (const std::exception& error) {
        say("begins without a checkpoint, since " + path + " " + error.what());
        return {};
    }
}

void Node::begin_recording(const std::string& path, const Bytes& checkpoint) {
    log_ = std::make_unique<LogWriter>(path);
    setup_t setup{};
    setup.utime = wall_clock();
    setup.version = PILOTAGE_VERSION;
    setup.config = to_yaml(engine_.config());
    setup.map = to_yaml(engine_.config().map);
    setup.n_checkpoint = static_cast<std::int32_t>(checkpoint.size());
    setup.checkpoint.assign(checkpoint.begin(), checkpoint.end());
    record(setup.utime, kSetupChannel, setup);
}

bool Node::run(const volatile std::sig_atomic_t& stop) {
    std::int64_t next_tick = wall_clock();
    while (!stop) {
        const std::int64_t now = wall_clock();
        if (now >= next_tick || next_tick - now > kSecond) {  // the second: the clock was set back
            tick(now);
            next_tick = now + engine_.tick_period();
        }
        const auto wait_ms = static_cast<int>((next_tick - now) / 1000 + 1);
        if (lcm_handle_timeout(lcm_, wait_ms) < 0 && !stop) return false;
    }
    return true;
}

void Node::received(const lcm_recv_buf_t* buffer, const char* channel, void* self) {
    Node& node = *static_cast<Node*>(self);
    const auto* data = static_cast<const std::uint8_t*>(buffer->data);
    node.received_ = buffer->recv_utime;
    // The input goes into the log before what it gives rise to, which is published before it is
    // logged.
    node.record(node.received_, channel, data, buffer->data_size);
    node.engine_.handle(channel, node.received_, data, buffer->data_size);
}

void Node::tick(std::int64_t now) {
    received_ = now;
    tick_t tick{};
    tick.utime = now;
    tick.seq = ticks_++;
    tick.drops = kernel_drops();
    record(now, kTickChannel, tick);
    engine_.tick(now, tick.drops);
    to_log([](LogWriter& log) { log.flush(); });
    say_what_is_missing();
}

void Node::say_what_is_missing() {
    const std::string missing = engine_.waiting_for();
    if (missing == missing_) return;
    notice(missing.empty() ? "all inputs are there" : "waiting for " + missing);
    missing_ = missing;
}

void Node::message(const std::string& channel, const std::uint8_t* data, std::size_t size) {
    lcm_publish(lcm_, channel.c_str(), data, static_cast<unsigned>(size));
    record(received_, channel, data, size);
}

void Node::notice(const std::string& text) {
    say(text);
}

void Node::checkpoint(const Bytes& bytes) {
    if (checkpoints_) checkpoints_->put(bytes);
}

void Node::record(std::int64_t received, std::string_view channel, const std::uint8_t* data,
                  std::size_t size) {
    to_log([&](LogWriter& log) { log.write({received, channel, data, size}); });
}

/// Does something with the recording, if there is one; where that fails, localizing goes on without
/// it.
template <typename Action>
void Node::to_log(const Action& action) {
    if (!log_) return;
    try {
        action(*log_);
    } catch (const std::exception& error) {
        log_.reset();
        notice(std::string(error.what()) + "; the recording ends here");
    }
}

template <typename Message>
void Node::record(std::int64_t received, std::string_view channel, const Message& message) {
    std::vector<std::uint8_t> bytes;
    encode(message, bytes);
    record(received, channel, bytes.data(), bytes.size());
}

}  // namespace pilotage
