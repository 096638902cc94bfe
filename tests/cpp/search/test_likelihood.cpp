// How likely a sighting is from a pose: a density, with clutter, over the markers that it can be
// of.

#include "pilotage/search/likelihood.hpp"

#include "support/geometry.hpp"
#include "support/matchers.hpp"
#include "support/random.hpp"
#include "support/sighting_drives.hpp"

namespace pilotage::test {
namespace {

Explanation explained(const Vector<double, 3>& z, int id, const Pose<double>& robot = kInYard,
                      double drift_m2 = 0, double drift_rad2 = 0, const SensorParams& sensor = {}) {
    const Sighting sighting{{z[0], z[1], z[2]}, {kNan, kNan, kNan}, id, -1};
    const View view = view_of(sighting, sensor, kYard, kYardSite, {0, 0, 0}, drift_m2, drift_rad2);
    return explain(view, Frame(robot), kYard);
}

TEST(LikelihoodTest, OfBearingsIntegratesToOneWithAndWithoutAnId) {
    for (const int id : {4, -1}) {
        double total = 0;
        constexpr int steps = 20000;
        for (int i = 0; i < steps; ++i) {
            const double bearing = -kPi<double> + 2 * kPi<double> * (i + 0.5) / steps;
            total += std::exp(explained({bearing, kNan, kNan}, id).log_likelihood);
        }
        EXPECT_NEAR(total * 2 * kPi<double> / steps, 1, 1e-6) << id;
    }
}

TEST(LikelihoodTest, OfAnExactSightingIsTheGaussiansPeakAndTheClutter) {
    const SensorParams sensor;
    const Vector<double, 3> z = view(kInYard, kYard.markers()[4], sensor);
    const double peak = 1 / (std::pow(2 * kPi<double>, 1.5) * sensor.sigma_bearing_rad *
                             sensor.sigma_elevation_rad * sensor.sigma_range_m);
    const double clutter = 1 / (2 * kPi<double> * kPi<double> * kYardSite.reach_m);
    const Explanation e = explained(z, 4);
    EXPECT_NEAR(e.log_likelihood, std::log((1 - kClutter) * peak + kClutter * clutter), 1e-9);
    EXPECT_EQ(e.marker, &kYard.markers()[4]);
    EXPECT_GT(e.belief, 0.999);
}

TEST(LikelihoodTest, WithoutAnIdAMarkerIsOneOfTen) {
    const Vector<double, 3> z = view(kInYard, kYard.markers()[4]);
    const double known = std::exp(explained(z, 4).log_likelihood);
    const double unknown = std::exp(explained(z, -1).log_likelihood);
    const double clutter = kClutter / (2 * kPi<double> * kPi<double> * kYardSite.reach_m);
    EXPECT_NEAR((unknown - clutter) / (known - clutter), 0.1, 1e-3);
}

TEST(LikelihoodTest, OfAGrossOutlierIsClutterAndBelievedOfNone) {
    Vector<double, 3> z = only(view(kInYard, kYard.markers()[4]), true, false, false);
    z[0] = wrap(z[0] + 1);
    const Explanation e = explained(z, 4);
    EXPECT_NEAR(e.log_likelihood, std::log(kClutter / (2 * kPi<double>)), 1e-12);
    EXPECT_EQ(e.belief, 0);
}

TEST(LikelihoodTest, DriftWidensWhatItReaches) {
    const Marker& marker = kYard.markers()[4];
    const Vector<double, 3> z = view(kInYard, marker);
    const double ground = std::hypot(marker.x_m - kInYard[kX], marker.y_m - kInYard[kY]);
    const Match match = explained(only(z, true, false, true), 4, kInYard, 0.01, 0.0004).match;
    const SensorParams sensor;
    const double bearing =
        sensor.sigma_bearing_rad * sensor.sigma_bearing_rad + 0.0004 + 0.01 / (ground * ground);
    ASSERT_EQ(match.count, 2);
    EXPECT_NEAR(1 / match.rows[0].information, bearing, 1e-12);
    EXPECT_NEAR(
        1 / match.rows[1].information,
        sensor.sigma_range_m * sensor.sigma_range_m + 0.01 * ground * ground / (z[2] * z[2]),
        1e-12);
}

TEST(LikelihoodTest, AMarkerThatTheMapDoesNotKnowSaysNothing) {
    const Sighting sighting{{0.1, kNan, kNan}, {kNan, kNan, kNan}, 77, -1};
    const SensorParams as_usual;
    EXPECT_EQ(view_of(sighting, as_usual, kYard, kYardSite).measured, 0);
}

TEST(LikelihoodTest, TheDerivativesAreThoseOfTheFittedComponents) {
    SensorParams sensor;
    sensor.x_m = 0.4;
    sensor.y_m = -0.3;
    sensor.yaw_rad = 1;
    const Marker& marker = kYard.markers()[7];
    const Vector<double, 3> z = view(kInYard, marker, sensor);
    const Match match = explained(z, 7, kInYard, 0, 0, sensor).match;
    const Mounted<MarkerSighting<double, Bearing<double>, Elevation<double>, Range<double>>, double>
        model{{{marker.x_m, marker.y_m, marker.z_m - sensor.z_m}},
              {sensor.x_m, sensor.y_m, sensor.yaw_rad}};
    const auto h = model.linearize(kInYard);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(match.rows[i].by_x, h.jacobian(i, kX), 1e-12);
        EXPECT_NEAR(match.rows[i].by_y, h.jacobian(i, kY), 1e-12);
        EXPECT_NEAR(match.rows[i].by_heading, h.jacobian(i, kHeading), 1e-12);
    }
}

TEST(LikelihoodTest, WhatIsNotNearAddsNothingThatCounts) {
    Draw draw(1);
    const SensorParams as_usual;
    for (int run = 0; run < 2000; ++run) {
        const auto id = static_cast<int>(draw.uniform(0, 10));
        const Vector<double, 3> n = draw.normal<double, 3>() * 8;
        Vector<double, 3> z = view(kInYard, kYard.markers()[static_cast<std::size_t>(id)]);
        z += Vector<double, 3>(0.02 * n[0], 0.02 * n[1], 0.1 * n[2]);
        z = only(z, run % 2 == 0, false, run % 3 != 0 || run % 2 != 0);
        const Sighting sighting{{z[0], z[1], z[2]}, {kNan, kNan, kNan}, id, -1};
        const View v = view_of(sighting, as_usual, kYard, kYardSite);
        const Frame robot(kInYard);
        const Pose<double> sensor = robot.out_of(v.place);
        const Point along = turned({robot.c, robot.s}, v.along);
        const Match match = held_against(*v.marker, v, robot, sensor, 1);
        if (!near(*v.marker, v, sensor, along, 1)) {
            EXPECT_LT(v.share * match.density(), 1e-3 * v.clutter);
        }
    }
}

}  // namespace
}  // namespace pilotage::test
