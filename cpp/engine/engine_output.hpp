#pragma once
/// \file
/// Where the engine's results go.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "pilotage/localizer.hpp"

namespace pilotage {

/// Each call may be ignored.
class EngineOutput {
   public:
    /// A message to publish.
    virtual void message(const std::string& /*channel*/, const std::uint8_t* /*data*/,
                         std::size_t /*size*/) {}
    /// \param resets of the pose and its jumps, so far
    virtual void pose(const Estimate&, std::int32_t /*resets*/) {}
    virtual void sighting(const SightingReport&) {}
    /// A line for a person; there are few of them.
    virtual void notice(const std::string&) {}
    /// A checkpoint to keep, see Engine::restore.
    virtual void checkpoint(const std::vector<std::uint8_t>&) {}

   protected:
    ~EngineOutput() = default;
};

}  // namespace pilotage
