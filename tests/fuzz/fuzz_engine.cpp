// Whatever robots send, in whatever order and however configured: nothing crashes, what is
// published is sound, poses do not go back in time, and every sample is counted.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <set>
#include <string>

#include "engine/engine.hpp"
#include "peer.hpp"
#include "progress.hpp"
#include "robots.hpp"
#include "support/soundness.hpp"

namespace pilotage::test {
namespace {

[[noreturn]] void fail(const std::string& what) {
    std::fprintf(stderr, "%s\n", what.c_str());
    std::abort();
}

/// An engine that is watched from outside.
class Witness final : private EngineOutput {
   public:
    explicit Witness(const Config& config)
        : engine_(config, *this), channels_(engine_.channels()) {}

    void take(const Action& action) {
        const std::int64_t before = received(), samples = samples_in(action);
        went_back_ = jumped_ = false;
        if (action.kind == Action::Kind::tick) engine_.tick(action.received, action.drops);
        if (action.kind == Action::Kind::message) {
            // From memory of just this size, so that a sanitizer sees a byte read too many.
            const auto exact = std::make_unique<std::uint8_t[]>(action.bytes.size());
            std::copy(action.bytes.begin(), action.bytes.end(), exact.get());
            engine_.handle(action.channel, action.received, exact.get(), action.bytes.size());
        }
        if (received() != before + samples)
            fail("a message on " + action.channel + " is miscounted");
        if (went_back_ && !jumped_) fail("a pose goes back in time, and no pose_jump_t says so");
    }

    /// What was kept on the way has to be good for a start.
    void finish() {
        engine_.finish();
        engine_.tick(0, 0);
        for (const Input& input : engine_.inputs())
            if (input.count(Verdict::pending) != 0) fail(input.name() + ": left without a verdict");
    }

   private:
    void message(const std::string& channel, const std::uint8_t* data, std::size_t size) override {
        const OutputParams& out = engine_.config().output;
        if (channel == out.pose) {
            const auto pose = sound<pose_t>(channel, data, size);
            went_back_ = went_back_ || pose.utime < newest_;
            newest_ = pose.utime;
        } else if (channel == out.jump) {
            sound<pose_jump_t>(channel, data, size);
            jumped_ = true;
        } else if (channel == out.report) {
            sound<marker_report_t>(channel, data, size);
        } else if (channel == out.status) {
            sound<status_t>(channel, data, size);
        } else if (channel == out.odometry) {
            sound<odometry_t>(channel, data, size);
        } else {
            fail("a message on " + channel);
        }
    }

    void checkpoint(const std::vector<std::uint8_t>& bytes) override { checkpoint_ = bytes; }

    template <typename Message>
    static Message sound(const std::string& channel, const std::uint8_t* data, std::size_t size) {
        Message message;
        if (message.decode(data, 0, static_cast<int>(size)) != static_cast<int>(size))
            fail(channel + ": cannot be decoded");
        if (const std::string flaw = flaw_in(message); !flaw.empty()) fail(channel + ": " + flaw);
        return message;
    }

    [[nodiscard]] std::int64_t received() const {
        std::int64_t sum = 0;
        for (const Input& input : engine_.inputs()) sum += input.samples();
        return sum;
    }

    /// By how much the inputs' counts have to go up: a bad message counts as one sample.
    [[nodiscard]] std::int64_t samples_in(const Action& action) const {
        if (action.kind != Action::Kind::message || channels_.count(action.channel) == 0) return 0;
        const Codec* codec = find_codec(fingerprint_of(action.bytes.data(), action.bytes.size()));
        Decoded decoded;
        if (codec == nullptr || !codec->decode(action.bytes.data(), action.bytes.size(), decoded))
            return 1;
        for (const Input& input : engine_.inputs())
            if (input.channel() == action.channel && input.kind() == codec->kind &&
                (!names_sensor(codec->kind) || input.name() == decoded.sensor))
                return static_cast<std::int64_t>(decoded.samples.size());
        return 1;
    }

    Engine engine_;
    std::set<std::string> channels_;
    std::int64_t newest_ = std::numeric_limits<std::int64_t>::min();
    bool went_back_ = false, jumped_ = false;  // in this step
    std::vector<std::uint8_t> checkpoint_;
};

}  // namespace
}  // namespace pilotage::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace pilotage::test;
    static Progress messages("messages");
    Draws draws(data, size);
    Witness witness(some_robot(draws));
    Peer peer(draws);
    while (!draws.empty()) {
        const Action& action = peer.next();
        if (action.kind == Action::Kind::nothing) continue;
        witness.take(action);
        messages.add();
    }
    witness.finish();
    return 0;
}
