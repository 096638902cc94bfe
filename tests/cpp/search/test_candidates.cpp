#include "pilotage/search/candidates.hpp"

#include <gtest/gtest.h>

namespace pilotage::test {
namespace {

TEST(CandidatesTest, AreTheBestBestFirst) {
    Candidates<3> best;
    for (const double score : {1.0, 4.0, 2.0, 5.0, 3.0}) best.add({{10 * score, 0, 0}, score, 1});
    ASSERT_EQ(best.count(), 3);
    EXPECT_EQ(best[0].score, 5);
    EXPECT_EQ(best[1].score, 4);
    EXPECT_EQ(best[2].score, 3);
    EXPECT_EQ(best.threshold(), 3);
}

TEST(CandidatesTest, OfANeighbourhoodThereIsOne) {
    Candidates<3> best;
    best.add({{1, 1, 3.14}, 1, 1});
    best.add({{1.1, 1, -3.14}, 2, 1});
    best.add({{1, 1.1, 3.14}, 1.5, 1});
    ASSERT_EQ(best.count(), 1);
    EXPECT_EQ(best[0].score, 2);
    best.add({{1, 1, 0}, 1, 1});
    EXPECT_EQ(best.count(), 2);
}

TEST(CandidatesTest, FarBehindTheBestIsHopeless) {
    Candidates<3> best;
    EXPECT_EQ(best.threshold(), 0);
    best.add({{0, 0, 0}, 100, 1});
    EXPECT_EQ(best.threshold(), 100 - Candidates<3>::kHopeless);
}

}  // namespace
}  // namespace pilotage::test
