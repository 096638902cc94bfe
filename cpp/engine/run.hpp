#pragma once
/// \file
/// A whole recording through an engine, with everything that came out.

#include <functional>
#include <string>
#include <vector>

#include "engine.hpp"
#include "recording.hpp"

namespace pilotage {

class Run final : private EngineOutput {
   public:
    /// \param keep_messages keep the published messages as well, as a recording
    explicit Run(Config config, bool keep_messages = false);

    /// Hears, now and then, which part of the input is done.
    using Progress = std::function<void(double)>;

    /// Feeds a recording to its end.
    void replay(const Recording& recording, const Progress& progress = {});
    /// Reads and feeds a log file without holding it in memory. \throws std::runtime_error
    void replay(const std::string& path, const Progress& progress = {});

    struct PoseRow {
        std::int64_t utime;
        double x, y, heading;
        double covariance[3][3];
        double v, omega;
        std::int8_t status;
        std::int32_t resets;
    };

    [[nodiscard]] static PoseRow row_of(const Estimate& e, std::int32_t resets) noexcept;

    [[nodiscard]] const std::vector<PoseRow>& poses() const noexcept { return poses_; }
    /// The newest report of each sighting, in the order in which they were first made.
    [[nodiscard]] std::vector<SightingReport> final_reports() const;
    [[nodiscard]] const std::vector<std::string>& notices() const noexcept { return notices_; }
    [[nodiscard]] const Recording& published() const noexcept { return published_; }
    [[nodiscard]] const Engine& engine() const noexcept { return engine_; }
    [[nodiscard]] std::int64_t messages() const noexcept { return messages_; }
    [[nodiscard]] const std::vector<std::string>& damage() const noexcept { return damage_; }

    /// Text tables. \throws std::runtime_error if the file cannot be written
    void write_poses_csv(const std::string& path) const;
    void write_poses_tum(const std::string& path) const;
    void write_reports_csv(const std::string& path) const;

   private:
    static constexpr int kProgressEvery = 1 << 16;  // messages

    void handle(const LogEvent& event);
    void restore(const LogEvent& event);
    void finish(const std::vector<std::string>& damage);
    void message(const std::string& channel, const std::uint8_t* data, std::size_t size) override;
    void pose(const Estimate& e, std::int32_t resets) override;
    void sighting(const SightingReport& report) override;
    void notice(const std::string& text) override;

    bool keep_messages_;
    std::vector<PoseRow> poses_;
    std::vector<SightingReport> reports_;
    std::vector<std::string> notices_, damage_;
    Recording published_;
    std::int64_t messages_ = 0, received_ = 0;
    Engine engine_;
};

}  // namespace pilotage
