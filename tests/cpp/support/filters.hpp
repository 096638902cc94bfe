#pragma once
/// \file
/// Filters, models and noise at hand for the tests of pilotage::Ekf and pilotage::Ukf.

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

/// A step of any kind, its noise of any size; for an Ekf or a Ukf.
template <template <typename, int, typename> class Filter, typename Scalar, int N, typename Space>
void predict_randomly(Draw& draw, Filter<Scalar, N, Space>& filter) {
    const Vector<Scalar, 2> u(draw.uniform<Scalar>(-0.1, 0.3), draw.uniform<Scalar>(-0.2, 0.2));
    const Matrix<Scalar, 2> gamma = Vector<Scalar, 2>(draw.log_uniform<Scalar>(1e-8, 1e-3),
                                                      draw.log_uniform<Scalar>(1e-9, 1e-4))
                                        .asDiagonal();
    Vector<Scalar, N> q = Vector<Scalar, N>::Zero();
    for (int i = 0; i < 3; ++i) q[i] = draw.log_uniform<Scalar>(1e-12, 1e-4);
    filter.predict(motion<Scalar, N>(), u, gamma, q);
}

/// A marker at 5 cm to 30 m, its noise from a very good laser's to useless, every tenth an outlier.
template <typename Sighting, template <typename, int, typename> class Filter, typename Scalar,
          int N, typename Space>
bool update_randomly(Draw& draw, Filter<Scalar, N, Space>& filter, const Policy& policy) {
    constexpr int kRows = Sighting::kComponents;
    const double distance = draw.log_uniform(0.05, 30), direction = draw.uniform(-3.1, 3.1);
    const Vector<Scalar, 3> marker(filter.state()[kX] + Scalar(distance * std::cos(direction)),
                                   filter.state()[kY] + Scalar(distance * std::sin(direction)),
                                   draw.uniform<Scalar>(-1, 1));
    const Sighting sighting{marker};
    Matrix<Scalar, kRows> r = Matrix<Scalar, kRows>::Zero();
    for (int i = 0; i < kRows; ++i) r(i, i) = draw.log_uniform<Scalar>(1e-7, 1);
    const Scalar outlier = draw.uniform(0, 1) < 0.1 ? 10 : 1;
    const Vector<Scalar, kRows> z =
        sighting.linearize(filter.state().template head<3>()).value +
        (r.diagonal().cwiseSqrt() * outlier).cwiseProduct(draw.normal<Scalar, kRows>());
    return filter.update(sighting, z, r, policy).accepted();
}

}  // namespace pilotage::test
