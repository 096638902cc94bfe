#pragma once
/// \file
/// Calibrations of cameras: files as OpenCV writes them, and camera_info files of ROS.

#include <string>
#include <vector>

#include "pilotage/sensing/intrinsics.hpp"

namespace pilotage {

/// Takes OpenCV's distortion coefficients: none, 4 (k1 k2 p1 p2), 5 (and k3) or 8 (and k4 k5 k6).
/// \throws ConfigError with `where` in front if that is no camera
[[nodiscard]] Intrinsics checked_intrinsics(Intrinsics intrinsics,
                                            const std::vector<double>& distortion,
                                            const std::string& where);

}  // namespace pilotage
