#pragma once
/// \file
/// One input's time and health.

#include <array>
#include <cstdint>
#include <string>

#include "clock_map.hpp"
#include "codecs.hpp"
#include "config.hpp"
#include "pilotage/input_status_t.hpp"
#include "pilotage/verdict.hpp"

namespace pilotage {

/// Why a message gave no sample at all.
enum class MessageFault : std::uint8_t { wrong_type, malformed, unknown_sensor };
inline constexpr int kMessageFaults = 3;
[[nodiscard]] const char* name(MessageFault fault) noexcept;

/// A channel with a kind of message, and for frames a sensor.
class Input {
   public:
    Input(std::string name, const InputParams& params, Kind kind, int sensor = -1);

    [[nodiscard]] const std::string& name() const noexcept { return name_; }
    [[nodiscard]] const std::string& channel() const noexcept { return params_.channel; }
    [[nodiscard]] Kind kind() const noexcept { return kind_; }
    [[nodiscard]] int sensor() const noexcept { return sensor_; }

    /// The moment a message speaks of, by the input's time policy and latency [us].
    [[nodiscard]] std::int64_t date(std::int64_t utime, std::int64_t received) noexcept;

    /// Takes note of a message that arrived whole, with `samples` in it.
    void received(std::int64_t received, std::int32_t seq, std::size_t samples) noexcept;
    void fault(MessageFault fault) noexcept;
    void judged(Verdict before, Verdict now) noexcept;

    [[nodiscard]] std::int64_t count(Verdict v) const noexcept {
        return verdicts_[static_cast<int>(v)];
    }
    [[nodiscard]] std::int64_t count(MessageFault f) const noexcept {
        return faults_[static_cast<int>(f)];
    }
    [[nodiscard]] std::int64_t samples() const noexcept;
    [[nodiscard]] bool seen() const noexcept { return seen_; }
    [[nodiscard]] input_status_t status(std::int64_t now) const;

   private:
    std::string name_;
    InputParams params_;
    Kind kind_;
    int sensor_;
    std::int64_t latency_us_;
    ClockMap clock_;
    std::array<std::int64_t, kVerdicts> verdicts_{};
    std::array<std::int64_t, kMessageFaults> faults_{};
    std::int64_t lost_ = 0, last_received_ = 0;
    double interval_s_ = 0;  // smoothed
    std::int32_t last_seq_ = 0;
    bool seen_ = false;
};

}  // namespace pilotage
