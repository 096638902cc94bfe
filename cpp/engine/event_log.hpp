#pragma once
/// \file
/// LCM log files, through liblcm's own reader and writer.

#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

struct _lcm_eventlog_t;
struct _lcm_eventlog_event_t;

namespace pilotage {

/// One message of a log; the views are valid until the next one is read.
struct LogEvent {
    std::int64_t received = 0;  ///< us
    std::string_view channel;
    const std::uint8_t* data = nullptr;
    std::size_t size = 0;
};

/// Reads a log to its end, over damaged places, which it counts and names.
class LogReader {
   public:
    /// \throws std::runtime_error if the file cannot be opened
    explicit LogReader(const std::string& path);
    ~LogReader();
    LogReader(const LogReader&) = delete;
    LogReader& operator=(const LogReader&) = delete;

    /// False at the end.
    bool next(LogEvent& event);

    /// The part of the file that is read, from 0 to 1.
    [[nodiscard]] double done() const noexcept;

    /// A line for each damaged place so far.
    [[nodiscard]] const std::vector<std::string>& damage() const noexcept { return damage_; }

   private:
    std::string path_;
    _lcm_eventlog_t* log_;
    _lcm_eventlog_event_t* event_ = nullptr;
    std::int64_t size_ = 0;
    std::vector<std::string> damage_;
};

class LogWriter {
   public:
    /// \throws std::runtime_error if the file cannot be opened
    explicit LogWriter(const std::string& path);
    ~LogWriter();
    LogWriter(const LogWriter&) = delete;
    LogWriter& operator=(const LogWriter&) = delete;

    /// \throws std::runtime_error if it cannot be written, as when the disk is full
    void write(const LogEvent& event);
    /// Hands everything to the operating system. \throws std::runtime_error
    void flush();

   private:
    std::string path_;
    _lcm_eventlog_t* log_;
    std::string channel_;  // zero-terminated for liblcm
};

}  // namespace pilotage
