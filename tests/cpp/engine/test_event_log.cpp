// LCM log files: written as liblcm reads them, and read back.

#include "engine/event_log.hpp"

#include <gtest/gtest.h>
#include <lcm/eventlog.h>

#include <limits>
#include <stdexcept>

#include "support/event_logs.hpp"
#include "support/files.hpp"

namespace pilotage::test {
namespace {

TEST(EventLogTest, ReadsBackWhatItWrote) {
    const Folder folder;
    std::vector<Event> events = some_events(500);
    events.push_back({std::numeric_limits<std::int64_t>::min(), "X", ""});
    events.push_back({std::numeric_limits<std::int64_t>::max(), std::string(63, 'Y'), "z"});
    events.push_back({0, "BIG", std::string(3'000'000, 'b')});  // beyond the reader's window
    events.push_back({1, "LAST", "end"});
    write(folder.path("a.lcmlog"), events);
    const Content content = read(folder.path("a.lcmlog"));
    EXPECT_TRUE(content.events == events);
    EXPECT_TRUE(content.damage.empty());
}

TEST(EventLogTest, IsReadByLiblcm) {
    const Folder folder;
    const std::vector<Event> events = some_events(100);
    write(folder.path("a.lcmlog"), events);
    lcm_eventlog_t* log = lcm_eventlog_create(folder.path("a.lcmlog").c_str(), "r");
    ASSERT_NE(log, nullptr);
    std::vector<Event> back;
    while (lcm_eventlog_event_t* e = lcm_eventlog_read_next_event(log)) {
        EXPECT_EQ(e->eventnum, static_cast<std::int64_t>(back.size()));
        back.push_back(
            {e->timestamp, e->channel,
             std::string(static_cast<const char*>(e->data), static_cast<std::size_t>(e->datalen))});
        lcm_eventlog_free_event(e);
    }
    lcm_eventlog_destroy(log);
    EXPECT_TRUE(back == events);
}

TEST(EventLogTest, AnEmptyFileHoldsNothing) {
    const Folder folder;
    const Content content = read(folder.write("empty", ""));
    EXPECT_TRUE(content.events.empty());
    EXPECT_TRUE(content.damage.empty());
}

TEST(EventLogTest, NamesAFileThatCannotBeOpened) {
    const Folder folder;
    EXPECT_EQ(complaint<std::runtime_error>([&] { LogReader(folder.path("none")); }),
              folder.path("none") + ": cannot be opened: No such file or directory");
    EXPECT_NE(complaint<std::runtime_error>([&] { LogWriter(folder.path("no/such")); }), "");
    EXPECT_NE(complaint<std::runtime_error>([&] { (void)read(folder.path("")); }), "")
        << "a folder";
}

TEST(EventLogTest, NamesAFullDisk) {
    if (!std::filesystem::exists("/dev/full")) return;
    EXPECT_EQ(complaint<std::runtime_error>([] { write("/dev/full", some_events(1)); }),
              "/dev/full: cannot be written: No space left on device");
}

}  // namespace
}  // namespace pilotage::test
