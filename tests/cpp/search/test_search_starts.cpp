// How often a start is right, over seeded drives. More runs by hand, with a table:
// PILOTAGE_RUNS=1000 ./pilotage_tests --gtest_filter='Search*'

#include <gtest/gtest.h>

#include <cstdio>

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
        moved = before.into(drive.odometry());
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
    Pose<double> moved{0, 0, 0};  ///< by odometry since the frame before

   private:
    std::vector<Hypothesis> last_;
    std::uint32_t turn_ = 0;
};

/// A pose as a judge would take it: 7 nats ahead of the second and of no explanation, surer than a
/// metre, the same for four frames on end.
class Decision {
   public:
    bool add(const Hypotheses& found, const Pose<double>& moved) {
        held_ = Frame(held_).out_of(moved);
        const double second = found.count > 1 ? std::max(0.0, found[1].gain) : 0;
        const bool ahead = found.count > 0 && found[0].gain - second > 7 &&
                           found[0].covariance.topLeftCorner<2, 2>().trace() < 0.25 &&
                           found[0].covariance(kHeading, kHeading) < 0.0225;
        const bool same_as_before = ahead && times_ > 0 && minus(found[0].pose, held_).norm() < 0.6;
        times_ = !ahead ? 0 : same_as_before ? times_ + 1 : 1;
        if (ahead) held_ = found[0].pose;
        return times_ >= 4;
    }

   private:
    Pose<double> held_{0, 0, 0};
    int times_ = 0;
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
        Decision decision;
        for (int frame = 1; frame <= kFrames; ++frame) {
            const Hypotheses found = follower.step();
            if (!decision.add(found, follower.moved)) continue;
            if (!right(found[0], follower.drive.truth())) {
                ++counts.wrong;
                break;
            }
            ++counts.right;
            counts.within_ten += frame <= 10;
            counts.squared_error +=
                Ldlt<double, 3>(found[0].covariance)
                    .squared_norm(minus(follower.drive.truth(), found[0].pose)) /
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
            const Counts c = starts(yard(), sight, runs_of(60));
            EXPECT_LE(c.wrong, c.runs / 1000);
            EXPECT_GE(c.within_ten, 0.95 * c.runs);
            EXPECT_LT(c.squared_error, 1.8 * c.right);
        }
}

TEST(SearchStartsTest, WithRangesAloneItIsRightOrUndecided) {
    EXPECT_LE(starts(yard(), {false, false, true, true, 0.05, 3, 4}, runs_of(60)).wrong,
              runs_of(60) / 500);
}

TEST(SearchStartsTest, WithoutIdsAStartIsRightOrUndecided) {
    for (const double outliers : {0.0, 0.05})
        for (const Sight& sight : {Sight{true, false, false, false, outliers, 3, 4},
                                   Sight{true, true, false, false, outliers, 3, 4},
                                   Sight{true, false, true, false, outliers, 3, 4}}) {
            const Counts c = starts(yard(), sight, runs_of(20));
            EXPECT_LE(c.wrong, c.runs / 500);
            EXPECT_GE(c.within_ten, 0.85 * c.runs);
        }
}

}  // namespace
}  // namespace pilotage::test
