#pragma once
/// \file
/// What the drift of dead reckoning leaves in a pose that older sightings tell.

#include "pilotage/search/likelihood.hpp"

namespace pilotage {

/// A fit takes the drift since each sighting for an error of its own, which the others average out.
/// In truth all that are older than a stretch of the way share what went wrong on it. If they share
/// all of it, the variance of their mean is (sum w sigma / sum w)^2, with the information of each
/// for w: no less than what there is.
class CommonDrift {
   public:
    void add(const View& view, const Explanation& e) noexcept {
        for (int k = 0; k < e.match.count; ++k) {
            const Match::Row& row = e.match.rows[k];
            const double weight = e.belief * row.information;
            place_.add(weight * (row.by_x * row.by_x + row.by_y * row.by_y), view.place_m2);
            heading_.add(weight * row.by_heading * row.by_heading, view.place_rad2);
        }
    }

    /// Of the pose (x, y, heading).
    [[nodiscard]] Pose<double> variances() const noexcept {
        return {place_.variance(), place_.variance(), heading_.variance()};
    }

   private:
    struct Mean {
        double weighted = 0, weight = 0;

        void add(double w, double variance) noexcept {
            weighted += w * std::sqrt(variance);
            weight += w;
        }
        [[nodiscard]] double variance() const noexcept {
            const double sigma = weight > 0 ? weighted / weight : 0;
            return sigma * sigma;
        }
    };

    Mean place_, heading_;
};

}  // namespace pilotage
