#pragma once
/// \file
/// The pose that explains sightings best, near one that explains them somehow: damped Gauss-Newton
/// (Levenberg) on the mixture likelihood. Its gradient is the Gaussians' by the belief that the
/// sighting is no clutter, so clutter does not pull.

#include "pilotage/filter/ldlt.hpp"
#include "pilotage/search/likelihood.hpp"

namespace pilotage {

/// A pose with what sightings say about it, to second order.
struct PoseFit {
    Pose<double> pose{0, 0, 0};
    double log_likelihood = 0;
    Matrix<double, 3> information;  ///< of the sightings and of the site
    Vector<double, 3> gradient;     ///< of the log-likelihood
};

/// \param views of `count` sightings
[[nodiscard]] inline PoseFit fit_at(const Pose<double>& pose, const View* views, int count,
                                    const MarkerMap& map, const Site& site, double widen) noexcept {
    PoseFit fit;
    fit.pose = pose;
    // The site bounds what no sighting tells; it does not pull.
    fit.information = site.variances().cwiseInverse().asDiagonal();
    fit.gradient.setZero();
    const Frame robot(pose);
    for (int i = 0; i < count; ++i) {
        const Explanation e = explain(views[i], robot, map, widen);
        fit.log_likelihood += e.log_likelihood;
        for (int k = 0; k < e.match.count; ++k) {
            const Match::Row& row = e.match.rows[k];
            const double weight = e.belief * row.information;
            const double h[] = {row.by_x, row.by_y, row.by_heading};
            each<3>([&](int a) {
                fit.gradient[a] += weight * row.residual * h[a];
                each<3>([&](int b) { fit.information(a, b) += weight * h[a] * h[b]; });
            });
        }
    }
    return fit;
}

/// Climbs to the top nearest to `start`.
[[nodiscard]] inline PoseFit climb(const Pose<double>& start, const View* views, int count,
                                   const MarkerMap& map, const Site& site, double widen) noexcept {
    constexpr int kSteps = 8;
    constexpr double kEnough = 1e-2;  // log-likelihood that a step is expected to add
    constexpr double kDamping = 1e-3, kMostDamping = 1e4;
    PoseFit fit = fit_at(start, views, count, map, site, widen);
    double damping = kDamping;
    for (int step = 0; step < kSteps && damping < kMostDamping; ++step) {
        Matrix<double, 3> damped = fit.information;
        damped.diagonal() *= 1 + damping;
        const Vector<double, 3> dx = Ldlt<double, 3>(damped).solve(fit.gradient);
        const PoseFit next = fit_at(plus(fit.pose, dx), views, count, map, site, widen);
        if (next.log_likelihood < fit.log_likelihood) {
            damping *= 10;
            continue;
        }
        const bool settled = fit.gradient.dot(dx) < kEnough;
        fit = next;
        if (settled) break;
        damping /= 10;
    }
    return fit;
}

}  // namespace pilotage
