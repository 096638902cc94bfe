#pragma once
/// \file
/// Configurations from a text.

#include <string>

#include "engine/config_file.hpp"
#include "support/files.hpp"

namespace pilotage::test {

[[nodiscard]] inline Config parsed(const std::string& yaml) {
    return parse_config(yaml, "robot.yaml", "");
}

/// What is wrong with a configuration; empty if nothing.
[[nodiscard]] inline std::string refusal(const std::string& yaml) {
    return complaint<ConfigError>([&] { (void)parsed(yaml); });
}

}  // namespace pilotage::test
