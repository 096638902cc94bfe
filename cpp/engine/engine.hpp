#pragma once
/// \file
/// Bytes in, messages out: the one way from input to pose, live and in replay. Reads no clock, no
/// random number and no environment, and has no threads; time passes by ticks, which are an input
/// like any other.

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "config.hpp"
#include "input.hpp"
#include "pilotage/localizer.hpp"
#include "pilotage/marker_report_t.hpp"
#include "pilotage/pose_t.hpp"
#include "pilotage/status_t.hpp"

namespace pilotage {

/// Channels that belong to recordings, not to the robot.
inline constexpr const char* kTickChannel = "PILOTAGE_TICK";
inline constexpr const char* kSetupChannel = "PILOTAGE_SETUP";

/// Where the engine's results go; each call may be ignored.
class EngineOutput {
   public:
    /// A message to publish.
    virtual void message(const std::string& /*channel*/, const std::uint8_t* /*data*/,
                         std::size_t /*size*/) {}
    virtual void pose(const Estimate&) {}
    virtual void sighting(const SightingReport&) {}
    /// A line for a person: said once, not once a message.
    virtual void notice(const std::string&) {}

   protected:
    ~EngineOutput() = default;
};

class Engine final : private Listener {
   public:
    /// \param output outlives the engine
    Engine(Config config, EngineOutput& output);
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    /// Takes a message. Anything may come: what cannot be used is counted.
    /// \param received time of arrival [us]
    void handle(std::string_view channel, std::int64_t received, const std::uint8_t* data,
                std::size_t size);

    /// Time passes [us, receive clock]; publishes the status.
    /// \param drops datagrams that the kernel dropped so far
    void tick(std::int64_t now, std::int64_t drops);

    /// The input has ended: gives what still waits its verdict.
    void finish();

    [[nodiscard]] Estimate estimate() const;
    [[nodiscard]] const Config& config() const noexcept { return config_; }
    [[nodiscard]] const std::vector<Input>& inputs() const noexcept { return inputs_; }
    /// The channels to subscribe to.
    [[nodiscard]] std::set<std::string> channels() const;
    /// What the localizer lacks before it can give a pose; empty when it has all.
    [[nodiscard]] std::string waiting_for() const;

   private:
    void on_verdict(const Sample& sample, Verdict before, Verdict now) override;
    void on_sighting(const SightingReport& report) override;

    [[nodiscard]] Input* input_for(std::string_view channel, const Decoded* message) noexcept;
    void wrong_type(Input& input, std::int64_t fingerprint, const Codec* codec);
    void publish_pose();
    void notice_once(const std::string& what, const std::string& text);
    template <typename Message>
    void publish(const std::string& channel, const Message& message);

    Config config_;
    EngineOutput* output_;
    std::variant<Localizer<double, kPoseStates>, Localizer<double, kCalibratedStates>> localizer_;
    std::vector<Input> inputs_;  // sensors first, by their number; then motion, gyro, reset
    std::size_t motion_, gyro_, reset_;

    Decoded decoded_;
    pose_t pose_;
    marker_report_t report_;
    std::vector<std::uint8_t> buffer_;
    std::set<std::string> said_;
    std::int32_t poses_ = 0, reports_ = 0, statuses_ = 0;
    std::int64_t now_ = 0, since_ = 0;
    Status status_ = Status::waiting;
};

}  // namespace pilotage
