#include "peer.hpp"

#include <limits>
#include <utility>

#include "engine/engine.hpp"

namespace pilotage::test {

namespace {

constexpr const char* kChannels[] = {"ENCODERS",      "GYRO",       "VELOCITY", "MARKERS",
                                     "OTHER_MARKERS", "POSE_RESET", "POSE",     kTickChannel,
                                     kSetupChannel,   "",           "\x01\xff", "REFERENCE",
                                     "FIX",           "WALLS",      "PIXELS"};

/// Sums of absurd numbers wrap instead of overflowing.
std::int64_t sum(std::int64_t a, std::int64_t b) noexcept {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) + static_cast<std::uint64_t>(b));
}

}  // namespace

const Action& Peer::next() {
    action_.kind = Action::Kind::nothing;
    switch (draws_.below(16)) {
        case 0:
        case 1:
            left_ = sum(left_, static_cast<std::int8_t>(draws_.byte()));
            right_ = sum(right_, static_cast<std::int8_t>(draws_.byte()));
            say("ENCODERS", encoders(time(), left_, right_, next_seq()));
            break;
        case 2:
            say("GYRO", gyro(time(), draws_.number(), next_seq()));
            break;
        case 3: {
            velocity_t m = velocity(time(), draws_.number(), draws_.number());
            m.seq = next_seq();
            say("VELOCITY", m);
            break;
        }
        case 4:
        case 5:
            say(draws_.below(4) == 0 ? "OTHER_MARKERS" : "MARKERS", some_frame());
            break;
        case 6:
            say("POSE_RESET", some_reset());
            break;
        case 7:
            action_.kind = Action::Kind::tick;
            action_.received = time();
            action_.drops = draws_.byte();
            break;
        case 8:
            say(kTickChannel, tick(time(), draws_.extreme()));
            break;
        case 9: {
            Bytes bytes(draws_.byte());
            for (std::uint8_t& b : bytes) b = draws_.byte();
            send(draws_.one_of(kChannels), std::move(bytes));
            break;
        }
        case 10:
            prepare_mishap();
            break;
        case 11:  // the same once more
            if (!action_.bytes.empty()) action_.kind = Action::Kind::message;
            break;
        case 12:
            left_ = draws_.extreme();
            right_ = draws_.extreme();
            say("ENCODERS", encoders(time(), left_, right_, next_seq()));
            break;
        case 13:
            seq_ = draws_.raw<std::int32_t>();
            break;
        case 14:
            delay_ = draws_.below(8) == 0 ? draws_.extreme() : 1000 * draws_.raw<std::int16_t>();
            break;
        default:
            measure_otherwise();
    }
    return action_;
}

std::int32_t Peer::next_seq() noexcept {
    return seq_ = seq_ == std::numeric_limits<std::int32_t>::max() ? 0 : seq_ + 1;
}

