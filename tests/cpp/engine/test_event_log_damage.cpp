// A damaged log is read to its end: what is broken is named, everything else comes.

#include <gtest/gtest.h>

#include <algorithm>

#include "support/event_logs.hpp"
#include "support/files.hpp"

namespace pilotage::test {
namespace {

/// How many of the events that were written came back, all of them unchanged and in their order but
/// one.
std::size_t intact(const std::vector<Event>& events, const Content& content) {
    std::size_t found = 0, at = 0;
    for (const Event& e : content.events) {
        const auto next =
            std::find(events.begin() + static_cast<std::ptrdiff_t>(at), events.end(), e);
        if (next == events.end()) continue;
        at = static_cast<std::size_t>(next - events.begin()) + 1;
        ++found;
    }
    return found;
}

/// Three bytes overwritten anywhere cost the event that they are in, and what they break is told.
TEST(DamagedLogTest, LosesNoMoreThanTheEventThatIsDamaged) {
    const Folder folder;
    const std::vector<Event> events = some_events(7);
    write(folder.path("whole"), events);
    const std::string bytes = folder.read("whole");
    for (std::size_t at = 0; at + 3 <= bytes.size(); ++at) {
        std::string damaged = bytes;
        damaged.replace(at, 3, 3, "\x00\x7f\xff"[at % 3]);
        const Content content = read(folder.write("damaged", damaged));
        // Bytes at the border of two events are in both.
        ASSERT_GE(intact(events, content), events.size() - 2) << "at byte " << at;
        ASSERT_LE(content.events.size(), events.size()) << "at byte " << at;
        ASSERT_TRUE(content.events.size() == events.size() || !content.damage.empty())
            << "at byte " << at;
        for (const std::string& line : content.damage)
            ASSERT_EQ(line.find(folder.path("damaged") + ": "), 0U) << line;
    }
}

TEST(DamagedLogTest, ReadsEverythingBeforeAndAfterADamagedSyncWord) {
    const Folder folder;
    const std::vector<Event> events = some_events(60);
    write(folder.path("whole"), events);
    std::string bytes = folder.read("whole");
    const std::size_t middle = bytes.find("\xed\xa1\xda\x01", bytes.size() / 2);
    bytes.replace(middle, 3, "xxx");
    const Content content = read(folder.write("damaged", bytes));
    EXPECT_EQ(intact(events, content), 59U);
    ASSERT_EQ(content.damage.size(), 1U);
    EXPECT_NE(content.damage[0].find("from byte " + std::to_string(middle)), std::string::npos)
        << content.damage[0];
}

TEST(DamagedLogTest, CutAtAnyByteReadsAllThatIsWhole) {
    const Folder folder;
    const std::vector<Event> events = some_events(5);
    write(folder.path("whole"), events);
    const std::string bytes = folder.read("whole");
    std::size_t whole = 0, end = 0;
    for (std::size_t size = 0; size <= bytes.size(); ++size) {
        if (whole < events.size() &&
            size == end + 28 + events[whole].channel.size() + events[whole].data.size())
            end = size, ++whole;
        const Content content = read(folder.write("cut", bytes.substr(0, size)));
        ASSERT_EQ(content.events.size(), whole) << size << " bytes";
        ASSERT_EQ(content.damage.empty(), size == end) << size << " bytes";
    }
}

TEST(DamagedLogTest, ReservesNothingForALengthThatTheFileCannotHold) {
    const Folder folder;
    const std::vector<Event> events = some_events(10);
    write(folder.path("whole"), events);
    for (const std::size_t field : {20U, 24U})  // length of channel, of data
        for (const char high : {'\x7f', '\x80', '\xff'}) {
            std::string bytes = folder.read("whole");
            bytes.replace(field, 4, 4, high);
            const Content content = read(folder.write("damaged", bytes));
            EXPECT_EQ(intact(events, content), 9U);
            EXPECT_EQ(content.damage.size(), 1U);
        }
}

TEST(DamagedLogTest, AFileThatIsNoLogIsNamedInOneLine) {
    const Folder folder;
    const Content content = read(folder.write("robot.yaml", std::string(200'000, 'y')));
    EXPECT_TRUE(content.events.empty());
    EXPECT_EQ(content.damage.size(), 1U);
}

}  // namespace
}  // namespace pilotage::test
