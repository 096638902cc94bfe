#pragma once
/// \file
/// The node's command line.

#include <string>

namespace pilotage {

struct Options {
    std::string config;
    std::string lcm_url;     ///< empty: LCM's default
    std::string record;      ///< empty: no recording
    std::string checkpoint;  ///< empty: none is kept
};

/// Exit codes of the node.
enum ExitCode : int { kDone = 0, kFailed = 1, kBadConfiguration = 2 };

/// Reads the command line. Prints help or the version and exits with 0 where they are asked for;
/// exits with 2 where the words are off.
[[nodiscard]] Options parse_options(int argc, char** argv);

}  // namespace pilotage
