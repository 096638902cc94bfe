#include "pilotage/search/pose_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "pilotage/search/common_drift.hpp"
#include "pilotage/search/occam.hpp"

namespace pilotage {

namespace {

/// A candidate carries the noise of two or three sightings, so it is scored with wider variances.
constexpr double kWiden = 9;

constexpr double kLog2 = 0.6931471805599453;

/// Some pose explains any two.
constexpr int kLeastExplained = 3;

/// The most that a sighting can say for a pose.
double peak(const View& view) {
    double spread = 1;
    each<3>([&](int c) {
        if (view.has(static_cast<ComponentIndex>(c)))
            spread *= 2 * kPi<double> * kWiden * view.variance[c];
    });
    return std::log(view.clutter + view.share / std::sqrt(spread));
}

}  // namespace

PoseSearch::PoseSearch(const Params& params, MarkerMap map)
    : params_(params), map_(std::move(map)), site_(map_) {}

double PoseSearch::log_likelihood(const Pose<double>& pose, const Matrix<double, 3>& covariance,
                                  const Sighting& sighting, std::uint8_t source) const noexcept {
    View view =
        view_of(sighting, params_.sensors[source], map_, site_, {0, 0, 0},
                (covariance(kX, kX) + covariance(kY, kY)) / 2, covariance(kHeading, kHeading));
    allow_tilt(view);
    return view.measured == 0 ? 0 : explain(view, Frame(pose), map_).log_likelihood;
}

/// A tilt that lasts is common to all sightings, which the evidence counts as independent: so its
/// variance comes as many times as there can be of them.
void PoseSearch::allow_tilt(View& view) const noexcept {
    if (!params_.tilt.any() || !view.has(kElevation)) return;
    const double variance = Evidence::kMost * params_.tilt.variance_rad2();
    view.variance[kElevation] += variance;
    view.variance[kBearing] += view.slope * view.slope * variance;
}

void PoseSearch::take(const Evidence* newest_first, int count) noexcept {
    count_ = 0;
    for (int i = 0; i < std::min(count, Evidence::kMost); ++i) {
        const Evidence& e = newest_first[i];
        View& view = views_[count_];
        view = view_of(e.sighting, params_.sensors[e.source], map_, site_,
                       Frame(newest_first->body).into(e.body),
                       std::abs(newest_first->drift_m2 - e.drift_m2),
                       std::abs(newest_first->drift_rad2 - e.drift_rad2));
        if (view.measured == 0) continue;
        allow_tilt(view);
        view.log_likelihood = std::fmax(view.log_likelihood, e.log_likelihood);
        ++count_;
    }
    most_[count_] = 0;
    for (int i = count_ - 1; i >= 0; --i)
        most_[i] = most_[i + 1] + std::max(0.0, peak(views_[i]) - views_[i].log_likelihood);
}

/// The newest, but of each marker few.
void PoseSearch::choose_seeds() noexcept {
    constexpr int kOfOneMarker = 3;
    seed_count_ = 0;
    for (int i = 0; i < count_ && seed_count_ < kSeeds; ++i) {
        const Marker* marker = views_[i].marker;
        const auto same_marker = [&](int seed) { return views_[seed].marker == marker; };
        if (marker != nullptr &&
            std::count_if(seeds_, seeds_ + seed_count_, same_marker) >= kOfOneMarker)
            continue;
        seeds_[seed_count_++] = i;
    }
}

void PoseSearch::consider(const Point& place, const Point& turn) noexcept {
    constexpr int kStrangeOfLatest = 3;  // one more than a judge believes
    ++considered_;
    if (site_.holds(place[0], place[1])) consider(Frame(place, turn), kStrangeOfLatest);
}

/// Scores a candidate, for as long as it may be better than those that there are.
/// \param most_strange it is given up if it explains no more of the newest sightings
void PoseSearch::consider(const Frame& robot, int most_strange) noexcept {
    const double threshold = candidates_.threshold();
    double sum = 0, best = 0;
    int explained = 0, strange = 0;
    for (int i = 0; i < count_; ++i) {
        work(views_[i].marker != nullptr ? kWork : kWork + markers());
        const double log_likelihood = explain(views_[i], robot, map_, kWiden).log_likelihood;
        const bool clutter = log_likelihood < views_[i].log_clutter + kLog2;
        if (i < Hypothesis::kLatest && clutter && ++strange > most_strange) return;
        sum += log_likelihood - views_[i].log_likelihood;
        if (sum >= best) {
            best = sum;
            explained = i + 1;
        }
        if (std::max(best, sum + most_[i + 1]) <= threshold) return;
    }
    candidates_.add({robot.pose(), best, explained});
}

/// A pose that was fitted, with its evidence.
Hypothesis PoseSearch::judge(const PoseFit& fit) const noexcept {
    Hypothesis result;
    result.pose = fit.pose;
    result.covariance = Ldlt<double, 3>(fit.information).inverse();
    const double occam = log_occam(result.covariance, site_);
    const Frame robot(fit.pose);
    CommonDrift drift;
    double sum = 0;
    int sightings = 0;
    MarkerSet markers;
    const double moment = -std::log(count_);  // any sighting may be the first that it explains
    result.log_evidence = occam;
    result.gain = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < count_; ++i) {
        const Explanation e = explain(views_[i], robot, map_);
        drift.add(views_[i], e);
        result.log_evidence += e.log_likelihood;
        sum += e.log_likelihood - views_[i].log_likelihood;
        if (e.belief > 0.5) {
            ++sightings;
            markers.add(MarkerSet::of(e.marker - map_.markers().data()));
        } else if (i < Hypothesis::kLatest) {
            ++result.clutter;
        }
        if (sightings < kLeastExplained || sum + occam + moment < result.gain) continue;
        result.gain = sum + occam + moment;
        result.explained = i + 1;
        result.sightings = sightings;
        result.markers = markers;
    }
    result.drift = drift.variances();
    return result;
}

