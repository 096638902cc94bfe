#pragma once
/// \file
/// How noisy each sensor and the motion are against what is configured, learned from innovations.
///
/// The log likelihood of one component's innovation v, whose variance is S = H P H' + R, is
///     L = -(v^2 / S + ln S) / 2.
/// Of a factor f on R, or on the motion noise that H P H' grew from, it depends by
///     dL / d ln f = share (v^2 / S - 1) / 2,  with share = R / S, or H P H' / S,
/// and every innovation moves ln f a small step up that slope: innovation-based adaptation (Mehra,
/// "Approaches to adaptive filtering", IEEE Trans. Automatic Control 17(5), 1972) by stochastic
/// approximation. Its mean is zero where both factors are right, whatever their shares; shares that
/// differ, between components and from the first sighting after a while to the next, tell the
/// factors apart.

#include <algorithm>
#include <array>
#include <cmath>

#include "pilotage/params.hpp"
#include "pilotage/samples.hpp"

namespace pilotage {

class NoiseScale {
   public:
    static constexpr double kMost = 4;  ///< of a sigma, and 1 / kMost at least

    /// Estimated over configured sigma.
    [[nodiscard]] double sensor(int number) const noexcept {
        return std::exp(log_sensor_[static_cast<std::size_t>(number)] / 2);
    }
    /// Likewise, of the motion.
    [[nodiscard]] double motion() const noexcept { return std::exp(log_motion_ / 2); }

    /// Learns from one component of a sighting.
    /// \param squared v^2 / S
    /// \param sensor_share, motion_share of S
    void learn(int number, double squared, double sensor_share, double motion_share) noexcept {
        if (!(squared <= kBeyond)) return;
        const double slope = (std::min(squared, kCap) - kMean) / 2;
        move(log_sensor_[static_cast<std::size_t>(number)], sensor_share * slope);
        move(log_motion_, motion_share * slope);
    }

   private:
    // Outliers are no noise: a square beyond three sigmas does not count, and one beyond two no
    // more than that. kMean is what is left of the mean of 1 where the noise is normal:
    // E(min(z^2, 4) | z^2 <= 9).
    static constexpr double kCap = 4, kBeyond = 9, kMean = 0.9122005;
    static constexpr double kStep = 0.01;  // some hundred components settle a factor

    static void move(float& log_variance, double slope) noexcept {
        const double most = 2 * std::log(kMost);
        log_variance = static_cast<float>(std::clamp(log_variance + kStep * slope, -most, most));
    }

    // Natural logarithms of the variance factors.
    std::array<float, Params::kMaxSensors> log_sensor_{};
    float log_motion_ = 0;
};

/// A sighting whose stated sigmas are so many times as large.
[[nodiscard]] inline Sighting scaled(Sighting sighting, double scale) noexcept {
    for (double& sigma : sighting.sigma) sigma *= scale;
    return sighting;
}

/// A sensor whose sigmas are so many times as large.
[[nodiscard]] inline SensorParams scaled(SensorParams sensor, double scale) noexcept {
    for (double* sigma : {&sensor.sigma_bearing_rad, &sensor.sigma_elevation_rad,
                          &sensor.sigma_range_m, &sensor.sigma_range_per_m, &sensor.sigma_pixel})
        *sigma *= scale;
    return sensor;
}

}  // namespace pilotage
