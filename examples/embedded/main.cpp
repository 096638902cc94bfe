/// The localizer on a microcontroller: no LCM, no files, no exceptions, single precision. Here a
/// robot drives a circle past two markers; on yours, encoder and camera interrupts fill the
/// samples. Build: see CMakeLists.txt beside this file.

#include <cmath>

#include "pilotage/localizer.hpp"

namespace {

using namespace pilotage;

constexpr double kStep_s = 0.01, kRadius_m = 3.0, kSpeed_m_s = 1.0, kTrack_m = 0.4, kTick_m = 1e-4;

/// Counts what became of the samples; a real robot would light a lamp.
class Counter final : public Listener {
   public:
    int fused = 0, rejected_sightings = 0;

   private:
    void on_verdict(const Sample&, Verdict, Verdict) override {}
    void on_sighting(const SightingReport& report) override {
        ++(rejected(report.verdict) ? rejected_sightings : fused);
    }
};

Params circle_params() {
    Params params;
    params.wheels = {kTick_m, kTick_m, kTrack_m, 5.0};
    params.motion.heading = HeadingSource::wheels;
    params.initial = {kRadius_m, 0.0, kPi<double> / 2, 0.1, 0.05};
    params.history = {0.2, 64};
    params.sensor_count = 1;
    return params;
}

/// What the robot's camera sees of a marker from the true pose at `angle` on the circle.
Sighting look(const Marker& marker, double angle) {
    const double dx = marker.x_m - kRadius_m * std::cos(angle),
                 dy = marker.y_m - kRadius_m * std::sin(angle);
    const double bearing = wrap(std::atan2(dy, dx) - (angle + kPi<double> / 2));
    return {{bearing, NAN, std::sqrt(dx * dx + dy * dy)}, {NAN, NAN, NAN}, marker.id, -1};
}

}  // namespace

int main() {
    const Marker markers[] = {{1, 0.0, 0.0, 0.0, 0.0}, {2, 6.0, 2.0, 0.0, 0.0}};
    Counter counter;
    Localizer<float, kPoseStates> localizer(circle_params(), MarkerMap({markers[0], markers[1]}),
                                            counter);
    double angle = 0;
    for (int i = 0; i < 2000; ++i) {
        const auto utime = static_cast<std::int64_t>(i * kStep_s * 1e6);
        angle = i * kStep_s * kSpeed_m_s / kRadius_m;
        const auto ticks = [&](double radius) { return std::llround(angle * radius / kTick_m); };
        localizer.add(Sample::make(
            utime, i, Stream::motion,
            EncoderTicks{ticks(kRadius_m - kTrack_m / 2), ticks(kRadius_m + kTrack_m / 2)}));
        if (i % 10 == 5)
            for (const Marker& marker : markers)
                localizer.add(Sample::make(utime, i, Stream::sighting, look(marker, angle), 0,
                                           static_cast<std::uint16_t>(marker.id)));
    }
    const Estimate estimate = localizer.estimate();
    const double error_m = std::hypot(estimate.pose[kX] - kRadius_m * std::cos(angle),
                                      estimate.pose[kY] - kRadius_m * std::sin(angle));
    // Zero if the pose is right and every sighting but the newest, which waits for motion, was
    // fused.
    return error_m < 0.01 && counter.fused >= 396 && counter.rejected_sightings == 0 ? 0 : 1;
}
