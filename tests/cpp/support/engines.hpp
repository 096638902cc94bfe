#pragma once
/// \file
/// An engine on a bench: everything that it publishes is decoded and checked as it comes out.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "engine/config_file.hpp"
#include "engine/engine.hpp"
#include "pilotage/pose_jump_t.hpp"
#include "support/matchers.hpp"
#include "support/messages.hpp"
#include "support/samples.hpp"

namespace pilotage::test {

/// Starts at the origin with heading by the wheels of 1 mm a tick; a camera and markers 1 and 2.
inline constexpr const char* kPlainRobot = R"(
motion: {heading: wheels}
initial: {x_m: 0, y_m: 0, heading_rad: 0}
sensors: {camera: {}}
map:
- {id: 1, x: 6, y: 2, z: 0.4}
- {id: 2, x: 4, y: -4}
)";
inline const MarkerMap kPlainMap({{1, 6, 2, 0.4, 0}, {2, 4, -4, 0, 0}});

/// The same robot with a gyro, among the markers of kAroundOrigin.
inline constexpr const char* kGyroRobot = R"(
motion: {heading: gyro}
initial: {x_m: 0, y_m: 0, heading_rad: 0}
sensors: {camera: {}}
map:
- {id: 1, x: 6, y: 2, z: 0.4}
- {id: 2, x: -3, y: 5, z: 0.3}
- {id: 3, x: 4, y: -4, z: 0.2}
)";

class Bench final : private EngineOutput {
   public:
    std::vector<pose_t> poses;
    std::vector<odometry_t> odometry;
    std::vector<pose_jump_t> jumps;
    std::vector<Bytes> checkpoints;
    std::vector<marker_report_t> reports;
    std::vector<status_t> statuses;
    std::vector<std::string> notices;

    /// \param more YAML lines after those of the plain robot
    explicit Bench(const std::string& more = "", const std::string& robot = kPlainRobot);

    template <typename Message>
    void send(const std::string& channel, const Message& message) {
        send_bytes(channel, bytes_of(message), message.utime);
    }
    template <typename Message>
    void send(const std::string& channel, const Message& message, std::int64_t received) {
        send_bytes(channel, bytes_of(message), received);
    }
    void send_bytes(const std::string& channel, const Bytes& bytes, std::int64_t received = 0);

    /// Sends samples as messages that arrive at their own time, with a tick of the clock each
    /// second; frames are the camera's.
    void run(const std::vector<Sample>& samples);
    /// Only the clock goes on: ticks until then.
    void wait(std::int64_t until);

    Engine& engine() { return engine_; }
    /// The status at a time. \return the input of a channel (the first, where several share it)
    input_status_t input(const std::string& channel, std::int64_t now = 0);

   private:
    void message(const std::string& channel, const std::uint8_t* data, std::size_t size) override;
    void notice(const std::string& text) override { notices.push_back(text); }
    void checkpoint(const Bytes& bytes) override { checkpoints.push_back(bytes); }

    std::int64_t next_tick_ = 0;
    Engine engine_;
};

/// How often an input says that it rejected for this reason.
[[nodiscard]] std::int64_t count_of(const input_status_t& input, const std::string& reason);

}  // namespace pilotage::test
