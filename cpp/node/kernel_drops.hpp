#pragma once
/// \file
/// Datagrams lost before LCM sees them: LCM counts none, the kernel does.

#include <cstdint>

namespace pilotage {

/// Datagrams that the kernel dropped on this process's UDP sockets so far; 0 where /proc does not
/// say.
[[nodiscard]] std::int64_t kernel_drops();

}  // namespace pilotage
