#pragma once
/// \file
/// What a search found last, for the next one to begin with.

#include "pilotage/search/frame.hpp"
#include "pilotage/search/hypothesis.hpp"

namespace pilotage {

/// The hypotheses where dead reckoning has brought them since.
class Ideas {
   public:
    static constexpr int kMost = Hypotheses::kMost;

    Ideas() = default;
    Ideas(const Ideas& other) noexcept { *this = other; }
    /// Mostly there are none, and then nothing to copy.
    Ideas& operator=(const Ideas& other) noexcept {
        count_ = other.count_;
        if (count_ > 0) odometry_ = other.odometry_;
        for (int i = 0; i < count_; ++i) poses_[i] = other.poses_[i];
        return *this;
    }

    void remember(const Hypotheses& found, const Pose<double>& odometry) noexcept {
        count_ = found.count;
        odometry_ = odometry;
        for (int i = 0; i < count_; ++i) poses_[i] = found[i].pose;
    }

    /// \param poses receives them. \return how many
    [[nodiscard]] int recall(const Pose<double>& odometry, Pose<double>* poses) const noexcept {
        if (count_ == 0) return 0;
        const Pose<double> way = Frame(odometry_).into(odometry);
        for (int i = 0; i < count_; ++i) poses[i] = Frame(poses_[i]).out_of(way);
        return count_;
    }

   private:
    int count_ = 0;
    Pose<double> odometry_;  // of the robot then
    Pose<double> poses_[kMost];
};

}  // namespace pilotage
