/// \file
/// Messages a second from an LCM log file through the engine: read, decode, fuse, encode.
/// `bench_engine CONFIG LOG` prints one line.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include "engine/config_file.hpp"
#include "engine/engine.hpp"
#include "engine/event_log.hpp"

namespace {

/// Takes the messages and looks at them no further.
struct Counter final : pilotage::EngineOutput {
    std::size_t bytes = 0;
    void message(const std::string&, const std::uint8_t*, std::size_t size) override {
        bytes += size;
    }
};

/// Messages of the log that are for the engine: what it passes over is not counted.
std::size_t count(const char* path, const pilotage::Config& config) {
    Counter output;
    const auto channels = pilotage::Engine(config, output).channels();
    pilotage::LogReader log(path);
    pilotage::LogEvent event;
    std::size_t messages = 0;
    while (log.next(event)) messages += channels.count(std::string(event.channel));
    return messages;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: bench_engine CONFIG LOG\n");
        return 2;
    }
    constexpr int kRounds = 9;
    const auto config = pilotage::load_config(argv[1]);
    std::vector<double> seconds;
    const std::size_t messages = count(argv[2], config);
    for (int round = 0; round < kRounds; ++round) {
        Counter output;
        const auto start = std::chrono::steady_clock::now();
        pilotage::Engine engine(config, output);
        pilotage::LogReader log(argv[2]);
        pilotage::LogEvent event;
        while (log.next(event))
            engine.handle(event.channel, event.received, event.data, event.size);
        engine.finish();
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        seconds.push_back(elapsed.count());
    }
    std::nth_element(seconds.begin(), seconds.begin() + kRounds / 2, seconds.end());
    std::printf("messages_per_s %.0f\n", static_cast<double>(messages) / seconds[kRounds / 2]);
}
