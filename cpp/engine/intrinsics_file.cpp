#include "intrinsics_file.hpp"

#include <algorithm>
#include <cmath>

#include "config.hpp"
#include "words.hpp"

namespace pilotage {

Intrinsics checked_intrinsics(Intrinsics intrinsics, const std::vector<double>& distortion,
                              const std::string& where) {
    const auto fail = [&](const std::string& what) { throw ConfigError(where + ": " + what); };
    const Intrinsics& c = intrinsics;
    if (c.width_px < 1 || c.height_px < 1)
        fail(
            words("the image size is %d x %d, expected the width and height in pixels of the "
                  "images that were calibrated",
                  c.width_px, c.height_px));
    for (const auto& [name, value] : {std::pair{"fx", c.fx_px}, {"fy", c.fy_px}})
        if (!(std::isfinite(value) && value > 0))
            fail(words("%s is %g, expected a focal length in pixels above 0", name, value));
    for (const auto& [name, value] : {std::pair{"cx", c.cx_px}, {"cy", c.cy_px}})
        if (!std::isfinite(value)) fail(words("%s is %g, expected a finite number", name, value));
    const std::size_t n = distortion.size();
    if (n != 0 && n != 4 && n != 5 && n != 8)
        fail(
            words("there are %d distortion coefficients, expected 4 (k1 k2 p1 p2), 5 (and k3) or "
                  "8 (and k4 k5 k6) of OpenCV's standard or rational model; calibrate without "
                  "the thin prism, tilted and fisheye models",
                  static_cast<int>(n)));
    for (std::size_t i = 0; i < n; ++i)
        if (!std::isfinite(distortion[i]))
            fail(words("distortion coefficient %d is %g, expected a finite number",
                       static_cast<int>(i) + 1, distortion[i]));
    std::copy(distortion.begin(), distortion.end(), intrinsics.distortion.begin());
    return intrinsics;
}

}  // namespace pilotage
