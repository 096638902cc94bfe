#pragma once
/// \file
/// Which markers a sighting may be of at all, told cheaply: a circle and a sector around the
/// sensor, wide enough for all that the gate lets in. What is within is judged exactly
/// (pairing.hpp).

#include <cmath>

#include "pilotage/held_sighting.hpp"

namespace pilotage {

/// The sensor in frame map, and how unsure its place is.
template <typename Scalar>
struct SensorPlace {
    Scalar x_m, y_m, direction_rad;
    Scalar position_variance;   ///< m^2, no less than that of any direction
    Scalar direction_variance;  ///< rad^2

    /// \param covariance of (x, y, heading)
    SensorPlace(const Pose<Scalar>& robot, const Matrix<Scalar, 3>& covariance,
                const SensorParams& sensor) noexcept
        : direction_rad(robot[kHeading] + Scalar(sensor.yaw_rad)),
          direction_variance(covariance(kHeading, kHeading)) {
        const Scalar c = std::cos(robot[kHeading]), s = std::sin(robot[kHeading]);
        const auto ahead = Scalar(sensor.x_m), left = Scalar(sensor.y_m);
        x_m = robot[kX] + c * ahead - s * left;
        y_m = robot[kY] + s * ahead + c * left;
        // (a + b)^2 <= 2 a^2 + 2 b^2 for a sum whose correlation is left out.
        position_variance = 2 * (covariance(kX, kX) + covariance(kY, kY)) +
                            2 * (ahead * ahead + left * left) * direction_variance;
    }
};

/// Where the marker of one sighting may stand.
template <typename Scalar>
class Reach {
   public:
    Reach(const SensorPlace<Scalar>& place, const Sighting& sighting, const SensorParams& sensor,
          const Policy& policy) noexcept
        : place_(&place), sighting_(&sighting), sensor_(&sensor) {
        const int components = measured_components(sighting);
        bearing_ = (components & 1 << kBearing) != 0;
        range_ = (components & 1 << kRange) != 0;
        int dof = 0;
        for (int bits = components; bits != 0; bits &= bits - 1) ++dof;
        gate_nis_ = dof == 0 ? Scalar(0) : Scalar(policy.gate_nis[dof - 1]);
        if (!bearing_) return;
        const Scalar to = place.direction_rad + Scalar(sighting.value[kBearing]);
        cos_ = std::cos(to);
        sin_ = std::sin(to);
        turn_variance_ =
            2 * place.direction_variance + sensor_variance(sighting, kBearing, sensor, Scalar(0));
    }

    /// No marker that the gate would let in is outside.
    [[nodiscard]] bool holds(const Marker& marker) const noexcept {
        const Scalar dx = Scalar(marker.x_m) - place_->x_m, dy = Scalar(marker.y_m) - place_->y_m;
        const Scalar ground_squared = dx * dx + dy * dy;
        const Scalar survey = Scalar(marker.sigma_m) * Scalar(marker.sigma_m);
        if (bearing_) {
            // |sin| of the innovation times the distance, against a bound on its sigma.
            const Scalar across = cos_ * dy - sin_ * dx, along = cos_ * dx + sin_ * dy;
            const Scalar most = gate_nis_ * (turn_variance_ * ground_squared +
                                             2 * place_->position_variance + survey);
            if (across * across > most || (along < 0 && most < ground_squared)) return false;
        }
        if (!range_) return true;
        const LineOfSight<Scalar> sight(
            {place_->x_m, place_->y_m, place_->direction_rad},
            {Scalar(marker.x_m), Scalar(marker.y_m), Scalar(marker.z_m - sensor_->z_m)});
        const Range<Scalar> range{Scalar(sensor_->range_scale), Scalar(sensor_->range_offset_m)};
        const Scalar predicted = range.predict(sight).value;
        const Scalar off = Scalar(sighting_->value[kRange]) - predicted;
        return off * off <=
               gate_nis_ * (sensor_variance(*sighting_, kRange, *sensor_, predicted) +
                            range.scale * range.scale * (place_->position_variance + survey));
    }

   private:
    const SensorPlace<Scalar>* place_;
    const Sighting* sighting_;
    const SensorParams* sensor_;
    bool bearing_, range_;
    Scalar gate_nis_;
    Scalar cos_ = 0, sin_ = 0;  // of the sight's direction in frame map
    Scalar turn_variance_ = 0;  // of the bearing, but for the sensor's place
};

}  // namespace pilotage
