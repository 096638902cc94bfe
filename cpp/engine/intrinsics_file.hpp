#pragma once
/// \file
/// Calibrations of cameras: files as OpenCV writes them, and camera_info files of ROS.

#include <string>
#include <vector>

#include "pilotage/sensing/intrinsics.hpp"

namespace YAML {
class Node;
}

namespace pilotage {

/// Takes OpenCV's distortion coefficients: none, 4 (k1 k2 p1 p2), 5 (and k3) or 8 (and k4 k5 k6).
/// \throws ConfigError with `where` in front if that is no camera
[[nodiscard]] Intrinsics checked_intrinsics(Intrinsics intrinsics,
                                            const std::vector<double>& distortion,
                                            const std::string& where);

/// The text of a calibration file, as YAML: OpenCV's first line is none. \throws ConfigError
[[nodiscard]] std::string read_calibration(const std::string& path);

/// The keys that OpenCV's calibration and ROS's camera_info have in common: image_width,
/// image_height, camera_matrix, distortion_coefficients, and ROS's distortion_model; others are
/// passed over. \throws ConfigError
[[nodiscard]] Intrinsics parse_intrinsics(const YAML::Node& node, const std::string& where);

/// What parse_intrinsics reads.
[[nodiscard]] YAML::Node to_node(const Intrinsics& intrinsics);

}  // namespace pilotage
