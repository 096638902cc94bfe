#include "pilotage/search/subsets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace pilotage::test {
namespace {

template <int K>
void expect_each_once(int n, std::uint32_t turn) {
    std::set<Subset<K>> seen;
    int visits = 0;
    each_subset<K>(n, turn, [&](const Subset<K>& s) {
        ++visits;
        seen.insert(s);
        for (std::size_t k = 0; k < K; ++k) {
            EXPECT_TRUE(s[k] >= 0 && s[k] < n);
            EXPECT_TRUE(k == 0 || s[k - 1] < s[k]);
        }
        return true;
    });
    EXPECT_EQ(visits, binomial(n, K));
    EXPECT_EQ(static_cast<int>(seen.size()), visits) << n;
}

TEST(SubsetsTest, EachOnceWhereverItBegins) {
    for (int n = 0; n <= 12; ++n)
        for (const std::uint32_t turn : {0U, 1U, 4'294'967'295U}) {
            expect_each_once<2>(n, turn);
            expect_each_once<3>(n, turn);
        }
}

TEST(SubsetsTest, StopsWhenTold) {
    int visits = 0;
    each_subset<3>(10, 0, [&](const Subset<3>&) { return ++visits < 5; });
    EXPECT_EQ(visits, 5);
}

TEST(SubsetsTest, TheFirstTenTriplesOfTenShareNoMemberAllAlong) {
    for (int member = 0; member < 10; ++member) {
        int with = 0, visits = 0;
        each_subset<3>(10, 0, [&](const Subset<3>& s) {
            for (const int i : s) with += i == member;
            return ++visits < 10;
        });
        EXPECT_LE(with, 6) << member;
    }
}

/// As of searches ten times a second, by any clock: all of a map has its turn.
TEST(SubsetsTest, TurnsInStepBeginEverywhere) {
    for (const std::uint32_t count : {37U, 50U, 74U})
        for (const std::uint64_t step : {1U, 100U, 100'000U}) {
            std::vector<int> begun(count);
            for (std::uint64_t i = 0; i < 40 * count; ++i)
                ++begun[one_of(count, scattered(1'700'000'000'000'000 + step * i))];
            EXPECT_GT(*std::min_element(begun.begin(), begun.end()), 10);
            EXPECT_LT(*std::max_element(begun.begin(), begun.end()), 100);
        }
}

}  // namespace
}  // namespace pilotage::test
