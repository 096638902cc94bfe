// Climbing to the pose that explains sightings best.

#include "pilotage/search/refinement.hpp"

#include "support/geometry.hpp"
#include "support/matchers.hpp"
#include "support/random.hpp"
#include "support/sighting_drives.hpp"

namespace pilotage::test {
namespace {

/// What the robot sees of the first markers, each with another mix of components.
struct MixedSightings {
    SensorParams sensor;
    std::vector<Sighting> sightings;
    std::vector<View> views;

    explicit MixedSightings(double noise = 0, int id_of_all = 0) {
        Draw draw(7);
        for (int i = 0; i < 8; ++i) {
            Vector<double, 3> z = view(kInYard, kYard.markers()[static_cast<std::size_t>(i)]);
            const Vector<double, 3> n = noise * draw.normal<double, 3>();
            z += Vector<double, 3>(0.02 * n[0], 0.02 * n[1], 0.1 * n[2]);
            z = only(z, i % 4 != 3, i % 4 == 1, i % 4 >= 2);
            sightings.push_back(
                {{z[0], z[1], z[2]}, {kNan, kNan, kNan}, id_of_all < 0 ? -1 : i, -1});
        }
        for (const Sighting& s : sightings) views.push_back(view_of(s, sensor, kYard, kYardSite));
    }
    [[nodiscard]] PoseFit at(const Pose<double>& pose) const {
        return fit_at(pose, views.data(), 8, kYard, kYardSite, 1);
    }
    [[nodiscard]] PoseFit from(const Pose<double>& pose, double widen) const {
        return climb(pose, views.data(), 8, kYard, kYardSite, widen);
    }
};

TEST(RefinementTest, GradientIsTheDerivativeOfTheLogLikelihood) {
    const MixedSightings seen(1);
    const Pose<double> pose = kInYard + Pose<double>(0.03, -0.02, 0.01);
    for (int i = 0; i < 3; ++i) {
        constexpr double step = 1e-6;
        const Pose<double> dx = step * Pose<double>::Unit(i);
        const double slope =
            (seen.at(pose + dx).log_likelihood - seen.at(pose - dx).log_likelihood) / (2 * step);
        // The variances depend on the pose too, which Gauss-Newton leaves out.
        EXPECT_NEAR(seen.at(pose).gradient[i], slope, 1e-4 * (1 + std::abs(slope)));
    }
}

TEST(RefinementTest, ExactSightingsLeadToTheExactPoseFromAMetreOff) {
    for (const int id : {0, -1}) {
        const MixedSightings seen(0, id);
        const PoseFit wide = seen.from(kInYard + Pose<double>(0.3, -0.4, 0.15), 16);
        const PoseFit fit = seen.from(seen.from(wide.pose, 1).pose, 1);
        EXPECT_TRUE(same_pose(fit.pose, kInYard, 1e-4)) << id;
    }
}

TEST(RefinementTest, AWrongSightingDoesNotPull) {
    MixedSightings seen;
    seen.sightings[0].value[kBearing] += 0.8;
    seen.views[0] = view_of(seen.sightings[0], seen.sensor, kYard, kYardSite);
    EXPECT_TRUE(
        same_pose(seen.from(kInYard + Pose<double>(0.02, 0.02, 0.01), 1).pose, kInYard, 1e-4));
}

TEST(RefinementTest, WhatNoSightingTellsIsAsUnsureAsTheSiteIsLarge) {
    const MixedSightings seen;
    const PoseFit fit = climb(kInYard, seen.views.data(), 0, kYard, kYardSite, 1);
    const Matrix<double, 3> covariance = Ldlt<double, 3>(fit.information).inverse();
    EXPECT_TRUE(close(Pose<double>(covariance.diagonal()), kYardSite.variances(), 1e-12));
}

}  // namespace
}  // namespace pilotage::test
