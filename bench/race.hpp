#pragma once
/// \file
/// Times contenders in turns of a few microseconds each, so that all of them meet the same clock,
/// the same neighbours and the same caches, and compares them round by round.

#include <algorithm>
#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace bench {

struct Contender {
    std::string name;
    std::function<void()> prepare;  ///< before every turn, not timed
    std::function<void()> turn;     ///< `steps` steps
    std::vector<double> ns = {};    ///< per step, one entry a round
};

inline void race(std::vector<Contender>& contenders, int steps, int rounds) {
    using Clock = std::chrono::steady_clock;
    for (int round = 0; round < rounds; ++round)
        for (Contender& c : contenders) {
            c.prepare();
            const auto start = Clock::now();
            c.turn();
            const std::chrono::duration<double, std::nano> elapsed = Clock::now() - start;
            c.ns.push_back(elapsed.count() / steps);
        }
}

[[nodiscard]] inline double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace bench
