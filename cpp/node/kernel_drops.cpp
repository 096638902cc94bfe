#include "kernel_drops.hpp"

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <system_error>

namespace pilotage {

namespace {

/// Inodes of the sockets that this process has open.
std::set<std::string> own_sockets() {
    std::set<std::string> inodes;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", error)) {
        const std::string target = std::filesystem::read_symlink(entry.path(), error).string();
        const std::string prefix = "socket:[";
        if (target.compare(0, prefix.size(), prefix) == 0)
            inodes.insert(target.substr(prefix.size(), target.size() - prefix.size() - 1));
    }
    return inodes;
}

}  // namespace

std::int64_t kernel_drops() {
    const std::set<std::string> own = own_sockets();
    std::int64_t drops = 0;
    std::ifstream table("/proc/net/udp");
    std::string line, field, inode;
    std::getline(table, line);  // the heading
    while (std::getline(table, line)) {
        // sl local rem st queues tr:when retrnsmt uid timeout inode ref pointer drops
        std::istringstream fields(line);
        for (int i = 0; fields >> field; ++i)
            if (i == 9) inode = field;
        if (own.count(inode) != 0) drops += std::stoll(field);
    }
    return drops;
}

}  // namespace pilotage
