#pragma once
/// \file
/// Every pose that explains the sightings of late, with no prior at all.

#include <initializer_list>

#include "pilotage/search/candidates.hpp"
#include "pilotage/search/clue.hpp"
#include "pilotage/search/hypothesis.hpp"
#include "pilotage/search/likelihood.hpp"
#include "pilotage/search/refinement.hpp"
#include "pilotage/search/subsets.hpp"

namespace pilotage {

/// Two or three sightings at a time give candidates, all sightings score them, the best are
/// refined. A run depends on its arguments alone, and its work is bounded.
class PoseSearch {
   public:
    PoseSearch(const Params& params, MarkerMap map);

    /// \param newest_first sightings, the first at the robot's pose of now
    /// \param guesses poses of now that somebody has in mind, as hypotheses of the last run carried
    /// on by odometry: they are judged with the others
    /// \param turn any number that changes from run to run: where not everything can be tried, it
    /// chooses what is tried first
    /// \return valid until the next run
    [[nodiscard]] Hypotheses run(const Evidence* newest_first, int count,
                                 const Pose<double>* guesses = nullptr, int guess_count = 0,
                                 std::uint64_t turn = 0) noexcept;

    /// Of one sighting under a pose with a covariance, in the measure of the evidence.
    [[nodiscard]] double log_likelihood(const Pose<double>& pose,
                                        const Matrix<double, 3>& covariance,
                                        const Sighting& sighting,
                                        std::uint8_t source) const noexcept;

    /// Of the last run's bound; below zero by what was under way when it was reached.
    [[nodiscard]] int work_left() const noexcept { return work_; }

   private:
    static constexpr int kSeeds = 10;       // sightings that give candidates
    static constexpr int kCandidates = 64;  // that are kept
    static constexpr int kRefined = 16;     // at most
    /// Bound on the work of proposing for each marker of the map, counted in markers looked at; a
    /// sighting or a set of sightings counts as kWork more.
    static constexpr int kMostWork = 64'000, kWork = 10;
    static constexpr int kMostMarkers = 30;  // of a larger map a part is tried in each run

    void allow_tilt(View& view) const noexcept;
    void take(const Evidence* newest_first, int count) noexcept;
    void choose_seeds() noexcept;
    void propose_by_points() noexcept;
    void propose_by_bearings() noexcept;
    void propose_by_arcs() noexcept;
    void propose_arc(const Clue& one, const Clue& two) noexcept;
    void consider(const Frame& robot, int most_strange) noexcept;
    void consider(const Point& place, const Point& turn) noexcept;
    void refine_best(std::initializer_list<double> widenings) noexcept;
    [[nodiscard]] Hypothesis judge(const PoseFit& fit) const noexcept;
    void keep(const Hypothesis& hypothesis) noexcept;

    [[nodiscard]] const View& seed(int i) const noexcept { return views_[seeds_[i]]; }
    /// After a set of sightings was held against the map.
    /// \param considered candidates before
    bool go_on(int considered) noexcept {
        whole_ = whole_ || (considered_ > considered && work_ > 0);
        return work_ > 0;
    }
    /// Counts work. \return whether some is left
    bool work(int amount) noexcept { return (work_ -= amount) > 0; }
    [[nodiscard]] int markers() const noexcept { return static_cast<int>(map_.markers().size()); }

    /// visit(marker) for every marker that the sighting can be of, in each turn from another one on
    template <typename Visit>
    void each_marker(const View& view, const Visit& visit) const noexcept {
        if (view.marker != nullptr) return visit(*view.marker);
        const auto count = static_cast<std::uint32_t>(markers());
        const std::uint32_t first = one_of(count, turn_);
        for (std::uint32_t i = 0; i < count && work_ > 0; ++i) {
            const Marker& marker =
                map_.markers()[first + i < count ? first + i : first + i - count];
            if (view.may_be_of(marker)) visit(marker);
        }
    }
    template <typename Visit>
    void each_clue(const View& view, const Visit& visit) const noexcept {
        each_marker(view, [&](const Marker& marker) { visit(clue_of(view, marker)); });
    }
    template <typename Visit>
    void each_ray(const View& view, const Visit& visit) const noexcept {
        each_marker(view, [&](const Marker& marker) { visit(ray_of(view, marker)); });
    }

    Params params_;
    MarkerMap map_;
    Site site_;
    View views_[Evidence::kMost];  // newest first
    int count_ = 0;
    double most_[Evidence::kMost + 1] = {};  // that views from here on can add to a score
    std::uint32_t turn_ = 0;
    int work_ = 0;        // left
    int considered_ = 0;  // candidates
    bool whole_ = false;  // some sightings were held against all of the map
    int seeds_[kSeeds] = {};
    int seed_count_ = 0;
    Candidates<kCandidates> candidates_;
    Hypothesis hypotheses_[Hypotheses::kMost];
    int found_ = 0;
};

}  // namespace pilotage
