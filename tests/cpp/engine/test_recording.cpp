// Messages in memory, in the order of their arrival.

#include "engine/recording.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "support/files.hpp"
#include "support/messages.hpp"

namespace pilotage::test {
namespace {

Recording some() {
    Recording recording;
    recording.add(30, "B", encoders(3, 1, 2));
    recording.add(10, "A", gyro(1, 0.5));
    recording.add(30, "A", gyro(4, 0.25));
    recording.add(20, "B", encoders(2, 0, 0));
    return recording;
}

TEST(RecordingTest, KeepsTheOrderOfAdding) {
    const Recording recording = some();
    ASSERT_EQ(recording.size(), 4U);
    EXPECT_EQ(recording[0].received, 30);
    EXPECT_EQ(recording[0].channel, "B");
    gyro_t message;
    const LogEvent event = recording[2];
    ASSERT_GT(message.decode(event.data, 0, static_cast<int>(event.size)), 0);
    EXPECT_EQ(message.rate, 0.25);
}

TEST(RecordingTest, SortsByArrivalAndKeepsTheOrderOfEquals) {
    Recording recording = some();
    recording.sort();
    const std::int64_t times[] = {10, 20, 30, 30};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(recording[i].received, times[i]);
    EXPECT_EQ(recording[2].channel, "B") << "added first";
    EXPECT_EQ(recording[3].channel, "A");
}

TEST(RecordingTest, SavesAndLoads) {
    const Folder folder;
    const Recording recording = some();
    recording.save(folder.path("run.lcmlog"));
    const Recording back = Recording::load(folder.path("run.lcmlog"));
    ASSERT_EQ(back.size(), recording.size());
    for (std::size_t i = 0; i < back.size(); ++i) {
        const LogEvent a = recording[i], b = back[i];
        EXPECT_EQ(a.received, b.received);
        EXPECT_EQ(a.channel, b.channel);
        EXPECT_EQ(Bytes(a.data, a.data + a.size), Bytes(b.data, b.data + b.size));
    }
    EXPECT_TRUE(back.damage().empty());
}

TEST(RecordingTest, LoadsOverDamageAndNamesIt) {
    const Folder folder;
    some().save(folder.path("run.lcmlog"));
    std::string bytes = folder.read("run.lcmlog");
    bytes.replace(0, 3, "xxx");
    const Recording back = Recording::load(folder.write("damaged.lcmlog", bytes));
    EXPECT_EQ(back.size(), 3U);
    EXPECT_EQ(back.damage().size(), 1U);
}

TEST(RecordingTest, HoldsMessagesOfNoBytes) {
    Recording recording;
    recording.add(1, "EMPTY", nullptr, 0);
    recording.add(2, "A", gyro(1, 2));
    EXPECT_EQ(recording[0].size, 0U);
    EXPECT_EQ(recording[1].channel, "A");
}

TEST(RecordingTest, NamesAFileThatIsNotThere) {
    const Folder folder;
    EXPECT_NE(complaint<std::runtime_error>([&] {
                  (void)Recording::load(folder.path("none"));
              }).find(folder.path("none")),
              std::string::npos);
    EXPECT_NE(complaint<std::runtime_error>([&] { some().save(folder.path("no/such")); }), "");
}

}  // namespace
}  // namespace pilotage::test
