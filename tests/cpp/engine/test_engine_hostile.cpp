// A hundred thousand messages made up or mutated: nothing crashes, nothing that is published is
// NaN, and everything is counted. Bench checks each message that comes out, and the sums of each
// status.

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "support/engines.hpp"

namespace pilotage::test {
namespace {

/// Makes up messages, more often nearly right than not.
class Peer {
   public:
    explicit Peer(unsigned seed) : generator_(seed) {}

    [[nodiscard]] Bytes message() {
        Bytes bytes = anything();
        const int mutations = below(3) ? 0 : below(4);
        for (int i = 0; i < mutations && !bytes.empty(); ++i) mutate(bytes);
        return bytes;
    }

    [[nodiscard]] std::string channel() {
        static const std::string names[] = {"ENCODERS", "GYRO",       "MARKERS", "MARKERS",
                                            "VELOCITY", "POSE_RESET", "OTHER",   kTickChannel};
        return names[below(8)];
    }

    [[nodiscard]] std::int64_t time() {
        static const std::int64_t ends[] = {std::numeric_limits<std::int64_t>::min(), -1, 0,
                                            std::int64_t{1} << 60,
                                            std::numeric_limits<std::int64_t>::max()};
        if (below(200) == 0) return ends[below(5)];
        now_ += below(30'000);
        return now_ + (below(10) ? 0 : below(6'000'000) - 3'000'000);
    }

    [[nodiscard]] int below(int n) { return static_cast<int>(generator_() % std::uint64_t(n)); }

   private:
    [[nodiscard]] double number() {
        static const double ends[] = {NAN,   HUGE_VAL, -HUGE_VAL, 0.0,  -0.0, 5e-324,
                                      1e308, -1e308,   1e154,     1e-9, 1e7,  -1e7};
        if (below(6) == 0) return ends[below(12)];
        return (below(2'000'001) - 1'000'000) * 3e-6;
    }

    [[nodiscard]] marker_sighting_t sighting() {
        return {below(5) - 1,
                -1,
                number(),
                number(),
                2 * number(),
                below(4) ? NAN : number(),
                below(4) ? NAN : number(),
                below(4) ? NAN : number()};
    }

    [[nodiscard]] Bytes anything() {
        const auto seq = static_cast<std::int32_t>(generator_());
        switch (below(8)) {
            case 0:
                return Bytes(static_cast<std::size_t>(below(64)),
                             static_cast<std::uint8_t>(generator_()));
            case 1: {
                const std::vector<marker_sighting_t> some(static_cast<std::size_t>(below(4)),
                                                          sighting());
                return bytes_of(frame(time(), below(9) ? "camera" : "", some, seq));
            }
            case 2:
                return bytes_of(frame(time(), "camera", {sighting(), sighting()}, seq));
            case 3:
                return bytes_of(gyro(time(), number(), seq));
            case 4:
                return bytes_of(velocity(time(), number(), number()));
            case 5: {
                pose_reset_t m = reset(time(), number(), number(), number(), std::abs(number()));
                if (below(3) == 0) m.covariance[below(9)] = number();
                return bytes_of(m);
            }
            default: {
                ticks_ += below(40);
                const bool odd = below(50) == 0;
                return bytes_of(encoders(time(), odd ? std::int64_t(generator_()) : ticks_,
                                         ticks_ + below(9), seq));
            }
        }
    }

    void mutate(Bytes& bytes) {
        const auto at = static_cast<std::size_t>(below(static_cast<int>(bytes.size())));
        switch (below(4)) {
            case 0:
                bytes[at] = static_cast<std::uint8_t>(generator_());
                break;
            case 1:
                bytes[at] ^= static_cast<std::uint8_t>(1 << below(8));
                break;
            case 2:
                bytes.resize(at);
                break;
            default:
                bytes.insert(bytes.begin() + static_cast<long>(at), bytes[at]);
        }
    }

    std::mt19937_64 generator_;
    std::int64_t now_ = 0, ticks_ = 0;
};

constexpr const char* kEncoders = "motion: {heading: both}\n";
constexpr const char* kVelocity = "motion: {heading: gyro, source: velocity}\n";

void bombard(const std::string& motion, const std::string& more, unsigned seed, int messages,
             const std::string& fusion = "student_t") {
    Bench bench(motion + more + "sensors: {camera: {fusion: " + fusion + "}}\n", R"(
initial: {x_m: 0, y_m: 0, heading_rad: 0}
map: [{id: 1, x: 6, y: 2, z: 0.4}, {id: 2, x: 4, y: -4, sigma: 0.1}]
)");
    Peer peer(seed);
    for (int i = 0; i < messages; ++i) {
        bench.send_bytes(peer.channel(), peer.message(), peer.time());
        if (i % 1000 == 0) bench.engine().tick(peer.time(), i);
        if (::testing::Test::HasFailure()) FAIL() << "after message " << i << ", seed " << seed;
    }
    bench.engine().finish();
    bench.engine().tick(0, 0);
    for (const input_status_t& input : bench.statuses.back().inputs) {
        EXPECT_GT(input.received, messages / 30) << input.channel;
        EXPECT_EQ(input.pending, 0) << input.channel;
    }
    // A peer that soon sends its clock far ahead ends them early.
    EXPECT_GT(bench.poses.size(), static_cast<std::size_t>(messages / 5'000));
    EXPECT_GT(bench.reports.size(), 50U);
}

TEST(HostilePeerTest, IsSurvivedByThreeStates) {
    bombard(kEncoders, "history: {capacity: 200}\n", 1, 30'000);
    bombard(kVelocity, "history: {capacity: 200}\n", 2, 20'000);
}
TEST(HostilePeerTest, IsSurvivedBySixStates) {
    const std::string six =
        "calibration: {gyro_bias: {sigma: 0.01}, distance_scale: {walk: 0.1}}\n";
    bombard(kEncoders, "history: {capacity: 200}\n" + six, 3, 20'000);
    bombard(kVelocity, six, 4, 5'000);
}
TEST(HostilePeerTest, IsSurvivedUnderEveryTimePolicy) {
    for (const std::string policy : {"receive", "mapped"})
        bombard(kEncoders, "encoders: {time: " + policy + "}\ngyro: {time: " + policy + "}\n", 5,
                5'000);
}
TEST(HostilePeerTest, IsSurvivedWithAndWithoutGateFromManySeeds) {
    for (const std::string fusion : {"plain", "gate"})
        for (unsigned seed = 6; seed < 26; ++seed)
            bombard(kEncoders, "history: {window_s: 0.5, capacity: 100}\n", seed, 1'000, fusion);
}

}  // namespace
}  // namespace pilotage::test
