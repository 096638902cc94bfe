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

/// Where each event begins, and the end.
std::vector<std::size_t> borders(const std::vector<Event>& events) {
    std::vector<std::size_t> at{0};
    for (const Event& e : events) at.push_back(at.back() + 28 + e.channel.size() + e.data.size());
    return at;
}

/// Whether a byte of an event is one that the reader can check: not its time nor its data.
bool is_checked(std::size_t byte, const Event& event) {
    return byte < 12 || (byte >= 20 && byte < 28 + event.channel.size());
}

/// Three bytes overwritten anywhere cost the event that they are in, and nothing else. What they
/// break of the file's own is told with its place; numbers in a message nobody can check.
TEST(DamagedLogTest, LosesNoMoreThanTheEventThatIsDamaged) {
    const Folder folder;
    const std::vector<Event> events = some_events(7);
    write(folder.path("whole"), events);
    const std::string bytes = folder.read("whole");
    const std::vector<std::size_t> begin = borders(events);
    ASSERT_EQ(begin.back(), bytes.size());
    for (std::size_t at = 0; at + 3 <= bytes.size(); ++at) {
        SCOPED_TRACE("bytes overwritten from " + std::to_string(at));
        std::string damaged = bytes;
        damaged.replace(at, 3, 3, "\x00\x7f\xff"[at % 3]);
        const Content content = read(folder.write("damaged", damaged));
        std::size_t hit = 0, first = events.size();
        bool told = false;
        for (std::size_t i = 0; i < events.size(); ++i) {
            if (at + 3 <= begin[i] || at >= begin[i + 1]) {
                EXPECT_EQ(std::count(content.events.begin(), content.events.end(), events[i]), 1);
                continue;
            }
            ++hit;
            first = std::min(first, i);
            for (std::size_t k = std::max(at, begin[i]); k < std::min(at + 3, begin[i + 1]); ++k)
                told |= damaged[k] != bytes[k] && is_checked(k - begin[i], events[i]) &&
                        i + 1 < events.size();  // the last one's number is compared with no other
        }
        EXPECT_GE(intact(events, content), events.size() - hit);
        EXPECT_LE(content.events.size(), events.size());
        EXPECT_TRUE(!told || !content.damage.empty());
        for (const std::string& line : content.damage) {
            EXPECT_EQ(line.find(folder.path("damaged") + ": damaged, "), 0U) << line;
            const std::size_t place = std::stoul(line.substr(line.rfind(' ')));
            EXPECT_GE(place, begin[first]) << line;
            EXPECT_LE(place, at + 2) << line;
        }
        if (::testing::Test::HasFailure()) return;
    }
}

TEST(DamagedLogTest, NumbersOfEventsMayGoOnFromAnyOther) {
    const Folder folder;
    write(folder.path("whole"), some_events(60));
    const std::string bytes = folder.read("whole");
    const std::size_t third = bytes.find("\xed\xa1\xda\x01", bytes.size() / 3);
    const std::size_t half = bytes.find("\xed\xa1\xda\x01", bytes.size() / 2);
    const Content content = read(folder.write("part", bytes.substr(0, third) + bytes.substr(half)));
    EXPECT_TRUE(content.damage.empty()) << content.damage[0];
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
