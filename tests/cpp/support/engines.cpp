#include "support/engines.hpp"

#include <algorithm>
#include <memory>

#include "support/soundness.hpp"

namespace pilotage::test {

namespace {

template <typename Message>
void take_message(std::vector<Message>& messages, const std::uint8_t* data, std::size_t size) {
    Message message;
    ASSERT_EQ(message.decode(data, 0, static_cast<int>(size)), static_cast<int>(size));
    EXPECT_EQ(flaw_in(message), "");
    EXPECT_EQ(message.seq, messages.empty() ? 0 : messages.back().seq + 1);
    messages.push_back(message);
}

}  // namespace

Bench::Bench(const std::string& more, const std::string& robot)
    : engine_(parse_config(robot + more, "bench", ""), *this) {}

void Bench::send_bytes(const std::string& channel, const Bytes& bytes, std::int64_t received) {
    // From memory of just this size, so that a sanitizer sees a byte read too many.
    const auto exact = std::make_unique<std::uint8_t[]>(bytes.size());
    std::copy(bytes.begin(), bytes.end(), exact.get());
    engine_.handle(channel, received, exact.get(), bytes.size());
}

void Bench::run(const std::vector<Sample>& samples) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const Sample& s = samples[i];
        const std::int64_t t = s.utime;
        wait(t);
        switch (s.stream) {
            case Stream::motion:
                send("ENCODERS", encoders(t, s.payload.ticks.left, s.payload.ticks.right, s.seq));
                break;
            case Stream::gyro:
                send("GYRO", gyro(t, s.payload.gyro.rate_rad_s, s.seq));
                break;
            case Stream::sighting: {
                std::vector<marker_sighting_t> sightings;
                for (; i < samples.size() && samples[i].stream == Stream::sighting &&
                       samples[i].utime == t;
                     ++i) {
                    const Sighting& marker = samples[i].payload.sighting;
                    sightings.push_back(
                        seen(marker.id, marker.value[0], marker.value[1], marker.value[2]));
                }
                --i;
                send("MARKERS", frame(t, "camera", sightings, s.seq));
                break;
            }
            case Stream::reset: {
                const double* pose = s.payload.reset.pose;
                send("POSE_RESET", reset(t, pose[0], pose[1], pose[2]));
                break;
            }
            case Stream::fix: {
                const double* value = s.payload.fix.value;
                send("FIX", pose_fix(t, "dock", value[0], value[1], value[2], NAN, s.seq));
                break;
            }
            case Stream::beam: {
                const Beam& beam = s.payload.beam;
                send("WALLS",
                     wall_ranges(t, "laser", {beam.angle_rad}, {beam.range_m}, NAN, s.seq));
                break;
            }
        }
    }
}

void Bench::wait(std::int64_t until) {
    for (; next_tick_ <= until; next_tick_ += 1'000'000) engine_.tick(next_tick_, 0);
}

void Bench::message(const std::string& channel, const std::uint8_t* data, std::size_t size) {
    if (channel == "POSE") return take_message(poses, data, size);
    if (channel == "MARKER_REPORT") return take_message(reports, data, size);
    if (channel == "STATUS") return take_message(statuses, data, size);
    if (channel == "ODOMETRY") return take_message(odometry, data, size);
    if (channel == "POSE_JUMP") return take_message(jumps, data, size);
    ADD_FAILURE() << "a message on channel " << channel;
}

input_status_t Bench::input(const std::string& channel, std::int64_t now) {
    engine_.tick(now, 0);
    for (const input_status_t& input : statuses.back().inputs)
        if (input.channel == channel) return input;
    ADD_FAILURE() << "no input on channel " << channel;
    return {};
}

std::int64_t count_of(const input_status_t& input, const std::string& reason) {
    for (const reason_count_t& r : input.rejected)
        if (r.reason == reason) return r.count;
    return 0;
}

}  // namespace pilotage::test
