/// \file
/// Encoder in, pose out: the time from publishing encoders_t to holding the answer, from the node
/// and from a bare echo in turns. Each has a port of its own, so that none is woken by the other's
/// messages. `bench_latency NODE_URL ECHO_URL` prints the two medians.

#include <lcm/lcm.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "pilotage/encoders_t.hpp"

namespace {

using Clock = std::chrono::steady_clock;

class Correspondent {
   public:
    Correspondent(const char* url, const char* answers) : lcm_(lcm_create(url)) {
        if (lcm_ != nullptr) lcm_subscribe(lcm_, answers, &Correspondent::answered, this);
    }

    [[nodiscard]] bool connected() const { return lcm_ != nullptr; }

    /// Sends and waits. \return microseconds, negative if no answer came within 0.2 s
    double ask() {
        message_.utime += 10'000;
        message_.left = message_.right += 10;
        ++message_.seq;
        message_.encode(bytes_, 0, sizeof bytes_);
        answered_ = false;
        const auto start = Clock::now();
        lcm_publish(lcm_, "ENCODERS", bytes_, static_cast<unsigned>(message_.getEncodedSize()));
        while (!answered_)
            if (lcm_handle_timeout(lcm_, 200) <= 0) return -1;
        return std::chrono::duration<double, std::micro>(end_ - start).count();
    }

   private:
    static void answered(const lcm_recv_buf_t*, const char*, void* self) {
        auto& me = *static_cast<Correspondent*>(self);
        me.end_ = Clock::now();
        me.answered_ = true;
    }

    lcm_t* lcm_;
    pilotage::encoders_t message_{};
    std::uint8_t bytes_[256];
    Clock::time_point end_;
    bool answered_ = false;
};

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2),
                     values.end());
    return values[values.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: bench_latency NODE_URL ECHO_URL\n");
        return 2;
    }
    Correspondent node(argv[1], "POSE"), echo(argv[2], "ECHO");
    if (!node.connected() || !echo.connected()) {
        std::fprintf(stderr, "bench_latency: no route for multicast\n");
        return 1;
    }
    for (Correspondent* c : {&node, &echo}) {
        int tries = 0;
        while (c->ask() < 0)  // until it has started
            if (++tries == 50) {
                std::fprintf(stderr, "bench_latency: no answer\n");
                return 1;
            }
    }
    constexpr int kRounds = 10'000;
    std::vector<double> by_node, by_echo;
    for (int i = 0; i < kRounds; ++i) {
        const double a = node.ask(), b = echo.ask();
        if (a < 0 || b < 0) continue;  // lost on the way
        by_node.push_back(a);
        by_echo.push_back(b);
    }
    std::printf("node_us %.2f\necho_us %.2f\nrounds %zu\n", median(by_node), median(by_echo),
                by_node.size());
}
