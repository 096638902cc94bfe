#include "pilotage/judge.hpp"

#include <algorithm>
#include <cmath>

#include "pilotage/search/frame.hpp"
#include "pilotage/search/sameness.hpp"

namespace pilotage {

using namespace judging;

namespace {

bool same(const Pose<double>& a, const Pose<double>& b, const Matrix<double, 3>& covariance) {
    constexpr double four_sigmas = 16;
    return pilotage::same(a, b, covariance, four_sigmas);
}

bool is_the_estimate(const Hypothesis& h, const Claim& claim) {
    return claim.made && (next_to(h.pose, claim.pose) ||
                          same(h.pose, claim.pose, h.covariance + claim.covariance));
}

/// By how much each explains the sightings better than the estimate does, or than chance [nats].
struct Ranking {
    const Hypothesis* best = nullptr;  // of those that are another pose
    double first = -INFINITY, second = -INFINITY;
    double itself = 0;    // the estimate: an unsure one foretells little of what fits it well
    bool stands = false;  // the sightings alone lead to it

    [[nodiscard]] double margin() const { return first - std::fmax(second, itself); }
};

/// An estimate that was confirmed is held against the latest alone: before them the robot may not
/// have been carried off yet.
Ranking rank(const Claim& claim, const Hypotheses& found) {
    Ranking r;
    for (const Hypothesis& h : found) {
        const double strength =
            claim.made && !claim.confirmed ? h.log_evidence - claim.log_evidence : h.gain;
        if (is_the_estimate(h, claim)) {
            r.itself = std::fmax(r.itself, strength);
            r.stands = r.stands || !vague(h.covariance);
        } else if (strength > r.first) {
            r.second = r.first;
            r.first = strength;
            r.best = &h;
        } else if (strength > r.second) {
            r.second = strength;
        }
    }
    return r;
}

/// An estimate that was doubted is fine again once it stands out among what is found.
Finding finding_of(const Claim& claim, const Ranking& r, Finding before) {
    const bool doubted = claim.made && before != Finding::fine;
    if (doubted && r.best == nullptr && !r.stands) return Finding::ambiguous;
    const bool trusted = claim.confirmed && !doubted;
    const double doubtful = trusted ? kSuspicious : claim.made ? -kDecisive : 0;
    if (r.best == nullptr || r.first - r.itself < doubtful) return Finding::fine;
    if (r.margin() >= kDecisive) return Finding::elsewhere;
    return !claim.made && r.first < kDecisive ? Finding::fine : Finding::ambiguous;
}

/// Whether so much speaks for it that it may take the estimate's place, if it lasts.
bool convinces(const Claim& claim, const Ranking& r) {
    return !vague(r.best->covariance) && r.best->clutter <= kClutterOfLatest &&
           !(claim.made && r.margin() < kMoved) &&
           !(claim.confirmed && r.best->markers.count() < claim.markers);
}

/// Whether the pose has led for long enough, on a way that tells it from others.
/// \param held frames until now
/// \param sound nothing but a robot that stands could mislead it again and again
bool lasts(Judgement& j, const Hypothesis& best, const Pose<double>& odometry, int held,
           bool sound) {
    // Where dead reckoning has brought what led first.
    const Pose<double> way = Frame(j.odometry).into(odometry);
    Matrix<double, 3> unsure = 2 * best.covariance;
    unsure.diagonal() += Pose<double>(kOff_m * kOff_m, kOff_m * kOff_m, kOff_rad * kOff_rad);
    if (held == 0 || !same(best.pose, Frame(j.leader).out_of(way), unsure)) {
        j.held = 1;
        j.leader = best.pose;
        j.odometry = odometry;
        return false;
    }
    j.held = held + 1;
    const bool moved =
        std::hypot(way[kX], way[kY]) >= kWay_m || std::abs(way[kHeading]) >= kWay_rad;
    return j.held >= (moved && sound ? kFrames : kMoreFrames);
}

}  // namespace

bool judging::vague(const Matrix<double, 3>& covariance) noexcept {
    return !(covariance(kX, kX) <= kVaguest_m2 && covariance(kY, kY) <= kVaguest_m2 &&
             covariance(kHeading, kHeading) <= kVaguest_rad2);
}

const Hypothesis* judge(Judgement& judgement, const Claim& claim, const Hypotheses& found,
                        const Pose<double>& odometry) noexcept {
    const Ranking ranking = rank(claim, found);
    const int held = judgement.held;
    judgement.held = 0;
    judgement.margin = ranking.margin();
    judgement.finding = finding_of(claim, ranking, judgement.finding);
    if (judgement.finding != Finding::elsewhere || !convinces(claim, ranking)) return nullptr;
    return lasts(judgement, *ranking.best, odometry, held, found.whole) ? ranking.best : nullptr;
}

}  // namespace pilotage
