/// \file
/// A frame of one or two sightings without ids, on a map of ten markers: which markers they are of,
/// and the Student-t updates. `bench_association` prints medians.

#include <cstdio>
#include <random>

#include "pilotage/association.hpp"
#include "pilotage/fuse_sighting.hpp"
#include "race.hpp"

namespace {

using namespace pilotage;

constexpr int kFrames = 64;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct Frame {
    Ekf<double, 3> filter;
    Sample sightings[2];
};

/// Markers within 10 m of the origin, robots within 3 m that see bearing and range.
std::vector<Frame> make_frames(MarkerMap& map, const SensorParams& sensor) {
    std::mt19937 random(1);
    const auto uniform = [&](double most) {
        return most * (static_cast<double>(random()) / 2147483648.0 - 1);
    };
    std::vector<Marker> markers;
    for (int i = 0; i < 10; ++i) markers.push_back({i, uniform(10), uniform(10), 0.5, 0.01});
    map = MarkerMap(markers);
    std::vector<Frame> frames;
    for (int n = 0; n < kFrames; ++n) {
        const Pose<double> truth(uniform(3), uniform(3), uniform(3));
        const Pose<double> off(uniform(0.08), uniform(0.08), uniform(0.03));
        Frame frame{{truth + off, Pose<double>(0.0025, 0.0025, 0.0004).asDiagonal()}, {}};
        for (int k = 0; k < 2; ++k) {
            const Marker& m = markers[static_cast<std::size_t>((n + 5 * k) % 10)];
            const double dx = m.x_m - truth[kX], dy = m.y_m - truth[kY];
            const Sighting seen{
                {wrap(std::atan2(dy, dx) - truth[kHeading] + uniform(sensor.sigma_bearing_rad)),
                 kNan, std::hypot(dx, dy, m.z_m) + uniform(sensor.sigma_range_m)},
                {kNan, kNan, kNan},
                kUnknownId,
                -1};
            frame.sightings[k] =
                Sample::make(n, n, Stream::sighting, seen, 0, static_cast<std::uint16_t>(k));
        }
        frames.push_back(frame);
    }
    return frames;
}

}  // namespace

int main() {
    const SensorParams sensor;
    const Policy policy =
        Policy::make(sensor.fusion, sensor.gate_false_reject, sensor.student_t_dof);
    MarkerMap map;
    const std::vector<Frame> frames = make_frames(map, sensor);
    std::vector<Frame> work;
    Associator<double> associator;
    int fused = 0;
    const auto contender = [&](const char* name, int sightings) {
        return bench::Contender{
            name, [&] { work = frames; },
            [&, sightings] {
                for (Frame& frame : work) {
                    associator.begin_frame();
                    for (int k = 0; k < sightings; ++k)
                        associator.add(frame.sightings[k].payload.sighting);
                    associator.resolve(frame.filter.state(), frame.filter.covariance(), map, sensor,
                                       policy);
                    for (int k = 0; k < sightings; ++k) {
                        Sample& sample = frame.sightings[k];
                        sample.payload.sighting.id = associator[k].id;
                        fused += !rejected(
                            fuse_sighting(frame.filter, sample, map, sensor, policy).verdict);
                    }
                }
            }};
    };
    std::vector<bench::Contender> contenders{contender("one_ns", 1), contender("two_ns", 2)};
    constexpr int kRounds = 1000;
    bench::race(contenders, kFrames, kRounds);
    for (const auto& c : contenders) std::printf("%s %.0f\n", c.name.c_str(), bench::median(c.ns));
    std::printf("fused_share %.3f\n", fused / (3.0 * kFrames * kRounds));
}
