#pragma once
/// \file
/// Every localizer there is as a type of a typed suite, and a listener that
/// checks the bookkeeping.

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

#include "pilotage/localizer.hpp"
#include "support/matchers.hpp"
#include "support/samples.hpp"

namespace pilotage::test {

template <typename S, int N> struct Kind {
  using Scalar = S;
  static constexpr int kStates = N;
  static constexpr bool kDouble = std::is_same_v<S, double>;
  /// Rounding over a drive of some thousand steps.
  static constexpr double kTolerance = kDouble ? 1e-9 : 2e-3;
};

using Kinds =
    ::testing::Types<Kind<double, kPoseStates>, Kind<double, kCalibratedStates>,
                     Kind<float, kPoseStates>, Kind<float, kCalibratedStates>>;

struct KindNames {
  template <typename T> static std::string GetName(int) {
    return (T::kDouble ? "double" : "float") + std::to_string(T::kStates);
  }
};

/// Hears what becomes of each sample. A sample that the localizer has not
/// spoken of is pending.
class Tally final : public Listener {
public:
  std::vector<SightingReport> reports;

  void on_verdict(const Sample &sample, Verdict before, Verdict now) override {
    EXPECT_NE(before, now) << "a verdict that changes nothing";
    if (now ==
        Verdict::duplicate) { // says nothing of the sample that it repeats
      EXPECT_EQ(before, Verdict::pending);
      ++duplicates_;
      return;
    }
    Verdict &verdict =
        verdicts_.emplace(sample, Verdict::pending).first->second;
    EXPECT_EQ(before, verdict)
        << "a " << name(now) << " that follows another verdict";
    verdict = now;
  }
  void on_sighting(const SightingReport &report) override {
    reports.push_back(report);
  }

  [[nodiscard]] int count(Verdict verdict) const {
    int n = verdict == Verdict::duplicate ? duplicates_ : 0;
    for (const auto &[sample, v] : verdicts_)
      n += v == verdict;
    return n;
  }
  [[nodiscard]] int rejected() const {
    int n = duplicates_;
    for (const auto &[sample, v] : verdicts_)
      n += pilotage::rejected(v);
    return n;
  }
  [[nodiscard]] Verdict of(const Sample &sample) const {
    const auto at = verdicts_.find(sample);
    return at == verdicts_.end() ? Verdict::pending : at->second;
  }
  [[nodiscard]] const std::map<Sample, Verdict, InOrder> &verdicts() const {
    return verdicts_;
  }

private:
  std::map<Sample, Verdict, InOrder> verdicts_;
  int duplicates_ = 0;
};

/// A localizer with its listener.
template <typename K> struct Robot {
  Tally tally;
  Localizer<typename K::Scalar, K::kStates> localizer;
  int added = 0;

  explicit Robot(const Params &params, MarkerMap map = {})
      : localizer(params, std::move(map), tally) {}

  bool add(const Sample &sample) {
    ++added;
    return localizer.add(sample);
  }
  void add(const std::vector<Sample> &samples) {
    for (const Sample &sample : samples)
      add(sample);
  }
  [[nodiscard]] Pose<double> pose() const { return localizer.estimate().pose; }
  [[nodiscard]] Vector<double, K::kStates> state() const {
    return localizer.filter().state().template cast<double>();
  }
  [[nodiscard]] Matrix<double, K::kStates> covariance() const {
    return localizer.filter().covariance().template cast<double>();
  }
};

/// Every sample that was added is fused, pending or rejected, and only one of
/// them.
template <typename K> void expect_sums_hold(const Robot<K> &robot) {
  const Tally &tally = robot.tally;
  const int unheard = robot.added - tally.count(Verdict::duplicate) -
                      static_cast<int>(tally.verdicts().size());
  EXPECT_GE(unheard, 0);
  EXPECT_EQ(robot.added, tally.count(Verdict::fused) + tally.rejected() +
                             tally.count(Verdict::pending) + unheard);
}

} // namespace pilotage::test

/// Declares a suite that runs for every localizer.
#define PILOTAGE_LOCALIZER_SUITE(Suite)                                        \
  template <typename K> class Suite : public ::testing::Test {};               \
  TYPED_TEST_SUITE(Suite, ::pilotage::test::Kinds, ::pilotage::test::KindNames)
