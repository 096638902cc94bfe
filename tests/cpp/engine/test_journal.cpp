// The journal: each subject speaks at once, then now and then, and nothing is lost without a
// number.

#include "engine/journal.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "support/units.hpp"

namespace pilotage::test {
namespace {

constexpr std::int64_t kMinute = 60 * kSecond;

struct Reader {
    Journal journal;
    std::vector<std::string> lines;

    void note(const std::string& subject, const std::string& line, std::int64_t now,
              int at_once = 1) {
        journal.note(subject, line, at_once, now, say());
    }
    void flush(std::int64_t now) { journal.flush(now, say()); }
    Journal::Say say() {
        return [this](const std::string& line) { lines.push_back(line); };
    }
};

using Lines = std::vector<std::string>;

TEST(JournalTest, SaysTheFirstLineAtOnce) {
    Reader reader;
    reader.note("a", "hello", 5 * kSecond);
    EXPECT_EQ(reader.lines, Lines{"hello"});
    reader.flush(10 * kMinute);
    EXPECT_EQ(reader.lines.size(), 1U) << "and no more";
}

TEST(JournalTest, SaysTheNewestOfManyAMinuteLaterWithTheNumberLeftOut) {
    Reader reader;
    for (int i = 0; i < 5; ++i) reader.note("a", "line " + std::to_string(i), i * kSecond);
    EXPECT_EQ(reader.lines, Lines{"line 0"});
    reader.flush(kMinute - 1);
    EXPECT_EQ(reader.lines.size(), 1U);
    reader.flush(kMinute);
    EXPECT_EQ(reader.lines, (Lines{"line 0", "line 4 (and 3 more like it)"}));
    reader.note("a", "again", kMinute + 1);
    EXPECT_EQ(reader.lines.size(), 2U) << "the minute's line is spent";
    reader.flush(2 * kMinute);
    EXPECT_EQ(reader.lines.back(), "again");
}

TEST(JournalTest, SaysSeveralAtOnceWhereTheSubjectMay) {
    Reader reader;
    for (int i = 0; i < 10; ++i) reader.note("a", std::to_string(i), kSecond, 6);
    EXPECT_EQ(reader.lines, (Lines{"0", "1", "2", "3", "4", "5"}));
    reader.flush(kSecond + kMinute);
    EXPECT_EQ(reader.lines.back(), "9 (and 3 more like it)");
    for (int i = 0; i < 10; ++i) reader.note("a", "later", kSecond + 20 * kMinute, 6);
    EXPECT_EQ(reader.lines.size(), 7U + 6U) << "six again after a long rest, not more";
}

TEST(JournalTest, SubjectsDoNotSilenceEachOther) {
    Reader reader;
    reader.note("a", "one", 0);
    reader.note("a", "two", 0);
    reader.note("b", "three", 0);
    EXPECT_EQ(reader.lines, (Lines{"one", "three"}));
}

TEST(JournalTest, AnHourOfNoiseIsALineAMinute) {
    Reader reader;
    for (std::int64_t t = 0; t < 60 * kMinute; t += kSecond / 10) {
        reader.note("a", "noise", t);
        if (t % kSecond == 0) reader.flush(t);
    }
    EXPECT_NEAR(static_cast<double>(reader.lines.size()), 60, 1);
    long told = 0;
    for (const std::string& line : reader.lines) {
        const std::size_t and_more = line.find("(and ");
        told += 1 + (and_more == std::string::npos ? 0 : std::stol(line.substr(and_more + 5)));
    }
    EXPECT_NEAR(static_cast<double>(told), 36'000, 700) << "but for what still waits";
}

TEST(JournalTest, AClockThatIsSetBackSilencesItForAMinuteOnly) {
    Reader reader;
    reader.note("a", "one", 100 * kMinute);
    reader.note("a", "two", 100 * kMinute);
    reader.flush(kMinute);
    EXPECT_EQ(reader.lines.size(), 1U);
    reader.flush(2 * kMinute);
    EXPECT_EQ(reader.lines, (Lines{"one", "two"}));
}

TEST(JournalTest, InventedSubjectsDoNotFillTheMemory) {
    Reader reader;
    for (int i = 0; i < 5000; ++i) reader.note("name " + std::to_string(i), "hello", 0);
    EXPECT_EQ(reader.lines.size(), 1000U);
    reader.note("name 0", "known", 10 * kMinute);
    EXPECT_EQ(reader.lines.back(), "known") << "known ones still speak";
}

}  // namespace
}  // namespace pilotage::test
