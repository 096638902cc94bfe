// A large map without ids: a search does no more than it may, and those that follow each other find
// the place.

#include <gtest/gtest.h>

#include "support/robots.hpp"
#include "support/sighting_drives.hpp"

namespace pilotage::test {
namespace {

/// A site of the density of the yard, and what is seen from a place of its nearest markers.
struct Large {
    MarkerMap map;
    Params params;
    Pose<double> truth;
    std::vector<Evidence> evidence;

    /// \param ranges beside the bearings
    Large(int markers, bool ranges, unsigned seed) {
        Draw draw(seed);
        const double half_m = 10 * std::sqrt(markers / 10.0);
        std::vector<Marker> all;
        for (int i = 0; i < markers; ++i)
            all.push_back(
                {i, draw.uniform(-half_m, half_m), draw.uniform(-half_m, half_m), 0.5, 0});
        map = MarkerMap(all);
        params.sensor_count = 1;
        truth = {draw.uniform(-half_m, half_m), draw.uniform(-half_m, half_m), draw.uniform(-3, 3)};
        std::sort(all.begin(), all.end(), [&](const Marker& a, const Marker& b) {
            return view(truth, a)[2] < view(truth, b)[2];
        });
        const double sigma_rad = ranges ? 0.02 : 0.005;
        const std::size_t in_view = ranges ? 5 : 8;
        for (std::size_t i = 0; i < std::size_t{Evidence::kMost}; ++i) {
            const Vector<double, 3> n = draw.normal<double, 3>();
            const Vector<double, 3> z = only(
                view(truth, all[i % in_view]) + Vector<double, 3>(sigma_rad * n[0], 0, 0.1 * n[2]),
                true, false, ranges);
            evidence.push_back({{0, 0, 0},
                                0,
                                0,
                                {{wrap(z[0]), z[1], z[2]}, {sigma_rad, kNan, 0.1}, -1, -1},
                                0,
                                kNan});
        }
    }

    /// Searches, each with what the one before found, until one finds the place; `most` if none.
    [[nodiscard]] int searches(std::uint64_t first, std::uint64_t step, int most) const {
        PoseSearch search(params, map);
        std::vector<Pose<double>> guesses;
        for (int i = 0; i < most; ++i) {
            const Hypotheses found =
                search.run(evidence.data(), Evidence::kMost, guesses.data(),
                           static_cast<int>(guesses.size()), first + step * std::uint64_t(i));
            if (found.count > 0 && (found[0].pose - truth).head<2>().norm() < 0.5) return i;
            guesses.clear();
            for (const Hypothesis& h : found) guesses.push_back(h.pose);
        }
        return most;
    }
};

/// What is under way when the work is used up is done: some sightings against the whole map.
TEST(SearchBoundsTest, NoMoreWorkIsDoneThanThereIs) {
    for (const bool ranges : {true, false})
        for (const int markers : {50, 500}) {
            const Large site(markers, ranges, 3);
            PoseSearch search(site.params, site.map);
            (void)search.run(site.evidence.data(), Evidence::kMost);
            EXPECT_GT(search.work_left(), -3 * Evidence::kMost * (markers + 10));
        }
}

TEST(SearchBoundsTest, APlaceOnALargeMapIsFoundInAFewSearches) {
    for (const int markers : {50, 100, 200, 500}) {
        int found = 0, sum = 0;
        for (unsigned seed = 1; seed <= 10; ++seed) {
            const int searches =
                Large(markers, true, seed).searches(1'700'000'000'000'000, 100'000, 30);
            found += searches < 30;
            sum += searches;
        }
        EXPECT_GE(found, 9) << markers << " markers";
        std::printf("%d markers: found %d of 10, by %.1f searches\n", markers, found, sum / 10.0);
    }
}

}  // namespace
}  // namespace pilotage::test
