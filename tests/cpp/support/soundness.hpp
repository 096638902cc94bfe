#pragma once
/// \file
/// What holds for every message that an engine publishes, whatever it was fed.

#include <string>

#include "pilotage/marker_report_t.hpp"
#include "pilotage/odometry_t.hpp"
#include "pilotage/pose_jump_t.hpp"
#include "pilotage/pose_t.hpp"
#include "pilotage/status_t.hpp"

namespace pilotage::test {

/// What is wrong with a published message; empty if it is sound.
[[nodiscard]] std::string flaw_in(const pose_t& pose);
[[nodiscard]] std::string flaw_in(const marker_report_t& report);
[[nodiscard]] std::string flaw_in(const status_t& status);
[[nodiscard]] std::string flaw_in(const odometry_t& odometry);
[[nodiscard]] std::string flaw_in(const pose_jump_t& jump);

}  // namespace pilotage::test
