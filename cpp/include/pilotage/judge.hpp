#pragma once
/// \file
/// The one judge of all ideas of the pose: the estimate's own, whoever it is from, and those that a
/// search has found.

#include <cstdint>

#include "pilotage/search/hypothesis.hpp"
#include "pilotage/search/ideas.hpp"
#include "pilotage/state.hpp"

namespace pilotage {

namespace judging {

/// An explanation is better than another only by so many nats: one in a thousand is wrong then.
inline constexpr double kDecisive = 7;
/// So much better is another than a confirmed estimate where doubt begins, and than any estimate
/// where it is believed: robots are rarely carried off, and outliers that agree with each other by
/// chance are not so rare.
inline constexpr double kSuspicious = 3, kMoved = 25;
/// A pose found has to hold for so many frames, and on a way so long. It takes more of them where
/// the same thing may mislead again and again: a robot that stands, a map of which a search could
/// not try all.
inline constexpr int kFrames = 3, kMoreFrames = 10;
inline constexpr double kWay_m = 0.3, kWay_rad = 0.3;
/// On which dead reckoning may be off by so much, in sigmas: it may be what is wrong.
inline constexpr double kOff_m = 0.05, kOff_rad = 0.05;
/// So many markers speak for a pose other than one that was confirmed, if the map has them: two may
/// be swapped, or one be moved.
inline constexpr int kMarkers = 3;
/// So many have to agree with a pose that was given: what follows one thing that moves, as another
/// robot, agrees with it for as long as that is in view.
inline constexpr int kConfirmingMarkers = 2;

/// Of the newest sightings it may leave so many unexplained: else it is of where the robot was.
inline constexpr int kClutterOfLatest = 2;

/// A pose less sure than this is none yet [m^2, each axis] and [rad^2].
inline constexpr double kVaguest_m2 = 1, kVaguest_rad2 = 0.1;

[[nodiscard]] bool vague(const Matrix<double, 3>& covariance) noexcept;

}  // namespace judging

/// What the sightings of late say about the estimate.
enum class Finding : std::uint8_t {
    fine,       ///< it explains them better than any other pose
    ambiguous,  ///< several poses explain them alike
    elsewhere,  ///< one other pose explains them better
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
    int markers = judging::kMarkers;  ///< that should speak for another pose
};

/// Weighs what a search found against the estimate.
/// \param odometry pose of the robot by dead reckoning alone
/// \return the hypothesis that wins, or nullptr as long as none does
[[nodiscard]] const Hypothesis* judge(Judgement& judgement, const Claim& claim,
                                      const Hypotheses& found,
                                      const Pose<double>& odometry) noexcept;

}  // namespace pilotage
