#include <lcm/lcm.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "engine/config_file.hpp"
#include "node.hpp"
#include "options.hpp"

namespace {

volatile std::sig_atomic_t stop = 0;

void on_signal(int) {
    stop = 1;
}

void catch_signals() {
    struct sigaction action{};
    action.sa_handler = &on_signal;  // without SA_RESTART: a signal ends the wait for messages
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

/// LCM's receive buffer is the kernel's default unless the URL asks for more; bursts then get lost.
std::string with_large_buffer(std::string url) {
    if (url.empty()) {
        const char* set = std::getenv("LCM_DEFAULT_URL");
        url = set != nullptr && *set != '\0' ? set : "udpm://239.255.76.67:7667?ttl=0";
    }
    if (url.compare(0, 7, "udpm://") != 0 || url.find("recv_buf_size") != std::string::npos)
        return url;
    return url + (url.find('?') == std::string::npos ? "?" : "&") + "recv_buf_size=2097152";
}

int fail(int code, const std::string& what) {
    std::fprintf(stderr, "pilotage-node: %s\n", what.c_str());
    return code;
}

}  // namespace

int main(int argc, char** argv) {
    using namespace pilotage;
    std::setvbuf(stderr, nullptr, _IOLBF, 0);
    const Options options = parse_options(argc, argv);
    catch_signals();
    Config config;
    try {
        config = load_config(options.config);
        if (const std::string what = missing(config); !what.empty())
            throw ConfigError(options.config + ": " + what);
    } catch (const std::exception& error) {
        return fail(kBadConfiguration, error.what());
    }
    const std::string url = with_large_buffer(options.lcm_url);
    lcm_t* lcm = lcm_create(url.c_str());
    if (lcm == nullptr)
        return fail(kFailed,
                    "LCM cannot use " + url +
                        "\n  Is there a route for multicast? On one machine without a network:\n"
                        "    sudo ip link set lo multicast on\n"
                        "    sudo ip route add 224.0.0.0/4 dev lo");
    int result = kDone;
    try {
        Node node(config, lcm, options);
        std::fprintf(stderr, "pilotage-node: %s, %zu markers, %s\n", options.config.c_str(),
                     config.map.markers().size(), url.c_str());
        if (!node.run(stop)) result = fail(kFailed, "LCM failed while waiting for messages");
    } catch (const std::exception& error) {
        result = fail(kFailed, error.what());
    }
    lcm_destroy(lcm);
    return result;
}
