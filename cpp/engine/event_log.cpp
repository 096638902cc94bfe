#include "event_log.hpp"

#include <lcm/eventlog.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace pilotage {

namespace {

lcm_eventlog_t* open(const std::string& path, const char* mode) {
    lcm_eventlog_t* log = lcm_eventlog_create(path.c_str(), mode);
    if (log == nullptr) throw std::runtime_error(path + ": cannot be opened: " + std::strerror(errno));
    return log;
}

}  // namespace

LogReader::LogReader(const std::string& path) : path_(path), log_(open(path, "r")) {
    std::setvbuf(log_->f, nullptr, _IOFBF, std::size_t{1} << 18);
    std::fseek(log_->f, 0, SEEK_END);
    size_ = std::ftell(log_->f);
    std::rewind(log_->f);
}

LogReader::~LogReader() {
    if (event_ != nullptr) lcm_eventlog_free_event(event_);
    lcm_eventlog_destroy(log_);
}

bool LogReader::next(LogEvent& event) {
    if (event_ != nullptr) lcm_eventlog_free_event(event_);
    while (true) {
        const std::int64_t before = std::ftell(log_->f);
        if (before >= size_) {
            event_ = nullptr;
            return false;
        }
        event_ = lcm_eventlog_read_next_event(log_);
        const std::int64_t after = std::ftell(log_->f);
        if (event_ == nullptr) {
            // liblcm stops in the middle of a broken event; reading on looks for the next sync word.
            damage_.push_back(path_ + ": damaged near byte " + std::to_string(before) +
                              (after >= size_ ? ": the rest of the file has no whole event" : ""));
            if (after >= size_) return false;
            continue;
        }
        const std::int64_t whole = 28 + event_->channellen + event_->datalen;
        if (after - before > whole)
            damage_.push_back(path_ + ": " + std::to_string(after - before - whole) +
                              " bytes skipped near byte " + std::to_string(before) + ", they hold no event");
        event.received = event_->timestamp;
        event.channel = {event_->channel, static_cast<std::size_t>(event_->channellen)};
        event.data = static_cast<const std::uint8_t*>(event_->data);
        event.size = static_cast<std::size_t>(event_->datalen);
        return true;
    }
}

double LogReader::done() const noexcept {
    return size_ == 0 ? 1.0 : static_cast<double>(std::ftell(log_->f)) / static_cast<double>(size_);
}

LogWriter::LogWriter(const std::string& path) : path_(path), log_(open(path, "w")) {}

LogWriter::~LogWriter() { lcm_eventlog_destroy(log_); }

void LogWriter::write(const LogEvent& event) {
    channel_.assign(event.channel);
    lcm_eventlog_event_t e{};
    e.timestamp = event.received;
    e.channel = channel_.data();
    e.channellen = static_cast<std::int32_t>(channel_.size());
    e.data = const_cast<std::uint8_t*>(event.data);  // liblcm only reads it
    e.datalen = static_cast<std::int32_t>(event.size);
    if (lcm_eventlog_write_event(log_, &e) != 0)
        throw std::runtime_error(path_ + ": cannot be written: " + std::strerror(errno));
}

void LogWriter::flush() {
    if (std::fflush(log_->f) != 0)
        throw std::runtime_error(path_ + ": cannot be written: " + std::strerror(errno));
}

}  // namespace pilotage
