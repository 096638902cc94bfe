#pragma once
/// \file
/// Poses that explain what was seen, and how well they do.

#include "pilotage/marker_set.hpp"
#include "pilotage/state.hpp"

namespace pilotage {

struct Hypothesis {
    Pose<double> pose{0, 0, 0};    ///< of the robot now, in frame map
    Matrix<double, 3> covariance;  ///< inverse Hessian of the robust fit
    /// Variances (x, y, heading) that come with what went wrong on the way of all older sightings.
    /// They are of the pose that is taken; whether two explanations are the same is told without.
    Pose<double> drift{0, 0, 0};
    /// Logarithm of the probability density of all that was seen if the robot is somewhere here:
    /// Laplace's approximation, the log-likelihoods' sum + 0.5 log det(2 pi covariance) -
    /// log(volume of all poses).
    double log_evidence = 0;
    /// The same for the newest sightings alone and less what the given estimate makes of them (or
    /// clutter, where none is given), for the number of sightings that makes the most of it: how
    /// much better this explains what was seen of late.
    double gain = 0;
    int explained = 0;  ///< that number
    int sightings = 0;  ///< of these, not clutter
    MarkerSet markers;  ///< that these are of
    static constexpr int kLatest = 6;
    int clutter = 0;  ///< of the newest kLatest sightings, that it does not explain
};

/// What a search found, best gain first.
struct Hypotheses {
    static constexpr int kMost = 8;

    const Hypothesis* first = nullptr;
    int count = 0;
    bool whole = true;  ///< else part of the map was not looked at

    [[nodiscard]] const Hypothesis* begin() const noexcept { return first; }
    [[nodiscard]] const Hypothesis* end() const noexcept { return first + count; }
    [[nodiscard]] const Hypothesis& operator[](int i) const noexcept { return first[i]; }
};

}  // namespace pilotage
