#include "options.hpp"

#include <getopt.h>

#include <cstdio>
#include <cstdlib>

namespace pilotage {

namespace {

constexpr const char* kHelp =
    R"(pilotage-node: localizes a robot on surveyed markers, over LCM

  pilotage-node --config robot.yaml [--lcm-url URL] [--record run.lcmlog] [--checkpoint FILE]

Takes encoders_t, gyro_t or velocity_t and marker_frame_t; publishes pose_t and odometry_t on every
motion sample, marker_report_t for every sighting, status_t once a second, and pose_jump_t where the
pose jumps. Runs until SIGINT or SIGTERM.

  -c, --config FILE      configuration (YAML)
  -l, --lcm-url URL      as in LCM_DEFAULT_URL, for instance udpm://239.255.76.67:7667?ttl=1
  -r, --record FILE      keep what was received and published; `pilotage replay FILE` repeats the
                         run exactly
  -k, --checkpoint FILE  begin with the pose kept in FILE, as a hypothesis, and keep the pose there
  -v, --version          print the version
  -h, --help             print this

Example:
  pilotage-node --config robot.yaml --record /var/log/robot/today.lcmlog --checkpoint /var/lib/robot/pose

Exit status: 0 ended by a signal, 1 the network or the recording failed, 2 bad configuration or options.
)";

}  // namespace

Options parse_options(int argc, char** argv) {
    static const option known[] = {{"config", required_argument, nullptr, 'c'},
                                   {"lcm-url", required_argument, nullptr, 'l'},
                                   {"record", required_argument, nullptr, 'r'},
                                   {"checkpoint", required_argument, nullptr, 'k'},
                                   {"version", no_argument, nullptr, 'v'},
                                   {"help", no_argument, nullptr, 'h'},
                                   {nullptr, 0, nullptr, 0}};
    Options options;
    int choice = 0;
    while ((choice = getopt_long(argc, argv, "c:l:r:k:vh", known, nullptr)) != -1) {
        switch (choice) {
            case 'c':
                options.config = optarg;
                break;
            case 'l':
                options.lcm_url = optarg;
                break;
            case 'r':
                options.record = optarg;
                break;
            case 'k':
                options.checkpoint = optarg;
                break;
            case 'v':
                std::puts("pilotage-node " PILOTAGE_VERSION);
                std::exit(kDone);
            case 'h':
                std::fputs(kHelp, stdout);
                std::exit(kDone);
            default:
                std::fputs("see pilotage-node --help\n", stderr);
                std::exit(kBadConfiguration);
        }
    }
    if (optind < argc) {
        std::fprintf(stderr, "pilotage-node: unknown argument '%s'; see pilotage-node --help\n",
                     argv[optind]);
        std::exit(kBadConfiguration);
    }
    if (options.config.empty()) {
        std::fputs("pilotage-node: --config FILE is missing; see pilotage-node --help\n", stderr);
        std::exit(kBadConfiguration);
    }
    return options;
}

}  // namespace pilotage
