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

#include "checkpoint_file.hpp"
#include "config.hpp"
#include "engine_output.hpp"
#include "input.hpp"
#include "journal.hpp"
#include "pilotage/any_localizer.hpp"
#include "pose_output.hpp"
#include "publisher.hpp"

namespace pilotage {

/// Channels that belong to recordings, not to the robot.
inline constexpr const char* kTickChannel = "PILOTAGE_TICK";
inline constexpr const char* kSetupChannel = "PILOTAGE_SETUP";

class Engine final : private Listener {
   public:
    /// \param output outlives the engine
    Engine(Config config, EngineOutput& output);
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    /// Begins with the pose of a checkpoint, as a hypothesis. To be called before anything else.
    /// \throws std::runtime_error saying why the checkpoint cannot be used; nothing has changed
    /// then
    void restore(const Bytes& checkpoint);

    /// Takes a message. Anything may come: what cannot be used is counted.
    /// \param received time of arrival [us]
    void handle(std::string_view channel, std::int64_t received, const std::uint8_t* data,
                std::size_t size);

    /// Time passes [us, receive clock]. Publishes the status once a second, and poses where they
    /// have a rate of their own.
    /// \param drops datagrams that the kernel dropped so far
    void tick(std::int64_t now, std::int64_t drops);

    /// The input has ended: gives what still waits its verdict.
    void finish();

    /// Makes a checkpoint, unless the pose is none to begin with.
    void make_checkpoint();

    /// At the newest motion sample.
    [[nodiscard]] Estimate estimate() const;
    /// Predicted to a time of samples [us].
    [[nodiscard]] Estimate estimate(std::int64_t utime) const;
    /// As tick() wants to be called [us].
    [[nodiscard]] std::int64_t tick_period() const noexcept;
    [[nodiscard]] const Config& config() const noexcept { return config_; }
    [[nodiscard]] const std::vector<Input>& inputs() const noexcept { return inputs_; }
    /// The channels to subscribe to.
    [[nodiscard]] std::set<std::string> channels() const;
    /// What the localizer lacks before it can give a pose; empty when it has all.
    [[nodiscard]] std::string waiting_for() const;

   private:
    void on_verdict(const Sample& sample, Verdict before, Verdict now) override;
    void on_sighting(const SightingReport& report) override;

    [[nodiscard]] Input* input_for(std::string_view channel, const Decoded* named) noexcept;
    [[nodiscard]] bool acceptable(Input& input, const Codec* codec, bool whole,
                                  std::int64_t fingerprint, std::size_t size);
    [[nodiscard]] bool take(const Input& input, const Input::Date& date);
    void follow_clock(std::int64_t utime, std::int64_t received);
    [[nodiscard]] double distance_to(const Marker* marker) const noexcept;
    void publish_moved();
    void publish_due(std::int64_t end);
    void publish_status(std::int64_t drops);
    void review_inputs();
    [[nodiscard]] bool started() const;
    [[nodiscard]] bool needed(const Input& input) const noexcept;
    [[nodiscard]] std::string reason(const Assessment& assessment) const;
    void complain(const std::string& subject, const std::string& line);
    void tell(const std::string& subject, const std::string& line);

    Config config_;
    EngineOutput* output_;
    AnyLocalizer localizer_;
    PoseOutput pose_output_;
    Publisher publisher_;
    Journal journal_;
    std::vector<Input> inputs_;  // sensors first, by their number; then motion, gyro, reset
    std::size_t motion_, gyro_, reset_;
    Decoded decoded_;
    Pose<double> newest_pose_ = {0, 0, 0};

    // Receive clock [us].
    std::int64_t now_ = 0, moved_ = 0, since_ = 0, status_made_ = 0, checkpoint_made_ = 0;
    std::int64_t next_pose_ = 0;  // sample time
    bool clock_set_ = false;      // and no motion sample has come since
    Status status_ = Status::waiting;
    std::int32_t checkpoints_ = 0, reset_seq_ = -1;
    std::string reset_answer_;
    std::int32_t found_ = 0;      // times that a search found the robot elsewhere
    std::string motion_problem_;  // since the last status
};

}  // namespace pilotage