/// Those that are the same become the best of them.
void PoseSearch::keep(const Hypothesis& hypothesis) noexcept {
    constexpr double kSameSquared = 9;
    const auto twin = [&](const Hypothesis& other) {
        return same(other.pose, hypothesis.pose, other.covariance, kSameSquared) ||
               same(other.pose, hypothesis.pose, hypothesis.covariance, kSameSquared);
    };
    const auto better = [&](const Hypothesis& other) { return other.gain >= hypothesis.gain; };
    Hypothesis* end = hypotheses_ + found_;
    if (std::any_of(hypotheses_, end, [&](const auto& h) { return twin(h) && better(h); })) return;
    end = std::remove_if(hypotheses_, end, twin);
    Hypothesis* at = std::partition_point(hypotheses_, end, better);
    if (at == hypotheses_ + Hypotheses::kMost) return;
    if (end == hypotheses_ + Hypotheses::kMost) --end;
    std::move_backward(at, end, end + 1);
    *at = hypothesis;
    found_ = static_cast<int>(end - hypotheses_) + 1;
}

/// Climbs from the best candidates, with one widening of the variances after the other. Those that
/// lead to where another one led are given up on the way.
void PoseSearch::refine_best(std::initializer_list<double> widenings) noexcept {
    constexpr double kNearSquared = 36, kNear_m = 1, kNear_rad = 1;
    int refined = 0;
    for (int i = 0; i < candidates_.count() && refined < kRefined; ++i) {
        const Candidate& candidate = candidates_[i];
        if (candidate.score < candidates_.threshold()) break;
        PoseFit fit;
        fit.pose = candidate.pose;
        const auto known = [&] {
            return std::any_of(hypotheses_, hypotheses_ + found_, [&](const Hypothesis& h) {
                return same(h.pose, fit.pose, h.covariance, kNearSquared) &&
                       within(h.pose, fit.pose, kNear_m, kNear_rad);
            });
        };
        bool given_up = known();
        for (const double widen : widenings) {
            if (given_up) break;
            fit = climb(fit.pose, views_, candidate.explained, map_, site_, widen);
            given_up = known();
        }
        if (given_up) continue;
        const Hypothesis hypothesis = judge(fit);
        if (hypothesis.sightings >= kLeastExplained) keep(hypothesis);
        ++refined;
    }
}

Hypotheses PoseSearch::run(const Evidence* newest_first, int count, const Pose<double>* guesses,
                           int guess_count, std::uint64_t turn) noexcept {
    turn_ = scattered(turn);
    work_ = kMostWork * std::min(markers(), kMostMarkers);
    take(newest_first, count);
    choose_seeds();
    candidates_.clear();
    found_ = considered_ = 0;
    whole_ = false;
    for (int i = 0; i < guess_count; ++i) consider(Frame(guesses[i]), Hypothesis::kLatest);
    refine_best({1});  // widened, two tops that are near each other become one
    propose_by_points();
    propose_by_bearings();
    propose_by_arcs();
    refine_best({4, 1});  // a candidate is too far off for some sightings
    return {hypotheses_, found_, whole_ || work_ > 0};
}

}  // namespace pilotage
