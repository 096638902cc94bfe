#pragma once
/// \file
/// A pose that explains what was seen, and how well it does.

#include <cstdint>

#include "pilotage/filter/ldlt.hpp"
#include "pilotage/state.hpp"

namespace pilotage {

struct Hypothesis {
    Pose<double> pose{0, 0, 0};    ///< of the robot now, in frame map
    Matrix<double, 3> covariance;  ///< inverse Hessian of the robust fit
    /// Logarithm of the probability density of all that was seen if the robot is somewhere here:
    /// Laplace's approximation, the log-likelihoods' sum + 0.5 log det(2 pi covariance) -
    /// log(volume of all poses).
    double log_evidence = 0;
    /// The same for the newest sightings alone and less what the given estimate makes of them (or
    /// clutter, where none is given), for the number of sightings that makes the most of it: how
    /// much better this explains what was seen of late.
    double gain = 0;
    int explained = 0;          ///< that number
    int sightings = 0;          ///< of these, not clutter
    std::uint64_t markers = 0;  ///< that these are of; bit: place in the map, modulo 64

    [[nodiscard]] int distinct_markers() const noexcept {
        int n = 0;
        for (std::uint64_t bits = markers; bits != 0; bits &= bits - 1) ++n;
        return n;
    }
};

/// Whether two poses are one as far as the first one's covariance can tell.
[[nodiscard]] inline bool same(const Hypothesis& a, const Pose<double>& pose,
                               double squared_sigmas) noexcept {
    return Ldlt<double, 3>(a.covariance).squared_norm(minus(pose, a.pose)) < squared_sigmas;
}

}  // namespace pilotage
