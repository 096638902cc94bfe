#pragma once
/// \file
/// What the engine has to say, in words for a person.

#include <cstdint>
#include <string>

#include "pilotage/localizer.hpp"

namespace pilotage {

[[nodiscard]] const char* name(Status status) noexcept;
[[nodiscard]] const char* name(MotionState state) noexcept;

/// Why a status is what it is, with the value and the limit that decided; empty where it is OK.
[[nodiscard]] std::string explain(const Assessment& assessment);

/// What wheels and gyro hold against each other; empty if nothing.
[[nodiscard]] std::string disagreement(const Estimate& e);

/// What a search did to the pose.
[[nodiscard]] std::string found_elsewhere(const Pose<double>& before, const Pose<double>& after);

[[nodiscard]] std::string wrong_type(const std::string& channel, const std::string& expected,
                                     const std::string& got, std::int64_t fingerprint);
[[nodiscard]] std::string unknown_sensor(const std::string& channel, const std::string& sensor);

}  // namespace pilotage
