#pragma once
/// \file
/// Filters, models and noise at hand for the tests of pilotage::Ekf.

#include "pilotage/filter/ekf.hpp"
#include "pilotage/motion/calibrated.hpp"
#include "pilotage/motion/unicycle.hpp"
#include "support/random.hpp"
#include "support/sightings.hpp"

namespace pilotage::test {

/// The motion model that fits a filter of N states.
template <typename Scalar, int N>
[[nodiscard]] auto motion() {
    const Unicycle<Scalar, Chord::arc> drive{Scalar(0.05)};
    if constexpr (N == kPoseStates)
        return drive;
    else
        return Calibrated<Unicycle<Scalar, Chord::arc>, Scalar>{drive, Scalar(0.02)};
}

/// Somewhere, with nearly perfect calibration and a full covariance.
template <typename Scalar, int N>
[[nodiscard]] Ekf<Scalar, N> random_filter(Draw& draw, double variance = 0.1) {
    Vector<Scalar, N> x = Vector<Scalar, N>::Zero();
    x.template head<3>() = draw.pose<Scalar>();
    if constexpr (N == kCalibratedStates)
        x.template tail<3>() << Scalar(0.01), Scalar(1.02), Scalar(0.98);
    return {x, draw.covariance<Scalar, N>(variance)};
}

/// A marker within sight of a filter, neither very close nor very far.
template <typename Scalar, int N>
[[nodiscard]] Vector<Scalar, 3> marker_in_sight(Draw& draw, const Ekf<Scalar, N>& filter) {
    const double distance = draw.uniform(1, 20), direction = draw.uniform(-3.1, 3.1);
    return {filter.state()[kX] + Scalar(distance * std::cos(direction)),
            filter.state()[kY] + Scalar(distance * std::sin(direction)), Scalar(-1.2)};
}

}  // namespace pilotage::test
