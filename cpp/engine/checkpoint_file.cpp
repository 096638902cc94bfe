#include "checkpoint_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "codecs.hpp"

namespace pilotage {

namespace {

constexpr std::size_t kCrcSize = 4;

/// CRC-32 as in zlib and Ethernet.
std::uint32_t crc32(const std::uint8_t* data, std::size_t size) noexcept {
    std::uint32_t crc = ~0U;
    for (std::size_t i = 0; i < size; ++i) {
        crc ^= data[i];
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0);
    }
    return ~crc;
}

[[noreturn]] void fail(const std::string& what) {
    throw std::runtime_error(what);
}

[[noreturn]] void fail_on(const std::string& path, const char* action) {
    fail(path + ": cannot " + action + ": " + std::strerror(errno));
}

/// Closes the file at the end of its scope.
class File {
   public:
    File(const std::string& path, int flags) : fd_(::open(path.c_str(), flags | O_CLOEXEC, 0644)) {}
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    ~File() {
        if (fd_ >= 0) ::close(fd_);
    }
    [[nodiscard]] int fd() const noexcept { return fd_; }

   private:
    int fd_;
};

}  // namespace

std::int64_t hash_of(const std::string& text) noexcept {
    std::uint64_t hash = 14695981039346656037ULL;
    for (const char c : text) hash = (hash ^ static_cast<std::uint8_t>(c)) * 1099511628211ULL;
    return static_cast<std::int64_t>(hash);
}

void fill(checkpoint_t& message, const Checkpoint& checkpoint) {
    message.utime = checkpoint.utime;
    message.left = checkpoint.ticks.left;
    message.right = checkpoint.ticks.right;
    message.n = checkpoint.states;
    message.state.assign(checkpoint.state.data(), checkpoint.state.data() + checkpoint.states);
    message.covariance.clear();
    for (int i = 0; i < checkpoint.states; ++i) {
        message.covariance.emplace_back();
        for (int j = 0; j < checkpoint.states; ++j)
            message.covariance.back().push_back(checkpoint.covariance(i, j));
    }
}

Checkpoint checkpoint_of(const checkpoint_t& message) {
    if (message.n != kPoseStates && message.n != kCalibratedStates)
        fail("has " + std::to_string(message.n) + " states");
    Checkpoint c;
    c.utime = message.utime;
    c.ticks = {message.left, message.right};
    c.states = message.n;
    for (int i = 0; i < c.states; ++i) {
        const auto row = static_cast<std::size_t>(i);
        c.state[i] = message.state[row];
        for (int j = 0; j < c.states; ++j)
            c.covariance(i, j) = message.covariance[row][static_cast<std::size_t>(j)];
    }
    return c;
}

Bytes pack(const checkpoint_t& message) {
    Bytes bytes;
    encode(message, bytes);
    const std::uint32_t crc = crc32(bytes.data(), bytes.size());
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes.push_back(static_cast<std::uint8_t>(crc >> shift));
    return bytes;
}

checkpoint_t unpack(const Bytes& bytes) {
    if (bytes.size() < sizeof(std::int64_t) + kCrcSize) fail("is too short");
    const std::size_t size = bytes.size() - kCrcSize;
    std::uint32_t stated = 0;
    for (std::size_t i = size; i < bytes.size(); ++i) stated = stated << 8 | bytes[i];
    if (stated != crc32(bytes.data(), size)) fail("is damaged: its CRC is wrong");
    checkpoint_t message;
    if (fingerprint_of(bytes.data(), size) != checkpoint_t::getHash() ||
        message.decode(bytes.data(), 0, static_cast<int>(size)) != static_cast<int>(size))
        fail("is of another version of this program");
    return message;
}

Bytes read_bytes(const std::string& path) {
    const File file(path, O_RDONLY);
    if (file.fd() < 0 && errno == ENOENT) return {};
    if (file.fd() < 0) fail(std::string("cannot be opened: ") + std::strerror(errno));
    Bytes bytes;
    std::uint8_t part[4096];
    for (;;) {
        const ssize_t got = ::read(file.fd(), part, sizeof part);
        if (got < 0) fail(std::string("cannot be read: ") + std::strerror(errno));
        if (got == 0) return bytes;
        bytes.insert(bytes.end(), part, part + got);
    }
}

void replace_file(const std::string& path, const Bytes& bytes) {
    const std::string fresh = path + ".new";
    {
        const File file(fresh, O_WRONLY | O_CREAT | O_TRUNC);
        if (file.fd() < 0) fail_on(fresh, "create");
        for (std::size_t done = 0; done < bytes.size();) {
            const ssize_t put = ::write(file.fd(), bytes.data() + done, bytes.size() - done);
            if (put < 0) fail_on(fresh, "write");
            done += static_cast<std::size_t>(put);
        }
        if (::fsync(file.fd()) != 0) fail_on(fresh, "write");
    }
    if (std::rename(fresh.c_str(), path.c_str()) != 0) fail_on(path, "replace");
    const std::size_t slash = path.rfind('/');
    const File folder(slash == std::string::npos ? "." : path.substr(0, slash + 1),
                      O_RDONLY | O_DIRECTORY);
    if (folder.fd() >= 0) (void)::fsync(folder.fd());  // so that the new name outlives a power cut
}

}  // namespace pilotage
