#pragma once
/// \file
/// One input's time and health.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "codecs.hpp"
#include "config.hpp"
#include "elevation_watch.hpp"
#include "pilotage/input_status_t.hpp"
#include "pilotage/verdict.hpp"
#include "sender_clock.hpp"

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
    struct Date {
        std::int64_t utime;
        bool good;  ///< false where the stamp contradicts the sender's others
    };
    [[nodiscard]] Date date(std::int64_t utime, std::int32_t seq, std::int64_t received) noexcept;
    /// The moment that a message arriving now would speak of, had it travelled fast.
    [[nodiscard]] std::int64_t now(std::int64_t received) const noexcept;

    /// Takes note of a message that arrived whole, with `samples` in it.
    void received(std::int64_t received, std::int32_t seq, std::size_t samples) noexcept;
    void fault(MessageFault fault) noexcept;
    void judged(Verdict before, Verdict now) noexcept;
    /// \param distance_m to its marker, about
    void reported(const SightingReport& report, double distance_m) noexcept;

    [[nodiscard]] std::int64_t count(Verdict v) const noexcept {
        return verdicts_[static_cast<int>(v)];
    }
    [[nodiscard]] std::int64_t count(MessageFault f) const noexcept {
        return faults_[static_cast<int>(f)];
    }
    [[nodiscard]] std::int64_t samples() const noexcept;
    [[nodiscard]] bool seen() const noexcept { return seen_; }

    /// Whether the newest message showed that the sender's clock was set, and not before.
    [[nodiscard]] bool clock_was_set() const noexcept { return followed_; }
    /// What the last review found.
    [[nodiscard]] const std::string& problem() const noexcept { return problem_; }
    /// What the present trouble, or else the last, began with.
    [[nodiscard]] const std::string& trouble() const noexcept { return trouble_; }

    /// Looks back over the time since the last call, and says what was wrong with it; empty if all
    /// went well. \param needed its silence is a problem
    /// \param motion_now now() of the motion's input, to compare the clocks
    const std::string& review(std::int64_t now, bool needed,
                              std::optional<std::int64_t> motion_now = std::nullopt);
    [[nodiscard]] input_status_t status(std::int64_t now) const;

   private:
    using Counts = std::array<std::int64_t, kVerdicts + kMessageFaults>;

    [[nodiscard]] double age_s(std::int64_t now) const noexcept;
    [[nodiscard]] std::string find_problem(std::int64_t now, bool needed,
                                           std::optional<std::int64_t> motion_now) const;
    [[nodiscard]] std::string clock_problem() const;
    [[nodiscard]] std::string ahead_of(std::int64_t motion_now, std::int64_t now) const;
    [[nodiscard]] std::string rate_problem() const;
    [[nodiscard]] std::string rejections() const;
    [[nodiscard]] std::string contradictions() const;
    [[nodiscard]] Counts counts() const noexcept;

    std::string name_;
    InputParams params_;
    Kind kind_;
    int sensor_;
    std::int64_t latency_us_;
    SenderClock clock_;
    std::array<std::int64_t, kVerdicts> verdicts_{};
    std::array<std::int64_t, kMessageFaults> faults_{};
    std::int64_t lost_ = 0, last_received_ = 0;
    double interval_s_ = 0, usual_interval_s_ = 0;  // smoothed over seconds, over minutes
    // Share of the latest sightings that contradict the estimate: of all, and by marker.
    double contradiction_ = 0;
    std::map<std::int32_t, double> contradiction_by_marker_;
    ElevationWatch elevations_;
    std::int32_t last_seq_ = 0;
    bool seen_ = false, followed_ = false;

    // At the last review.
    Counts reviewed_{};
    std::int64_t reviewed_repeated_ = 0, reviewed_steps_ = 0, reviewed_lost_ = 0;
    std::string problem_, trouble_;
};

}  // namespace pilotage
