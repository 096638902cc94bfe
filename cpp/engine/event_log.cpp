#include "event_log.hpp"

#include <lcm/eventlog.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace pilotage {

namespace {

// An event: sync word, event number (8 bytes), time (8), length of channel (4) and data (4),
// channel, data.
constexpr std::uint8_t kSync[4] = {0xED, 0xA1, 0xDA, 0x01};
constexpr std::size_t kHeader = 28, kLongestChannel = 255, kWindow = std::size_t{1} << 20;

std::uint64_t big_endian(const std::uint8_t* p, int bytes) noexcept {
    std::uint64_t value = 0;
    for (int i = 0; i < bytes; ++i) value = value << 8 | p[i];
    return value;
}

bool is_sync(const std::uint8_t* p) noexcept {
    return std::memcmp(p, kSync, sizeof kSync) == 0;
}

/// As every name of a channel is.
bool is_text(const std::uint8_t* p, std::size_t size) noexcept {
    return std::all_of(p, p + size, [](std::uint8_t c) { return c >= ' ' && c <= '~'; });
}

[[noreturn]] void fail(const std::string& path, const char* what) {
    throw std::runtime_error(path + ": cannot be " + what + ": " + std::strerror(errno));
}

}  // namespace

LogReader::LogReader(const std::string& path)
    : path_(path), file_(std::fopen(path.c_str(), "rb"), &std::fclose), window_(kWindow) {
    if (!file_) fail(path_, "opened");
    std::fseek(file_.get(), 0, SEEK_END);
    size_ = std::ftell(file_.get());
    std::rewind(file_.get());
}

/// Whether that many unread bytes are in the window, after reading what is needed and there.
bool LogReader::available(std::size_t bytes) {
    while (end_ - begin_ < bytes) {
        std::memmove(window_.data(), window_.data() + begin_, end_ - begin_);
        offset_ += static_cast<std::int64_t>(begin_);
        end_ -= begin_;
        begin_ = 0;
        if (window_.size() < bytes) window_.resize(std::max(bytes, 2 * window_.size()));
        const std::size_t n =
            std::fread(window_.data() + end_, 1, window_.size() - end_, file_.get());
        if (std::ferror(file_.get()) != 0) fail(path_, "read");
        if (n == 0) return false;
        end_ += n;
    }
    return true;
}

/// Distance from the first unread byte to the next sync word at `from` or later; to the end without
/// one.
std::size_t LogReader::find_sync(std::size_t from) {
    for (; available(from + sizeof kSync); ++from)
        if (is_sync(window_.data() + begin_ + from)) return from;
    return end_ - begin_;
}

void LogReader::complain(const std::string& what) {
    damage_.push_back(path_ + ": damaged, " + what + " byte " +
                      std::to_string(offset_ + static_cast<std::int64_t>(begin_)));
}

void LogReader::skip_to(std::size_t next_event) {
    complain(std::to_string(next_event) + " bytes skipped from");
    begin_ += next_event;
}

/// Events are counted. A number that fits neither the one before nor the one after shows damage
/// that does no harm; where a program wrote only some of the events, numbers go on from any other.
void LogReader::follow_numbers(std::size_t whole) {
    const auto number_at = [&](std::size_t event) {
        return big_endian(window_.data() + begin_ + event + sizeof kSync, 8);
    };
    const std::uint64_t expected = number_++;
    if (number_at(0) == expected) return;
    if (available(whole + kHeader) && number_at(whole) == number_)
        return complain("a number overwritten in the event at");
    number_ = number_at(0) + 1;
}

bool LogReader::next(LogEvent& event) {
    while (available(1)) {
        if (!available(kHeader) || !is_sync(window_.data() + begin_)) {
            skip_to(find_sync(available(kHeader) ? 0 : kHeader));
            continue;
        }
        const std::uint8_t* header = window_.data() + begin_;
        const std::size_t channel = big_endian(header + 20, 4), data = big_endian(header + 24, 4);
        const std::size_t whole = kHeader + channel + data;
        const auto left = static_cast<std::size_t>(size_ - offset_) - begin_;
        if (channel == 0 || channel > kLongestChannel || whole > left || !available(whole) ||
            !is_text(window_.data() + begin_ + kHeader, channel)) {
            skip_to(find_sync(sizeof kSync));
            continue;
        }
        // Where no event follows, either this one's length is wrong and the next begins inside it,
        // or this one is whole and the damage comes after it.
        if (available(whole + sizeof kSync) && !is_sync(window_.data() + begin_ + whole))
            if (const std::size_t inside = find_sync(sizeof kSync); inside < whole) {
                skip_to(inside);
                continue;
            }
        follow_numbers(whole);
        const std::uint8_t* at = window_.data() + begin_;
        event.received = static_cast<std::int64_t>(big_endian(at + 12, 8));
        event.channel = {reinterpret_cast<const char*>(at + kHeader), channel};
        event.data = at + kHeader + channel;
        event.size = data;
        begin_ += whole;
        return true;
    }
    return false;
}

double LogReader::done() const noexcept {
    return size_ == 0 ? 1.0
                      : static_cast<double>(offset_ + static_cast<std::int64_t>(begin_)) /
                            static_cast<double>(size_);
}

LogWriter::LogWriter(const std::string& path)
    : path_(path), log_(lcm_eventlog_create(path.c_str(), "w")) {
    if (log_ == nullptr) fail(path_, "opened");
}

LogWriter::~LogWriter() {
    lcm_eventlog_destroy(log_);
}

void LogWriter::write(const LogEvent& event) {
    channel_.assign(event.channel);
    lcm_eventlog_event_t e{};
    e.timestamp = event.received;
    e.channel = channel_.data();
    e.channellen = static_cast<std::int32_t>(channel_.size());
    e.data = const_cast<std::uint8_t*>(event.data);  // liblcm only reads it
    e.datalen = static_cast<std::int32_t>(event.size);
    if (lcm_eventlog_write_event(log_, &e) != 0) fail(path_, "written");
}

void LogWriter::flush() {
    if (std::fflush(log_->f) != 0) fail(path_, "written");
}

}  // namespace pilotage
