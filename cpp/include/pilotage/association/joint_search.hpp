#pragma once
/// \file
/// The likeliest assignment of a frame's sightings to markers, and what nearly as likely ones say
/// otherwise: joint compatibility by branch and bound (Neira and Tardos, "Data association in
/// stochastic mapping using the joint compatibility test", IEEE Trans. Robotics and Automation
/// 17(6), 2001), with likelihood in place of the number of pairings.

#include <algorithm>
#include <cstdint>
#include <limits>

#include "pilotage/association/pairing.hpp"

namespace pilotage {

/// A sighting in the search: the markers that it may be of, the likeliest first. Of none is a
/// choice as well.
template <typename Scalar>
struct Contender {
    static constexpr int kMaxPairings = 8;
    static constexpr int kNone = -1;

    Pairing<Scalar> pairings[kMaxPairings];
    int size = 0;
    int index = 0;  ///< of the sighting in its frame

    int best = kNone;              ///< its pairing in the likeliest assignment
    Scalar most_odds;              ///< that it can ever bring
    int tried;                     ///< its pairing in the assignment under way
    Scalar reached[kMaxPairings];  ///< log odds of the likeliest assignment with each pairing

    [[nodiscard]] std::int32_t id(int pairing) const noexcept {
        return pairing == kNone ? kUnknownId : pairings[pairing].id;
    }
};

/// Searches depth first, the likeliest pairing before the others, so that the first assignment to
/// be complete is the greedy one. A branch that cannot come within `kMargin` of the best is left.
template <typename Scalar>
class JointSearch {
   public:
    static constexpr int kMaxContenders = 32;
    /// Assignments less likely than the best by this factor (20) do not count [nats].
    static constexpr Scalar kMargin = Scalar(3);
    static constexpr int kMaxNodes = 1000;  ///< updates of the pose; then the best so far counts
    static_assert(kMaxNodes > kMaxContenders * Contender<Scalar>::kMaxPairings,
                  "enough for the greedy assignment");

    /// \param contenders in the order in which they are searched; receives `best` and `reached`
    JointSearch(Contender<Scalar>* const* contenders, int size, const Policy& policy) noexcept
        : contenders_(contenders), size_(size), policy_(&policy) {
        rest_[size] = 0;
        for (int i = size; i-- > 0;) {
            Contender<Scalar>& c = *contenders[i];
            c.best = Contender<Scalar>::kNone;
            c.most_odds = 0;
            for (int k = 0; k < c.size; ++k) {
                c.reached[k] = -std::numeric_limits<Scalar>::max();
                c.most_odds = std::max(c.most_odds, pilotage::most_odds(c.pairings[k]));
            }
            rest_[i] = rest_[i + 1] + c.most_odds;
        }
    }

    /// \param covariance of the pose before the frame
    void run(const Matrix<Scalar, 3>& covariance) noexcept {
        descend(0, {Vector<Scalar, 3>::Zero(), covariance}, {0, 0, 0});
    }

    /// Whether everything was searched; else assignments may be missing.
    [[nodiscard]] bool complete() const noexcept { return nodes_ <= kMaxNodes; }
    [[nodiscard]] int nodes() const noexcept { return std::min(nodes_, kMaxNodes); }

    /// Whether an assignment that is nearly as likely as the best has this pairing.
    [[nodiscard]] bool close(const Contender<Scalar>& contender, int pairing) const noexcept {
        return contender.reached[pairing] >= best_ - kMargin;
    }

   private:
    /// Of the pairings so far.
    struct Sum {
        Scalar log_odds, nis;
        int dof;
    };

    void descend(int depth, const Deviation<Scalar>& deviation, const Sum& sum) noexcept {
        if (sum.log_odds + rest_[depth] < best_ - kMargin) return;
        if (depth == size_) return keep(sum.log_odds);
        Contender<Scalar>& c = *contenders_[depth];
        for (int k = 0; k < c.size; ++k) {
            const Pairing<Scalar>& pairing = c.pairings[k];
            if (taken(pairing.id, depth)) continue;
            if (++nodes_ > kMaxNodes) return;
            Deviation<Scalar> after = deviation;
            const Support<Scalar> support = take(after, pairing);
            const Sum with{sum.log_odds + support.log_odds, sum.nis + support.nis,
                           sum.dof + pairing.dof};
            if (!support.possible || policy_->beyond_gate(double(with.nis), with.dof)) continue;
            c.tried = k;
            descend(depth + 1, after, with);
        }
        c.tried = Contender<Scalar>::kNone;
        descend(depth + 1, deviation, sum);
    }

    /// A marker is seen once in a frame.
    [[nodiscard]] bool taken(std::int32_t id, int depth) const noexcept {
        for (int i = 0; i < depth; ++i)
            if (contenders_[i]->id(contenders_[i]->tried) == id) return true;
        return false;
    }

    void keep(Scalar log_odds) noexcept {
        const bool better = log_odds > best_;
        if (better) best_ = log_odds;
        for (int i = 0; i < size_; ++i) {
            Contender<Scalar>& c = *contenders_[i];
            if (better) c.best = c.tried;
            if (c.tried != Contender<Scalar>::kNone)
                c.reached[c.tried] = std::max(c.reached[c.tried], log_odds);
        }
    }

    Contender<Scalar>* const* contenders_;
    int size_;
    const Policy* policy_;
    Scalar rest_[kMaxContenders + 1];  // the most that contenders from here on can bring
    Scalar best_ = -std::numeric_limits<Scalar>::max() / 2;
    int nodes_ = 0;
};

}  // namespace pilotage
