#pragma once
/// \file
/// What a calibration tells of a camera, in OpenCV's terms. Pixel (0, 0) is the centre of the top
/// left one, u to the right, v down.

#include <array>

namespace pilotage {

struct Intrinsics {
    static constexpr int kMostCoefficients = 8;

    int width_px = 0, height_px = 0;                     ///< of the image that was calibrated
    double fx_px = 0, fy_px = 0;                         ///< focal lengths
    double cx_px = 0, cy_px = 0;                         ///< principal point
    std::array<double, kMostCoefficients> distortion{};  ///< k1 k2 p1 p2 k3 k4 k5 k6

    /// Whether there is a camera at all.
    [[nodiscard]] bool any() const noexcept { return fx_px > 0; }
};

}  // namespace pilotage