/// Mostly a little later than the one before, or the same; some late, some ahead, some absurd.
std::int64_t Peer::time() {
    const int kind = draws_.byte();
    if (kind < 200) return now_ = sum(now_, 250 * kind);
    if (kind < 230) return sum(now_, -100'000 * (kind - 199));
    if (kind < 240) return sum(now_, 100'000 * (kind - 229));
    if (kind < 246) return draws_.extreme();
    now_ = sum(now_, std::int64_t{1000} * draws_.raw<std::int32_t>());  // the clock is set
    return now_;
}

marker_frame_t Peer::some_frame() {
    static const char* const names[] = {"camera", "camera", "camera", "lidar",
                                        "",       "\xff\n", "sonar"};
    marker_frame_t m = frame(time(), draws_.one_of(names), {}, next_seq());
    m.n = draws_.below(5);
    for (int i = 0; i < m.n; ++i) {
        marker_sighting_t s{draws_.below(5) - 1, -1, NAN, NAN, NAN, NAN, NAN, NAN};
        double* const numbers[] = {&s.bearing,       &s.elevation,       &s.range,
                                   &s.sigma_bearing, &s.sigma_elevation, &s.sigma_range};
        const int given = draws_.byte();
        for (std::size_t k = 0; k < std::size(numbers); ++k)
            if (given >> k & 1) *numbers[k] = draws_.number();
        m.sightings.push_back(s);
    }
    return m;
}

pixel_frame_t Peer::some_pixels() {
    static const char* const names[] = {"film", "film", "film", "camera", ""};
    pixel_frame_t m = pixels(time(), draws_.one_of(names), {}, next_seq());
    m.n = draws_.below(5);
    for (int i = 0; i < m.n; ++i) {
        // Mostly in the image.
        const bool odd = draws_.below(8) == 0;
        const double u = odd ? draws_.number() : 3 * draws_.byte(), v = 2 * draws_.byte();
        pixel_observation_t o = spotted(draws_.below(5) - 1, u, v);
        if (draws_.below(4) == 0) o.sigma_u = draws_.number();
        if (draws_.below(4) == 0) o.sigma_v = draws_.number();
        m.observations.push_back(o);
    }
    return m;
}

/// What is of none of these: fixes, walls, pixels, truth.
void Peer::measure_otherwise() {
    static const char* const names[] = {"gps", "gps", "laser", "camera", ""};
    const std::int64_t utime = time();
    const char* sensor = draws_.one_of(names);
    switch (draws_.below(6)) {
        case 4:
            return say("PIXELS", some_pixels());
        case 0:
            return say("FIX", heading(utime, sensor, draws_.number(), draws_.number(), next_seq()));
        case 1: {
            position_fix_t m =
                position_fix(utime, sensor, draws_.number(), draws_.number(), NAN, next_seq());
            if (draws_.below(2) == 1)
                for (double& v : m.covariance) v = draws_.number();
            return say("FIX", m);
        }
        case 2: {
            pose_fix_t m = pose_fix(utime, sensor, draws_.number(), draws_.number(),
                                    draws_.number(), NAN, next_seq());
            if (draws_.below(2) == 1)
                for (double& v : m.covariance) v = draws_.number();
            return say("FIX", m);
        }
        case 3: {
            std::vector<double> angles, ranges;
            for (int i = draws_.below(4); i > 0; --i) {
                angles.push_back(draws_.number());
                ranges.push_back(draws_.number());
            }
            return say("WALLS",
                       wall_ranges(utime, "laser", angles, ranges, draws_.number(), next_seq()));
        }
        default:
            say("REFERENCE", reference(utime, draws_.number(), draws_.number(), draws_.number()));
    }
}

pose_reset_t Peer::some_reset() {
    pose_reset_t m = reset(time(), draws_.number(), draws_.number(), draws_.number());
    m.seq = next_seq();
    const int given = draws_.below(3);
    if (given == 1)
        for (const int i : {0, 4, 8}) m.covariance[i] = draws_.number();
    if (given == 2)
        for (double& v : m.covariance) v = draws_.number();
    return m;
}

/// Something happens to the next message on its way.
void Peer::prepare_mishap() {
    const int kind = draws_.below(5);
    if (kind == 0) {
        other_channel_ = draws_.one_of(kChannels);
        return;
    }
    damage_ = static_cast<Damage>(kind);
    damaged_at_ = draws_.byte();
    damage_value_ = draws_.byte();
}

void Peer::damage(Bytes& bytes) const {
    if (bytes.empty()) return;
    const std::size_t at = damaged_at_ % bytes.size();
    switch (damage_) {
        case Damage::none:
            break;
        case Damage::flipped:
            bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ 1 << damage_value_ % 8);
            break;
        case Damage::overwritten:
            bytes[at] = damage_value_;
            break;
        case Damage::cut:
            bytes.resize(at);
            break;
        case Damage::longer:
            bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at), damage_value_);
    }
}

template <typename Message>
void Peer::say(const char* channel, const Message& message) {
    send(channel, bytes_of(message));
}

void Peer::send(const char* channel, Bytes bytes) {
    damage(bytes);
    action_.kind = Action::Kind::message;
    action_.channel = other_channel_ != nullptr ? other_channel_ : channel;
    action_.bytes = std::move(bytes);
    action_.received = sum(now_, delay_);
    other_channel_ = nullptr;
    damage_ = Damage::none;
}

}  // namespace pilotage::test
