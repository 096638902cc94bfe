#pragma once
/// \file
/// The work that every contender does: 64 steps of a drive among markers, the same on every
/// machine.

#include <array>
#include <cmath>
#include <random>

#include "pilotage/fuse_sighting.hpp"

namespace bench {

using namespace pilotage;

inline constexpr int kCases = 64;

using AnglesToMarker = MarkerSighting<double, Bearing<double>, Elevation<double>>;

struct Case {
    Vector<double, 6> x;  // before the step; the three-state filter has the first three
    Matrix<double, 6> p;
    Vector<double, 2> u;  // distance [m], turn [rad]
    Matrix<double, 2> gamma;
    Vector<double, 3> q;
    Vector<double, 6> q6;
    AnglesToMarker sighting;
    Vector<double, 2> z, variances;
    Sample sample;  // the same marker seen from the mounted sensor
};

/// What the localizer has besides.
struct Site {
    SensorParams sensor;
    Policy policy = Policy::make(sensor.fusion, sensor.gate_false_reject, sensor.student_t_dof);
    MarkerMap map;
};

/// A mower at 1 m/s and 50 Hz; markers 2 to 20 m away on all sides, 1 m below the camera.
[[nodiscard]] inline std::array<Case, kCases> make_cases(Site& site) {
    std::mt19937 random(1);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
    };
    site.sensor.x_m = 0.3;
    site.sensor.y_m = -0.1;
    site.sensor.z_m = 1;
    site.sensor.yaw_rad = 0.5;
    std::vector<Marker> markers;
    std::array<Case, kCases> cases;
    for (Case& c : cases) {
        c.x << uniform(-20, 20), uniform(-20, 20), uniform(-3.1, 3.1), uniform(-0.01, 0.01),
            uniform(0.95, 1.05), uniform(0.95, 1.05);
        const double sigmas[] = {0.2, 0.2, 0.05, 0.002, 0.02, 0.02};
        Matrix<double, 6> root;
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < 6; ++j) root(i, j) = (i == j ? 1 : uniform(-0.5, 0.5)) * sigmas[i];
        c.p = root * root.transpose();
        c.u << 0.02, uniform(-0.02, 0.02);
        c.gamma << 1e-6, 1e-7, 1e-7, 1e-7;
        c.q << 1e-8, 1e-8, 1e-9;
        c.q6 << c.q, 1e-12, 1e-12, 1e-12;
        const double distance = uniform(2, 20), direction = uniform(-3.14, 3.14);
        c.sighting.marker_above_sensor << c.x[kX] + distance * std::cos(direction),
            c.x[kY] + distance * std::sin(direction), -1;
        c.variances << 1e-4, 1e-4;
        const Vector<double, 2> noise(uniform(-0.02, 0.02), uniform(-0.02, 0.02));
        const auto seen_by = [&](const auto& model) -> Vector<double, 2> {
            const Vector<double, 2> z = model.linearize(c.x.head<3>()).value + noise;
            return {wrap(z[0]), z[1]};
        };
        c.z = seen_by(c.sighting);

        const auto id = static_cast<std::int32_t>(markers.size());
        const auto& at = c.sighting.marker_above_sensor;
        markers.push_back({id, at[0], at[1], 0, 0});
        const auto z = seen_by(Mounted<AnglesToMarker, double>{
            c.sighting, {site.sensor.x_m, site.sensor.y_m, site.sensor.yaw_rad}});
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        c.sample = Sample::make(id, id, Stream::sighting,
                                Sighting{{z[0], z[1], nan}, {nan, nan, nan}, id, 0});
    }
    site.map = MarkerMap(markers);
    return cases;
}

}  // namespace bench
