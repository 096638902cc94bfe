#include "support/engines.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace pilotage::test {

namespace {

void expect_sound(const pose_t& pose) {
    for (const double v : {pose.x, pose.y, pose.heading, pose.v, pose.omega})
        EXPECT_TRUE(std::isfinite(v)) << "in a pose";
    for (const double v : pose.covariance) EXPECT_TRUE(std::isfinite(v)) << "in a covariance";
    EXPECT_LE(std::abs(pose.heading), 3.14159265358979324) << "heading is in (-pi, pi]";
    for (const int diagonal : {0, 4, 8}) EXPECT_GE(pose.covariance[diagonal], 0);
}

/// NaN stands only where the message says so.
void expect_sound(const marker_report_t& report) {
    const bool judged = report.accepted || report.reason == "gate" || report.reason == "numeric";
    EXPECT_EQ(report.accepted, report.reason.empty());
    EXPECT_EQ(std::isnan(report.nis), !judged) << report.reason;
    int finite = 0;
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(std::isnan(report.innovation[i]), std::isnan(report.sigma[i]));
        finite += !std::isnan(report.innovation[i]);
    }
    EXPECT_EQ(finite, judged ? report.dof : 0) << report.reason;
    EXPECT_GE(report.weight, 0);
    EXPECT_LE(report.weight, 1);
    EXPECT_EQ(report.weight > 0, bool(report.accepted)) << report.reason;
}

void expect_sound(const status_t& status) {
    EXPECT_EQ(status.n_inputs, static_cast<int>(status.inputs.size()));
    EXPECT_FALSE(status.version.empty());
    for (const input_status_t& input : status.inputs) {
        std::int64_t sum = input.fused + input.pending;
        for (const reason_count_t& r : input.rejected) {
            EXPECT_GT(r.count, 0) << r.reason;
            sum += r.count;
        }
        EXPECT_EQ(input.received, sum) << input.channel;
        EXPECT_GE(input.pending, 0) << input.channel;
        EXPECT_FALSE(std::isinf(input.rate_hz)) << input.channel;
        EXPECT_FALSE(std::isinf(input.age_s)) << input.channel;
    }
}

void expect_sound(const odometry_t& o) {
    for (const double v : {o.x, o.y, o.heading, o.v, o.omega}) EXPECT_TRUE(std::isfinite(v));
}

void expect_sound(const pose_jump_t& jump) {
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(std::isfinite(jump.before[i] + jump.after[i]));
    EXPECT_TRUE(jump.cause == "correction" || jump.cause == "reset" || jump.cause == "clock");
}

template <typename Message>
void take(std::vector<Message>& messages, const std::uint8_t* data, std::size_t size) {
    Message message;
    ASSERT_EQ(message.decode(data, 0, static_cast<int>(size)), static_cast<int>(size));
    expect_sound(message);
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
        }
    }
}

void Bench::wait(std::int64_t until) {
    for (; next_tick_ <= until; next_tick_ += 1'000'000) engine_.tick(next_tick_, 0);
}

void Bench::message(const std::string& channel, const std::uint8_t* data, std::size_t size) {
    if (channel == "POSE") return take(poses, data, size);
    if (channel == "MARKER_REPORT") return take(reports, data, size);
    if (channel == "STATUS") return take(statuses, data, size);
    if (channel == "ODOMETRY") return take(odometry, data, size);
    if (channel == "POSE_JUMP") return take(jumps, data, size);
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
