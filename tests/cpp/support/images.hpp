#pragma once
/// \file
/// A robot with a camera, and where it sees markers in its images.

#include <algorithm>
#include <vector>

#include "support/journeys.hpp"
#include "support/robots.hpp"

namespace pilotage::test {

/// Wide, half a pixel noisy, a metre up, turned aside and down and a little rolled.
[[nodiscard]] inline SensorParams camera_sensor() {
    SensorParams sensor;
    sensor.measures = Measures::pixels;
    sensor.x_m = 0.3;
    sensor.y_m = -0.1;
    sensor.z_m = 1;
    sensor.yaw_rad = 0.2;
    sensor.sigma_pixel = 0.5;
    sensor.camera = {
        {640, 480, 300, 305, 322, 238, {-0.05, 0.01, 0.001, -0.0005, 0, 0, 0, 0}}, 0.04, 0.1};
    return sensor;
}

inline const SensorParams kCamera = camera_sensor();

/// A marker in the level sensor frame, from a pose of the robot.
[[nodiscard]] inline Vector<double, 3> in_sensor(const Pose<double>& robot, const Marker& marker,
                                                 const SensorParams& sensor) {
    const Vector<double, 3> seen = view(robot, marker, sensor);
    const double ground = std::hypot(seen[2] * std::cos(seen[1]), 0.0);
    return {ground * std::cos(seen[0]), ground * std::sin(seen[0]), seen[2] * std::sin(seen[1])};
}

[[nodiscard]] inline Sample pixel_at(std::int64_t utime, std::int32_t id,
                                     const Vector<double, 2>& pixel, std::uint16_t index = 0,
                                     std::int32_t seq = 0) {
    Sample sample = sighting_at(utime, id, {pixel[0], pixel[1], kNan}, index);
    sample.seq = seq;
    return sample;
}

/// One image from a pose: the markers in it, with noise of `sigma_px`.
[[nodiscard]] inline std::vector<Sample> image_from(const Pose<double>& robot, const MarkerMap& map,
                                                    const SensorParams& sensor, std::int64_t utime,
                                                    std::int32_t seq, Draw& draw,
                                                    double sigma_px = 0, bool ids = true) {
    std::vector<Sample> samples;
    for (const Marker& marker : map.markers()) {
        Vector<double, 2> pixel = sensor.camera.project(in_sensor(robot, marker, sensor)).value;
        pixel += sigma_px * draw.normal<double, 2>();
        if (!sensor.camera.in_image(pixel)) continue;
        samples.push_back(pixel_at(utime, ids ? marker.id : kUnknownId, pixel,
                                   static_cast<std::uint16_t>(samples.size()), seq));
    }
    return samples;
}

/// Samples of a journey with ten images a second.
class FilmedJourney {
   public:
    FilmedJourney(const MarkerMap& map, const SensorParams& sensor)
        : journey(map, 5), map_(&map), sensor_(sensor) {
        journey.camera = false;
    }

    Journey journey;
    bool ids = true;
    double sigma_px = 0.5;

    std::vector<Sample> go(double seconds, double v_m_s, double omega_rad_s) {
        std::vector<Sample> samples;
        for (long i = std::lround(seconds * 10); i > 0; --i) {
            for (const Sample& s : journey.go(0.1, v_m_s, omega_rad_s)) samples.push_back(s);
            for (const Sample& s : image_from(journey.truth, *map_, sensor_, journey.utime,
                                              frames_++, draw_, sigma_px, ids))
                samples.push_back(s);
        }
        return samples;
    }

   private:
    const MarkerMap* map_;
    SensorParams sensor_;
    Draw draw_{11};
    std::int32_t frames_ = 0;
};

}  // namespace pilotage::test
