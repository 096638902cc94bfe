// A sorted ring of fixed capacity, held against a std::vector that is sorted
// anew each time.

#include "pilotage/history.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "support/allocations.hpp"
#include "support/samples.hpp"

namespace pilotage::test {
namespace {

struct Note {
    Sample sample;
    int tag = 0;
};

void insert(History<Note>& history, const Sample& sample, int tag = 0) {
    bool duplicate = false;
    Note& note = history.insert(history.place(sample, duplicate));
    note.sample = sample;
    note.tag = tag;
}

std::vector<std::int64_t> utimes(const History<Note>& history) {
    std::vector<std::int64_t> result;
    for (std::size_t i = 0; i < history.size(); ++i) result.push_back(history[i].sample.utime);
    return result;
}

TEST(HistoryTest, StartsEmptyAndFillsToItsCapacity) {
    History<Note> history(3);
    EXPECT_EQ(history.size(), 0U);
    for (int t = 0; t < 3; ++t) {
        EXPECT_FALSE(history.full());
        insert(history, gyro_at(t, 0));
    }
    EXPECT_TRUE(history.full());
    EXPECT_EQ(utimes(history), (std::vector<std::int64_t>{0, 1, 2}));
}

TEST(HistoryTest, InsertsInTheMiddleAndAtTheFront) {
    History<Note> history(4);
    for (const int t : {20, 40, 30, 10}) insert(history, gyro_at(t, 0), t);
    EXPECT_EQ(utimes(history), (std::vector<std::int64_t>{10, 20, 30, 40}));
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(history[i].tag, history[i].sample.utime) << "content has moved";
}

TEST(HistoryTest, PopsTheOldestAndGoesRoundTheRing) {
    History<Note> history(3);
    for (int t = 0; t < 10; ++t) {
        if (history.full()) history.pop_front();
        insert(history, gyro_at(t, 0), t);
    }
    EXPECT_EQ(utimes(history), (std::vector<std::int64_t>{7, 8, 9}));
    history.pop_front();
    EXPECT_FALSE(history.full());
    EXPECT_EQ(utimes(history), (std::vector<std::int64_t>{8, 9}));
}

TEST(HistoryTest, KnowsADuplicateAmongNeighboursOfEqualTime) {
    History<Note> history(8);
    for (const int seq : {1, 2, 3}) insert(history, gyro_at(5, 0.1, seq));
    insert(history, encoders_at(5, 0, 0));
    bool duplicate = false;
    for (const int seq : {1, 2, 3}) {
        (void)history.place(gyro_at(5, 0.1, seq), duplicate);
        EXPECT_TRUE(duplicate) << "seq " << seq;
    }
    EXPECT_EQ(history.place(gyro_at(5, 0.2, 2), duplicate), 2U);
    EXPECT_FALSE(duplicate) << "the same stamp and seq with another rate is another sample";
    EXPECT_EQ(history.place(gyro_at(4, 0.1, 1), duplicate), 0U);
    EXPECT_FALSE(duplicate);
}

TEST(HistoryTest, NodesStayWhereTheyAreWhileOthersComeAndGo) {
    History<Note> history(4);
    insert(history, gyro_at(50, 0));
    insert(history, gyro_at(10, 0));
    const Note* fifty = &history[1];
    insert(history, gyro_at(30, 0));
    history.pop_front();
    insert(history, gyro_at(40, 0));
    EXPECT_EQ(&history[2], fifty);
}

TEST(HistoryTest, IsTheSortedVectorThroughAnyMixOfInsertsAndPops) {
    std::mt19937 generator(3);
    for (const std::size_t capacity : {1U, 2U, 7U, 64U}) {
        History<Note> history(capacity);
        std::vector<Sample> expected;
        for (int step = 0; step < 3000; ++step) {
            if (history.full() || (history.size() > 0 && generator() % 4 == 0)) {
                history.pop_front();
                expected.erase(expected.begin());
                continue;
            }
            const Sample sample = gyro_at(static_cast<std::int64_t>(generator() % 50), 0.0,
                                          static_cast<std::int32_t>(generator() % 4));
            const auto at = std::lower_bound(expected.begin(), expected.end(), sample, InOrder{});
            const bool known = at != expected.end() && at->compare(sample) == 0;
            bool duplicate = false;
            (void)history.place(sample, duplicate);
            ASSERT_EQ(duplicate, known);
            if (known) continue;
            insert(history, sample);
            expected.insert(at, sample);
            ASSERT_EQ(history.size(), expected.size());
            for (std::size_t i = 0; i < expected.size(); ++i)
                ASSERT_EQ(history[i].sample.compare(expected[i]), 0) << "step " << step;
        }
    }
}

TEST(HistoryTest, AllocatesNothingAfterConstruction) {
    History<Note> history(100);
    const AllocationCount count;
    for (int t = 0; t < 5000; ++t) {
        if (history.full()) history.pop_front();
        insert(history, gyro_at(t % 7 == 0 ? t - 30 : t, 0));
    }
    EXPECT_EQ(count.since(), 0);
}

}  // namespace
}  // namespace pilotage::test
