#pragma once
/// \file
/// From a track to the status that is promised.

#include "pilotage/status.hpp"
#include "pilotage/track.hpp"

namespace pilotage {

/// \param silent_s since the last motion sample
template <typename Scalar, int N>
[[nodiscard]] Assessment assess(const Track<Scalar, N>& track, const Params& params,
                                double silent_s) noexcept;

}  // namespace pilotage
