#pragma once
/// \file
/// Configurations of every kind, as a fuzzer's bytes ask for them.

#include "draws.hpp"
#include "engine/config.hpp"

namespace pilotage::test {

/// A configuration that the loader would accept.
[[nodiscard]] Config some_robot(Draws& draws);

}  // namespace pilotage::test
