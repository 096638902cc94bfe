// The gain over a track: high where the robot was carried off, low where sightings are outliers.
// PILOTAGE_RUNS=1000 asks for more.

#include <gtest/gtest.h>

#include <cstdio>

#include "support/sighting_drives.hpp"

namespace pilotage::test {
namespace {

constexpr double kHigh = 3;

/// The gain of the best hypothesis that is not the track.
double best_other(const Hypotheses& found, const Pose<double>& track) {
    double best = -99;
    for (const Hypothesis& h : found)
        if (!right(h, track)) best = std::max(best, h.gain);
    return best;
}

/// Drives with a track that follows by odometry, and is carried off after 40 frames or not.
/// \return for each frame of each drive, the best gain of another pose
std::vector<std::vector<double>> gains(Sight sight, int runs, bool carried_off) {
    constexpr int kFrames = 40, kAfter = 4;
    const MarkerMap& map = kYard;
    std::vector<std::vector<double>> result;
    for (int run = 0; run < runs; ++run) {
        SightingDrive drive(map, sight, 5000 + static_cast<unsigned>(run));
        PoseSearch search(drive.params(), map);
        const Matrix<double, 3> covariance = Pose<double>(4e-4, 4e-4, 1e-4).asDiagonal();
        Pose<double> track = drive.truth();
        std::vector<double> log_likelihoods, best;
        for (int frame = 0; frame < kFrames + kAfter; ++frame) {
            if (carried_off && frame == kFrames) do
                    drive.carry_off();
                while ((drive.truth() - track).head<2>().norm() < 3);
            const Frame before(drive.truth());
            const int count = drive.step();
            track = Frame(track).out_of(before.into(drive.truth()));
            std::vector<Evidence> evidence = drive.newest_first();
            for (int i = count - 1; i >= 0; --i)
                log_likelihoods.insert(
                    log_likelihoods.begin(),
                    search.log_likelihood(track, covariance, evidence[i].sighting, 0));
            for (std::size_t i = 0; i < evidence.size(); ++i)
                evidence[i].log_likelihood = log_likelihoods[i];
            if (carried_off && frame < kFrames) continue;
            best.push_back(
                best_other(search.run(evidence.data(), static_cast<int>(evidence.size())), track));
        }
        result.push_back(best);
    }
    return result;
}

TEST(SearchGainTest, CarriedOffItKnowsAfterThreeFramesOfTwoMarkers) {
    for (const Sight& sight :
         {Sight{true, false, false, true, 0.05, 2, 2}, Sight{true, true, false, true, 0.05, 2, 2},
          Sight{true, false, true, true, 0.05, 2, 2}}) {
        const int runs = runs_of(40);
        int known = 0;
        for (const auto& drive : gains(sight, runs, true)) known += drive[2] > kHigh;
        std::printf("carried off: known after three frames in %d of %d\n", known, runs);
        EXPECT_GE(known, 0.97 * runs);
    }
}

TEST(SearchGainTest, OutliersDoNotLookLikeBeingCarriedOff) {
    for (const Sight& sight :
         {Sight{true, false, false, true, 0.2, 2, 2}, Sight{true, true, false, true, 0.2, 2, 2},
          Sight{true, false, true, true, 0.2, 2, 2}}) {
        const int runs = runs_of(20);
        long frames = 0, high = 0, held = 0;
        for (const auto& drive : gains(sight, runs, false))
            for (std::size_t i = 2; i < drive.size(); ++i) {
                ++frames;
                high += drive[i] > kHigh;
                held += drive[i] > kHigh && drive[i - 1] > kHigh && drive[i - 2] > kHigh;
            }
        std::printf("20 %% outliers: high gain in %ld of %ld frames, three on end in %ld\n", high,
                    frames, held);
        EXPECT_LE(high, 0.004 * double(frames));
        EXPECT_LE(held, 0.001 * double(frames));
    }
}

}  // namespace
}  // namespace pilotage::test
