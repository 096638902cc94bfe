// Whatever stands in a file: its reader gives what it holds or an error of its own kind, and a
// configuration or a map that was accepted says the same when it is written and read again.

#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "engine/config_file.hpp"
#include "engine/recording.hpp"
#include "engine/text_table.hpp"
#include "progress.hpp"

namespace pilotage::test {
namespace {

[[noreturn]] void fail(const std::string& what) {
    std::fprintf(stderr, "%s\n", what.c_str());
    std::abort();
}

class MemoryFile {
   public:
    explicit MemoryFile(const std::string& content) : fd_(memfd_create("fuzz", 0)) {
        if (fd_ < 0 || ::write(fd_, content.data(), content.size()) < 0) fail("no file in memory");
    }
    ~MemoryFile() { ::close(fd_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    [[nodiscard]] std::string path() const { return "/proc/self/fd/" + std::to_string(fd_); }

   private:
    int fd_;
};

void read_log(const std::string& content) {
    constexpr std::size_t header = 28;
    const MemoryFile file(content);
    const Recording log = Recording::load(file.path());
    std::size_t bytes = 0;
    for (std::size_t i = 0; i < log.size(); ++i)
        bytes += header + log[i].channel.size() + log[i].size;
    if (bytes > content.size()) fail("more came out of the log than is in it");
    if (bytes < content.size() && log.damage().empty()) fail("bytes were skipped without a word");
}

void read_numbers(const std::string& content) {
    const MemoryFile file(content);
    try {
        if (read_table(file.path(), {0, 2}).size() % 2 != 0) fail("half a row came out of a table");
    } catch (const std::invalid_argument&) {
    }
}

void read_map(const std::string& content) {
    const MemoryFile file(content);
    try {
        const std::string text = to_yaml(load_map(file.path()));
        const MemoryFile again(text);
        if (to_yaml(load_map(again.path())) != text) fail("a map comes back changed:\n" + text);
    } catch (const ConfigError&) {
    }
}

void read_config(const std::string& content) {
    std::string text;
    try {
        text = to_yaml(parse_config(content, "fuzz", "/nowhere"));
    } catch (const ConfigError&) {
        return;
    }
    // What was accepted and written has to be accepted again: no error is caught here.
    if (to_yaml(parse_config(text, "written", "/nowhere")) != text)
        fail("a configuration comes back changed:\n" + text);
}

}  // namespace
}  // namespace pilotage::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace pilotage::test;
    static Progress files("files");
    if (size == 0) return 0;
    const std::string content(data + 1, data + size);
    switch (data[0]) {  // letters, so that examples can be written by hand
        case 'l':
            read_log(content);
            break;
        case 't':
            read_numbers(content);
            break;
        case 'm':
            read_map(content);
            break;
        case 'c':
            read_config(content);
            break;
        default:
            return -1;  // not worth keeping
    }
    files.add();
    return 0;
}
