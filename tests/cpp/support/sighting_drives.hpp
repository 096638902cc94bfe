#pragma once
/// \file
/// A robot that drives among markers and sees some of them ten times a second: what a search for
/// its pose gets, and the truth.

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "pilotage/search/evidence.hpp"
#include "pilotage/search/pose_search.hpp"
#include "support/random.hpp"
#include "support/robots.hpp"

namespace pilotage::test {

/// Ten posts about a yard, as python/pilotage/simulate/worlds.py has them.
inline const MarkerMap kYard({{0, -8, -4, 0.5, 0},
                              {1, -4, -6, 0.5, 0},
                              {2, 1, -5, 0.5, 0},
                              {3, 5, -5, 0.5, 0},
                              {4, 6, 0, 0.5, 0},
                              {5, 5, 4, 0.5, 0},
                              {6, 0, 7, 0.5, 0},
                              {7, -5, 7, 0.5, 0},
                              {8, -9, 3, 0.5, 0},
                              {9, -1.5, 0.5, 0.5, 0}});
inline const Site kYardSite(kYard);
inline const Pose<double> kInYard(1, 2, 0.5);  ///< of a robot

/// How the robot sees.
struct Sight {
    bool bearing = true, elevation = false, range = false;
    bool ids = true;
    double outliers = 0;                 ///< half of another marker, half of nothing at all
    int least = 2, most = 4;             ///< markers a frame
    double field_rad = 2 * kPi<double>;  ///< of view, about straight ahead
};

class SightingDrive {
   public:
    static constexpr double kPeriodS = 0.1;

    SightingDrive(const MarkerMap& map, const Sight& sight, unsigned seed)
        : map_(map), sight_(sight), draw_(seed) {
        params_.sensor_count = 1;
        SensorParams& sensor = params_.sensors[0];
        sensor.x_m = 0.3;
        sensor.y_m = -0.1;
        sensor.z_m = 1.2;
        sensor.yaw_rad = 0.2;
        sensor.sigma_elevation_rad = 0.01;
        carry_off();
        speed_m_s_ = draw_.uniform(0.5, 1);
        turn_rad_s_ = draw_.uniform(-0.4, 0.4);
    }

    [[nodiscard]] const Params& params() const { return params_; }
    [[nodiscard]] const Pose<double>& truth() const { return truth_; }
    [[nodiscard]] const Pose<double>& odometry() const { return odometry_; }
    [[nodiscard]] const std::vector<Evidence>& newest_first() const { return evidence_; }

    /// To another place, unnoticed by odometry.
    void carry_off() {
        truth_ = {draw_.uniform(-8, 5), draw_.uniform(-5.5, 6.5), draw_.uniform(-3.14, 3.14)};
    }

    /// Drives on and sees a frame. \return the number of sightings
    int step() {
        const double distance = speed_m_s_ * kPeriodS, turn = turn_rad_s_ * kPeriodS;
        constexpr double distance_noise = 0.02, gyro_noise = 0.002, slip = 0.005;
        truth_ = after_arc(truth_, distance, turn);
        truth_[kHeading] = wrap(truth_[kHeading]);
        const Vector<double, 2> n = draw_.normal<double, 2>();
        const double m2 = distance_noise * distance_noise * distance;
        const double rad2 = gyro_noise * gyro_noise * kPeriodS + slip * slip * distance;
        odometry_ =
            after_arc(odometry_, distance + std::sqrt(m2) * n[0], turn + std::sqrt(rad2) * n[1]);
        odometry_[kHeading] = wrap(odometry_[kHeading]);
        drift_m2_ += m2;
        drift_rad2_ += rad2;
        return look();
    }

   private:
    int look() {
        std::vector<const Marker*> seen;
        for (const Marker& marker : map_.markers()) {
            const Vector<double, 3> z = view(truth_, marker, params_.sensors[0]);
            if (std::abs(z[0]) <= sight_.field_rad / 2 && z[2] > 0.8) seen.push_back(&marker);
        }
        const auto wanted = static_cast<std::size_t>(draw_.uniform(sight_.least, sight_.most + 1));
        while (seen.size() > wanted)
            seen.erase(seen.begin() + static_cast<long>(draw_.uniform(0, double(seen.size()))));
        std::vector<Evidence> frame;
        for (const Marker* marker : seen) frame.push_back(sighting_of(*marker));
        evidence_.insert(evidence_.begin(), frame.begin(), frame.end());
        evidence_.resize(std::min(evidence_.size(), std::size_t{Evidence::kMost}));
        return static_cast<int>(frame.size());
    }

    Evidence sighting_of(const Marker& of) {
        const SensorParams& sensor = params_.sensors[0];
        Vector<double, 3> z = view(truth_, of, sensor);
        const Vector<double, 3> n = draw_.normal<double, 3>();
        z += Vector<double, 3>(sensor.sigma_bearing_rad * n[0], sensor.sigma_elevation_rad * n[1],
                               sensor.sigma_range_m * n[2]);
        z[0] = wrap(z[0]);
        int id = of.id;
        if (draw_.uniform(0, 1) < sight_.outliers) {
            if (sight_.ids && draw_.uniform(0, 1) < 0.5)
                id = (id + 1 + static_cast<int>(draw_.uniform(0, 8.99))) % 10;
            else
                z = {draw_.uniform(-3.14, 3.14), draw_.uniform(-0.6, 0), draw_.uniform(1, 20)};
        }
        z = only(z, sight_.bearing, sight_.elevation, sight_.range);
        return {odometry_,   drift_m2_,
                drift_rad2_, {{z[0], z[1], z[2]}, {kNan, kNan, kNan}, sight_.ids ? id : -1, -1},
                0,           kNan};
    }

    MarkerMap map_;
    Sight sight_;
    Draw draw_;
    Params params_;
    Pose<double> truth_, odometry_{0, 0, 0};
    double drift_m2_ = 0, drift_rad2_ = 0, speed_m_s_, turn_rad_s_;
    std::vector<Evidence> evidence_;
};

/// Of a statistical test: as many as PILOTAGE_RUNS says, or the usual number.
[[nodiscard]] inline int runs_of(int usual) {
    const char* asked = std::getenv("PILOTAGE_RUNS");
    return asked != nullptr ? std::atoi(asked) : usual;
}

/// Within half a metre and 9 degrees, or within the stated covariance (chi-square of 3, 0.01 %).
[[nodiscard]] inline bool right(const Hypothesis& h, const Pose<double>& truth) {
    const Pose<double> off = minus(truth, h.pose);
    return (off.head<2>().norm() < 0.5 && std::abs(off[kHeading]) < 0.15) ||
           same(truth, h.pose, h.covariance, 21.1);
}

}  // namespace pilotage::test
