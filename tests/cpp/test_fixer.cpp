// How often other poses are looked for.

#include "pilotage/fixer.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "support/robots.hpp"

namespace pilotage::test {
namespace {

using Three = Track<double, kPoseStates>;

TEST(FixerTest, ASearchIsMadeTenTimesASecondAtMostWhileAPoseIsAmbiguous) {
    const Params params = plain_params();
    const Tracker<double, kPoseStates> tracker(params);
    const Fixer<double, kPoseStates> fixer(params, kRectangle, {});
    PoseSearch search(params, kRectangle);
    Three track = tracker.start({0, 0, 0}, Pose<double>(0.8, 0.8, 0.09).asDiagonal());
    tracker.begin(track, encoders_at(0, 0, 0));
    std::vector<Evidence> newest_first;
    int searches = 0, ambiguous = 0;
    for (std::int64_t frame = 1; frame <= 200; ++frame) {
        track.utime = frame * 10'000;
        for (const Marker& marker : kRectangle.markers()) {
            const Vector<double, 3> seen = only(view({0.5, 0.4, 0.1}, marker), true, false, true);
            const Sample sample = sighting_at(track.utime, kUnknownId, seen);
            newest_first.insert(newest_first.begin(), fixer.evidence(track, sample, search));
            newest_first.front().log_likelihood -=
                3;  // the sightings agree, but foretold were others
            (void)fixer.sight(track, sample, {marker.id, Verdict::pending});
        }
        newest_first.resize(std::min(newest_first.size(), std::size_t{Evidence::kMost}));
        if (!fixer.doubtful(track)) continue;
        ++searches;
        fixer.search(track, newest_first.data(), static_cast<int>(newest_first.size()), search);
        ambiguous += track.judgement.finding == Finding::ambiguous;
    }
    EXPECT_GT(ambiguous, 10);
    EXPECT_LE(searches, 2 * 11 + 1);
}

}  // namespace
}  // namespace pilotage::test
