#pragma once
/// \file
/// Whether a sensor's elevations are off in a way that noise is not.
///
/// Innovations of a filter that is right are white with the variances that it states, so that over
/// the latest sightings, each weighted w = 1 / sigma^2,
///     mean / sd of the mean   = sum(w v) / sqrt(sum(w)), and
///     slope / sd of the slope = sum(w (d - mean d) v) / sqrt(sum(w (d - mean d)^2))
/// by the distance d to the marker are standard normal or less. A pitch or a lasting tilt moves the
/// mean; a wrong height does so more the nearer the marker, uneven ground more the farther it is.

#include <algorithm>
#include <cmath>
#include <string>

#include "pilotage/angle.hpp"
#include "words.hpp"

namespace pilotage {

class ElevationWatch {
   public:
    /// \param innovation_rad of a sighting that agrees with the pose
    void add(double innovation_rad, double sigma_rad, double distance_m) noexcept {
        constexpr double most = 3;  // sigmas; more is an outlier
        const double v = std::clamp(innovation_rad, -most * sigma_rad, most * sigma_rad);
        const double w = 1 / (sigma_rad * sigma_rad), d = distance_m;
        const auto gather = [](double& sum, double more) { sum += more - sum / kMemory; };
        gather(w_, w);
        gather(wd_, w * d);
        gather(wdd_, w * d * d);
        gather(wv_, w * v);
        gather(wdv_, w * d * v);
    }

    /// What is off, empty if nothing is.
    [[nodiscard]] std::string problem() const {
        if (!(w_ > 0)) return "";
        constexpr double degree = kPi<double> / 180;
        const double spread = std::max(0.0, wdd_ - wd_ * wd_ / w_);
        const double common = wdv_ - wd_ * wv_ / w_;
        const bool apart = spread > kApart_m * kApart_m * w_;
        if (apart && std::abs(common) > kLimit * std::sqrt(spread))
            return words(
                "its elevations %s with range, by %.2f deg a metre: is the ground flat, are z_m "
                "and "
                "the markers' z right?",
                common > 0 ? "rise" : "fall", std::abs(common / spread) / degree);
        if (std::abs(wv_) > kLimit * std::sqrt(w_))
            return words(
                "its elevations are %.1f deg too %s on average: check the sensor's pitch, or tilt:",
                std::abs(wv_ / w_) / degree, wv_ > 0 ? "high" : "low");
        return "";
    }

   private:
    static constexpr double kMemory = 500;  // sightings
    // Of a standard normal, until the sums forget: they keep half the variance, and it is 8.5 of
    // theirs. So much of 500 is a mean of 0.27 sigma, which no noise comes near.
    static constexpr double kLimit = 6;
    static constexpr double kApart_m = 0.1;  // distances that differ less tell of no slope

    double w_ = 0, wd_ = 0, wdd_ = 0, wv_ = 0, wdv_ = 0;  // sums that forget
};

}  // namespace pilotage
