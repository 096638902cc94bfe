#pragma once
/// \file
/// The one judge of all ideas of the pose: the estimate's own, whoever it is from, and those that a
/// search has found.

#include <cmath>
#include <cstdint>

#include "pilotage/filter/ldlt.hpp"
#include "pilotage/search/frame.hpp"
#include "pilotage/search/pose_search.hpp"
#include "pilotage/state.hpp"

namespace pilotage {

namespace judging {

/// An explanation is better than another only by so many nats: one in a thousand is wrong then.
inline constexpr double kDecisive = 7;
/// So much better is another than a confirmed estimate where doubt begins, and than any estimate
/// where it is believed: robots are rarely carried off, and outliers that agree with each other by
/// chance are not so rare.
inline constexpr double kSuspicious = 3, kMoved = 25;
/// A pose found has to hold for so many frames, and on a way so long; a robot that stands is misled
/// by the same thing again and again, so there it takes more frames.
inline constexpr int kFrames = 3, kFramesStanding = 10;
inline constexpr double kWay_m = 0.3, kWay_rad = 0.3;
/// On which dead reckoning may be off by so much, in sigmas: it may be what is wrong.
inline constexpr double kOff_m = 0.05, kOff_rad = 0.05;
/// So many markers have to speak for a pose other than one that was confirmed, if the map has them:
/// two may be swapped, or one be moved.
inline constexpr int kMarkers = 3;

/// Of the newest sightings it may leave so many unexplained: else it is of where the robot was.
inline constexpr int kClutterOfLatest = 2;

/// A pose less sure than this is none yet [m^2, each axis] and [rad^2].
inline constexpr double kVaguest_m2 = 1, kVaguest_rad2 = 0.1;

[[nodiscard]] inline bool vague(const Matrix<double, 3>& covariance) noexcept {
    return !(covariance(kX, kX) <= kVaguest_m2 && covariance(kY, kY) <= kVaguest_m2 &&
             covariance(kHeading, kHeading) <= kVaguest_rad2);
}

/// As far as the covariance of their difference can tell.
[[nodiscard]] inline bool same(const Pose<double>& a, const Pose<double>& b,
                               const Matrix<double, 3>& covariance) noexcept {
    constexpr double limit = 16;  // four sigmas
    return Ldlt<double, 3>(covariance).squared_norm(minus<double, 3>(a, b)) < limit;
}

/// The same place for all practical purposes: the filter goes there by itself.
[[nodiscard]] inline bool near(const Pose<double>& a, const Pose<double>& b) noexcept {
    const Pose<double> off = minus<double, 3>(a, b);
    return std::hypot(off[kX], off[kY]) < 0.2 && std::abs(off[kHeading]) < 0.1;
}

}  // namespace judging

/// What the sightings of late say about the estimate.
enum class Finding : std::uint8_t {
    fine,       ///< it explains them better than any other pose
    ambiguous,  ///< several poses explain them alike
    elsewhere,  ///< one other pose explains them better
};

/// What the search found last, where dead reckoning has brought it since: it goes on from there.
class Ideas {
   public:
    static constexpr int kMost = PoseSearch::kMostHypotheses;

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

/// What the judge thinks, and what it waits for.
struct Judgement {
    Finding finding = Finding::fine;
    double margin = 0;                  ///< nats between the best explanation and the next
    int held = 0;                       ///< frames that the best pose has held for
    Pose<double> leader = {0, 0, 0};    ///< that pose in the first of them
    Pose<double> odometry = {0, 0, 0};  ///< of the robot then
    Ideas ideas;
};

/// The estimate as one idea among others.
struct Claim {
    bool made = false;       ///< there is an estimate
    bool confirmed = false;  ///< by sightings; else it has to prove itself
    Pose<double> pose = {0, 0, 0};
    Matrix<double, 3> covariance = Matrix<double, 3>::Zero();
    double log_evidence = 0;          ///< of all sightings, under the estimate
    int markers = judging::kMarkers;  ///< that have to speak for another pose
};

/// Weighs what a search found against the estimate.
/// \param odometry pose of the robot by dead reckoning alone
/// \return the hypothesis that wins, or nullptr as long as none does
[[nodiscard]] inline const Hypothesis* judge(Judgement& j, const Claim& claim,
                                             const Hypotheses& found,
                                             const Pose<double>& odometry) noexcept {
    using namespace judging;
    // By how much each explains the sightings better than the estimate does, or than chance. An
    // estimate that was confirmed is held against the latest alone: before them the robot may not
    // have been carried off yet.
    const auto strength = [&](const Hypothesis& h) {
        return claim.made && !claim.confirmed ? h.log_evidence - claim.log_evidence : h.gain;
    };
    const Hypothesis* best = nullptr;
    double first = -INFINITY, second = -INFINITY;
    for (const Hypothesis& h : found) {
        if (claim.made &&
            (near(h.pose, claim.pose) || same(h.pose, claim.pose, h.covariance + claim.covariance)))
            continue;
        const double s = strength(h);
        if (s > first) {
            second = first;
            first = s;
            best = &h;
        } else if (s > second) {
            second = s;
        }
    }
    const double margin = first - std::fmax(second, 0.0);  // the estimate itself stands at 0
    const int held = j.held;
    j.held = 0;
    j.margin = margin;
    if (best == nullptr || first < (claim.confirmed ? kSuspicious : claim.made ? -kDecisive : 0)) {
        j.finding = Finding::fine;
        return nullptr;
    }
    if (margin < kDecisive) {
        j.finding = !claim.made && first < kDecisive ? Finding::fine : Finding::ambiguous;
        return nullptr;
    }
    j.finding = Finding::elsewhere;
    if (vague(best->covariance) || best->clutter > kClutterOfLatest ||
        (claim.made && margin < kMoved) ||
        (claim.confirmed && best->distinct_markers() < claim.markers))
        return nullptr;
    // Where dead reckoning has brought what led first.
    const Pose<double> way = Frame(j.odometry).into(odometry);
    Matrix<double, 3> unsure = 2 * best->covariance;
    unsure.diagonal() += Pose<double>(kOff_m * kOff_m, kOff_m * kOff_m, kOff_rad * kOff_rad);
    const bool leads = held > 0 && same(best->pose, Frame(j.leader).out_of(way), unsure);
    j.held = leads ? held + 1 : 1;
    if (!leads) {
        j.leader = best->pose;
        j.odometry = odometry;
    }
    const bool tried = std::hypot(way[kX], way[kY]) >= kWay_m ||
                       std::abs(way[kHeading]) >= kWay_rad || j.held >= kFramesStanding;
    return leads && tried && j.held >= kFrames ? best : nullptr;
}

}  // namespace pilotage
