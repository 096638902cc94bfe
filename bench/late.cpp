/// \file
/// A sighting that comes a second late: it is put in its place and everything after it is computed
/// again. `bench_late` prints medians, with and without marker frames in that second, and what a
/// sighting costs that comes in order.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include "pilotage/localizer.hpp"

namespace {

using namespace pilotage;

constexpr std::int64_t kPeriod = 10'000;  // 100 Hz
constexpr std::int64_t kSecond = 1'000'000;

struct Nobody final : Listener {
    void on_verdict(const Sample&, Verdict, Verdict) override {}
    void on_sighting(const SightingReport&) override {}
};

Params robot(int states) {
    Params params;
    params.initial.x_m = params.initial.y_m = params.initial.heading_rad = 0;
    if (states == kCalibratedStates) params.gyro_bias.sigma = params.distance_scale.sigma = 0.01;
    params.sensor_count = 1;
    return params;
}

/// Bearing and elevation of one of two markers, as a robot about the origin sees them.
Sample seen(std::int64_t utime, int seq) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const bool left = seq % 2 == 0;
    return Sample::make(
        utime, seq, Stream::sighting,
        Sighting{{left ? 0.32 : -0.32, 0.06, nan}, {nan, nan, nan}, left ? 1 : 2, -1});
}

/// Microseconds to take the late sighting, with so many marker frames in the second after it. The
/// robot is confirmed by as many before it, or searches for other poses in that second.
template <int N>
double late(int frames, int sightings_a_frame, bool confirmed) {
    std::vector<double> us;
    for (int round = 0; round < 201; ++round) {
        Nobody nobody;
        Localizer<double, N> localizer(robot(N), MarkerMap({{1, 6, 2, 0.4, 0}, {2, 6, -2, 0.4, 0}}),
                                       nobody);
        int seq = 0;
        for (std::int64_t t = 0; t <= 2 * kSecond; t += kPeriod) {
            localizer.add(Sample::make(t, seq, Stream::gyro, GyroRate{0.0}));
            const bool sees = t > kSecond || (confirmed && t > 0 && t < kSecond / 2);
            if (frames > 0 && sees && t % (kSecond / frames) == 0)
                for (int i = 0; i < sightings_a_frame; ++i)
                    localizer.add(seen(t - 1, seq * 10 + i));
            localizer.add(Sample::make(t, seq, Stream::motion, EncoderTicks{seq, seq}));
            ++seq;
        }
        const Sample sample = seen(kSecond - 1, 1'000'000);
        const auto start = std::chrono::steady_clock::now();
        localizer.add(sample);
        const std::chrono::duration<double, std::micro> taken =
            std::chrono::steady_clock::now() - start;
        us.push_back(taken.count());
    }
    std::nth_element(us.begin(), us.begin() + 100, us.end());
    return us[100];
}

/// Microseconds of a step of 10 ms: motion, and a sighting before it or none.
template <int N>
double step(bool sees) {
    Nobody nobody;
    Localizer<double, N> localizer(robot(N), MarkerMap({{1, 6, 2, 0.4, 0}, {2, 6, -2, 0.4, 0}}),
                                   nobody);
    std::vector<double> us;
    for (int seq = 0; seq < 4001; ++seq) {
        const std::int64_t t = seq * kPeriod;
        const auto start = std::chrono::steady_clock::now();
        localizer.add(Sample::make(t, seq, Stream::gyro, GyroRate{0.0}));
        if (sees && seq > 0) localizer.add(seen(t - 1, seq));
        localizer.add(Sample::make(t, seq, Stream::motion, EncoderTicks{seq, seq}));
        const std::chrono::duration<double, std::micro> taken =
            std::chrono::steady_clock::now() - start;
        us.push_back(taken.count());
    }
    std::nth_element(us.begin(), us.begin() + 2000, us.end());
    return us[2000];
}

template <int N>
void print() {
    constexpr int frames = 20;
    const double alone = late<N>(0, 0, true), among = late<N>(frames, 2, true),
                 unconfirmed = late<N>(frames, 2, false);
    std::printf("late%d_us %.2f\nlate%d_frame_us %.3f\n", N, alone, N, (among - alone) / frames);
    std::printf("late%d_unconfirmed_frame_us %.3f\n", N, (unconfirmed - alone) / frames);
    std::printf("in_order%d_us %.3f\n", N, step<N>(true) - step<N>(false));
}

}  // namespace

int main() {
    print<kPoseStates>();
    print<kCalibratedStates>();
}
