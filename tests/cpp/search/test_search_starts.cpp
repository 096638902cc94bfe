// How often a start is right, over seeded drives. More runs by hand, with a table:
// PILOTAGE_RUNS=1000 ./pilotage_tests --gtest_filter='Search*'

#include <gtest/gtest.h>

#include <cstdio>

#include "pilotage/judge.hpp"
#include "support/sanitized.hpp"
#include "support/sighting_drives.hpp"

namespace pilotage::test {
namespace {

/// A search that is run after each frame, and given back what it found.
class Follower {
   public:
    Follower(const MarkerMap& map, const Sight& sight, unsigned seed)
        : drive(map, sight, seed), search(drive.params(), map) {}

    Hypotheses step() {
        const Frame before(drive.odometry());
        drive.step();
        const Pose<double> moved = before.into(drive.odometry());
        std::vector<Pose<double>> guesses;
        for (const Hypothesis& h : last_) guesses.push_back(Frame(h.pose).out_of(moved));
        const Hypotheses found =
            search.run(drive.newest_first().data(), static_cast<int>(drive.newest_first().size()),
                       guesses.data(), static_cast<int>(guesses.size()), ++turn_);
        last_.assign(found.begin(), found.end());
        return found;
    }

    SightingDrive drive;
    PoseSearch search;

   private:
    std::vector<Hypothesis> last_;
    std::uint32_t turn_ = 0;
};

struct Counts {
    int runs = 0, right = 0, wrong = 0, within_ten = 0;
    double squared_error = 0;  ///< in covariances, a dimension, where it is right
};

Counts starts(const MarkerMap& map, const Sight& sight, int runs) {
    constexpr int kFrames = 14;
    Counts counts;
    counts.runs = runs;
    for (int run = 0; run < runs; ++run) {
        Follower follower(map, sight, 1000 + static_cast<unsigned>(run));
        Judgement judgement;
        for (int frame = 1; frame <= kFrames; ++frame) {
            const Hypotheses found = follower.step();
            const Hypothesis* winner = judge(judgement, {}, found, follower.drive.odometry());
            if (winner == nullptr) continue;
            if (!right(*winner, follower.drive.truth())) {
                ++counts.wrong;
                break;
            }
            ++counts.right;
            counts.within_ten += frame <= 10;
            counts.squared_error += Ldlt<double, 3>(winner->covariance)
                                        .squared_norm(minus(follower.drive.truth(), winner->pose)) /
                                    3;
            break;
        }
    }
    std::printf(
        "%s%s%s %s ids, %2.0f %% outliers: right %d wrong %d of %d, in ten frames %d, NEES "
        "%.2f\n",
        sight.bearing ? "bearing " : "", sight.elevation ? "elevation " : "",
        sight.range ? "range " : "", sight.ids ? "with" : "without", 100 * sight.outliers,
        counts.right, counts.wrong, runs, counts.within_ten,
        counts.squared_error / std::max(1, counts.right));
    return counts;
}

TEST(SearchStartsTest, WithIdsAStartIsRightAndWithinTenFrames) {
    for (const double outliers : {0.0, 0.05, 0.2})
        for (const Sight& sight : {Sight{true, false, false, true, outliers, 3, 4},
                                   Sight{true, true, false, true, outliers, 3, 4},
                                   Sight{true, false, true, true, outliers, 3, 4}}) {
            const Counts c = starts(kYard, sight, runs_of(60));
            EXPECT_LE(c.wrong, c.runs / 1000);
            EXPECT_GE(c.within_ten, (outliers > 0.1 ? 0.7 : 0.95) * c.runs);
            EXPECT_LT(c.squared_error, 1.8 * c.right);
        }
}

TEST(SearchStartsTest, WithRangesAloneItIsRightOrUndecided) {
    EXPECT_LE(starts(kYard, {false, false, true, true, 0.05, 3, 4}, runs_of(60)).wrong,
              runs_of(60) / 500);
}

TEST(SearchStartsTest, WithoutIdsAStartIsRightOrUndecided) {
    for (const double outliers : {0.0, 0.05})
        for (const Sight& sight : {Sight{true, false, false, false, outliers, 3, 4},
                                   Sight{true, true, false, false, outliers, 3, 4},
                                   Sight{true, false, true, false, outliers, 3, 4}}) {
            const Counts c = starts(kYard, sight, runs_of(repeats(20)));
            EXPECT_LE(c.wrong, c.runs / 500);
            const bool bearings_alone = !sight.elevation && !sight.range;
            EXPECT_GE(c.within_ten, (bearings_alone ? 0.4 : 0.85) * c.runs);
        }
}

}  // namespace
}  // namespace pilotage::test
