#pragma once
/// \file
/// From results to messages.

#include <string>
#include <vector>

#include "config.hpp"
#include "engine_output.hpp"
#include "pilotage/marker_report_t.hpp"
#include "pilotage/odometry_t.hpp"
#include "pilotage/pose_t.hpp"
#include "pilotage/status_t.hpp"
#include "pose_output.hpp"

namespace pilotage {

class Publisher {
   public:
    Publisher(const Config& config, EngineOutput& output);

    void pose(const Estimate& e, std::int32_t resets);
    void odometry(const Estimate& e, const Pose<double>& pose);
    void jump(const Jump& jump, std::int64_t utime, std::int32_t resets);
    void report(const SightingReport& report);
    /// \param status complete but for its seq
    void status(status_t& status);

   private:
    template <typename Message>
    void publish(const std::string& channel, const Message& message);

    OutputParams channels_;
    std::vector<std::string> sensor_names_;
    EngineOutput* output_;
    // Kept, so that their memory is.
    pose_t pose_;
    odometry_t odometry_;
    marker_report_t report_;
    std::vector<std::uint8_t> buffer_;
    std::int32_t poses_ = 0, odometries_ = 0, jumps_ = 0, reports_ = 0, statuses_ = 0;
};

}  // namespace pilotage
