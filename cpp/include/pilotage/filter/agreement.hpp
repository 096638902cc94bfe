#pragma once
/// \file
/// Whether the measurements of late agree with the covariance that the filter states.

#include <algorithm>

namespace pilotage {

/// Follows NIS / dof, which has mean 1 where model and noise are right. Each value counts no more
/// than the gate's, so that a few gross outliers do not tell against the estimate, and a
/// run of them does.
class Agreement {
   public:
    /// \param gate_nis NIS that a good measurement of so many components rarely exceeds
    void add(double nis, int dof, double gate_nis) noexcept {
        in_a_row_ = nis <= gate_nis ? in_a_row_ + 1 : 0;
        constexpr double smoothing = 0.05;
        mean_ += smoothing * (std::min(nis, gate_nis) / dof - mean_);
        if (mean_ > kTooMuch) disagrees_ = true;
        if (in_a_row_ >= kSettled && (disagrees_ || mean_ > 1)) {
            mean_ = std::min(mean_, 1.0);
            disagrees_ = false;
        }
        if (in_a_row_ >= kConfirming && !disagrees_) confirmed_ = true;
    }

    /// The pose is a hypothesis again.
    void doubt() noexcept { *this = {}; }
    void confirm() noexcept { confirmed_ = true; }

    [[nodiscard]] bool confirmed() const noexcept { return confirmed_; }
    [[nodiscard]] bool disagrees() const noexcept { return disagrees_; }
    [[nodiscard]] bool last_agreed() const noexcept { return in_a_row_ > 0; }
    [[nodiscard]] int in_a_row() const noexcept { return in_a_row_; }
    [[nodiscard]] double mean() const noexcept { return mean_; }

    static constexpr double kTooMuch = 3;  ///< of the mean
    static constexpr int kConfirming = 3;  ///< agreeing measurements in a row confirm a pose
    static constexpr int kSettled = 10;    ///< as many end a disagreement

   private:
    double mean_ = 1;
    int in_a_row_ = 0;
    bool disagrees_ = false, confirmed_ = false;
};

}  // namespace pilotage
