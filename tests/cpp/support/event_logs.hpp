#pragma once
/// \file
/// LCM log files to write and to read back.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "engine/event_log.hpp"

namespace pilotage::test {

struct Event {
    std::int64_t received;
    std::string channel;
    std::string data;
    friend bool operator==(const Event& a, const Event& b) {
        return a.received == b.received && a.channel == b.channel && a.data == b.data;
    }
};

/// Events of many sizes.
[[nodiscard]] inline std::vector<Event> some_events(int count) {
    std::vector<Event> events;
    for (int i = 0; i < count; ++i) {
        std::string data(static_cast<std::size_t>((i * 37) % 200), static_cast<char>('a' + i % 26));
        events.push_back({1'000'000 + i * 1000, "CHANNEL_" + std::to_string(i % 7), data});
    }
    return events;
}

inline void write(const std::string& path, const std::vector<Event>& events) {
    LogWriter writer(path);
    for (const Event& e : events)
        writer.write({e.received, e.channel, reinterpret_cast<const std::uint8_t*>(e.data.data()),
                      e.data.size()});
    writer.flush();
}

struct Content {
    std::vector<Event> events;
    std::vector<std::string> damage;
};

[[nodiscard]] inline Content read(const std::string& path) {
    Content content;
    LogReader reader(path);
    LogEvent event;
    while (reader.next(event))
        content.events.push_back(
            {event.received, std::string(event.channel),
             std::string(reinterpret_cast<const char*>(event.data), event.size)});
    EXPECT_EQ(reader.done(), 1.0);
    EXPECT_FALSE(reader.next(event)) << "the end stays the end";
    content.damage = reader.damage();
    return content;
}

}  // namespace pilotage::test
