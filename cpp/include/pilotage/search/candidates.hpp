#pragma once
/// \file
/// The best poses proposed so far, one of each neighbourhood.

#include <algorithm>
#include <limits>

#include "pilotage/search/sameness.hpp"

namespace pilotage {

/// A pose that a few sightings gave, and what the others say of it.
struct Candidate {
    Pose<double> pose;
    double score;
    int explained;  ///< so many of the newest sightings gave the score
};

/// Keeps the best `Capacity`, best first.
template <int Capacity>
class Candidates {
   public:
    static constexpr double kHopeless = 15;  ///< behind the best

    void clear() noexcept { count_ = 0; }
    [[nodiscard]] int count() const noexcept { return count_; }
    [[nodiscard]] const Candidate& operator[](int i) const noexcept { return list_[i]; }

    /// A score that is not above this is of no use.
    [[nodiscard]] double threshold() const noexcept {
        if (count_ == 0) return 0;
        const double hopeless = std::max(0.0, list_[0].score - kHopeless);
        return count_ < Capacity ? hopeless : std::max(hopeless, list_[Capacity - 1].score);
    }

    void add(const Candidate& candidate) noexcept {
        int hole = 0;
        for (; hole < count_; ++hole)
            if (next_to(list_[hole].pose, candidate.pose)) break;
        if (hole < count_) {
            if (list_[hole].score >= candidate.score) return;
        } else if (count_ < Capacity) {
            ++count_;
        } else if (candidate.score <= list_[--hole].score) {
            return;
        }
        for (; hole > 0 && list_[hole - 1].score < candidate.score; --hole)
            list_[hole] = list_[hole - 1];
        list_[hole] = candidate;
    }

   private:
    Candidate list_[Capacity];
    int count_ = 0;
};

}  // namespace pilotage
