#pragma once
/// \file
/// Whether the measurements of late agree with the covariance that the filter states.

#include <algorithm>
#include <cstdint>

namespace pilotage {

/// Follows NIS / dof, which has mean 1 where model and noise are right. Each value counts no more
/// than `kMost`, so that outliers among good measurements do not tell against the estimate, and a
/// run of them does.
class Agreement {
   public:
    /// \param gate_nis NIS that a good measurement of so many components rarely exceeds
    void add(double nis, int dof, double gate_nis) noexcept {
        const bool agrees = nis <= gate_nis;
        in_a_row_ = agrees ? in_a_row_ + 1 : 0;
        latest_ = static_cast<std::uint8_t>(latest_ << 1 | (agrees ? 0 : 1));
        constexpr double smoothing = 0.05;
        mean_ += smoothing * (std::min(nis / dof, kMost) - mean_);
        if (mean_ > kTooMuch || latest_ == kNoneOfEight) disagrees_ = true;
        if (in_a_row_ >= kSettled && (disagrees_ || mean_ > 1)) {
            mean_ = std::min(mean_, 1.0);
            disagrees_ = false;
        }
    }

    /// Enough of them in a row to believe in a pose.
    [[nodiscard]] bool confirms() const noexcept { return in_a_row_ >= kConfirming && !disagrees_; }
    [[nodiscard]] bool disagrees() const noexcept { return disagrees_; }
    [[nodiscard]] bool last_agreed() const noexcept { return in_a_row_ > 0; }
    /// More outliers of late than a good estimate sees: reason to look for another.
    [[nodiscard]] bool suspicious() const noexcept { return (latest_ & (latest_ - 1)) != 0; }
    [[nodiscard]] int in_a_row() const noexcept { return in_a_row_; }
    [[nodiscard]] double mean() const noexcept { return mean_; }

    static constexpr double kTooMuch = 3;  ///< of the mean
    static constexpr double kMost = 5;     ///< that one value counts
    static constexpr int kConfirming = 3;  ///< agreeing measurements in a row confirm a pose
    static constexpr int kSettled = 10;    ///< as many end a disagreement

   private:
    static constexpr std::uint8_t kNoneOfEight = 0xff;

    double mean_ = 1;
    int in_a_row_ = 0;
    std::uint8_t latest_ = 0;  // a bit for each of the last eight that did not agree
    bool disagrees_ = false;
};

}  // namespace pilotage
