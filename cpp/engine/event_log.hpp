#pragma once
/// \file
/// LCM log files.

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

struct _lcm_eventlog_t;

namespace pilotage {

/// One message of a log; the views are valid until the next one is read.
struct LogEvent {
    std::int64_t received = 0;  ///< us
    std::string_view channel;
    const std::uint8_t* data = nullptr;
    std::size_t size = 0;
};

/// Reads a log to its end, over damaged places, which it counts and names. Not liblcm's reader,
/// which ends in silence at the first of them and allocates for every event.
class LogReader {
   public:
    /// \throws std::runtime_error if the file cannot be opened
    explicit LogReader(const std::string& path);

    /// False at the end. \throws std::runtime_error if the file cannot be read
    bool next(LogEvent& event);

    /// The part of the file that is read, from 0 to 1.
    [[nodiscard]] double done() const noexcept;

    /// A line for each damaged place so far.
    [[nodiscard]] const std::vector<std::string>& damage() const noexcept { return damage_; }

   private:
    [[nodiscard]] bool available(std::size_t bytes);
    [[nodiscard]] std::size_t find_sync(std::size_t from);
    void skip_to(std::size_t next_event);
    void follow_numbers(std::size_t whole);
    void complain(const std::string& what);

    std::string path_;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
    std::vector<std::uint8_t> window_;    // part of the file from offset_ on
    std::size_t begin_ = 0, end_ = 0;     // of what is unread in it
    std::int64_t offset_ = 0, size_ = 0;  // of the window in the file, of the file [bytes]
    std::uint64_t number_ = 0;            // that the next event should have
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
