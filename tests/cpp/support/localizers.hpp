#pragma once
/// \file
/// Every localizer there is behind one interface, and a listener that checks the bookkeeping.

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <variant>
#include <vector>

#include "pilotage/localizer.hpp"
#include "support/matchers.hpp"
#include "support/samples.hpp"

namespace pilotage::test {

/// One of the four localizers.
struct LocalizerKind {
    bool is_double;
    int states;
    double tolerance;  ///< rounding over a drive of some thousand steps
};

inline constexpr LocalizerKind kKinds[] = {{true, kPoseStates, 1e-9},
                                           {true, kCalibratedStates, 1e-9},
                                           {false, kPoseStates, 2e-3},
                                           {false, kCalibratedStates, 2e-3}};

[[nodiscard]] std::string kind_name(const ::testing::TestParamInfo<LocalizerKind>& kind);

/// Hears what becomes of each sample. A sample that the localizer has not
/// spoken of is pending.
class Tally final : public Listener {
   public:
    std::vector<SightingReport> reports;

    void on_verdict(const Sample& sample, Verdict before, Verdict now) override;
    void on_sighting(const SightingReport& report) override;

    [[nodiscard]] int count(Verdict verdict) const;
    [[nodiscard]] int rejected() const;
    [[nodiscard]] Verdict of(const Sample& sample) const;
    [[nodiscard]] const std::map<Sample, Verdict, InOrder>& verdicts() const { return verdicts_; }

   private:
    std::map<Sample, Verdict, InOrder> verdicts_;
    int duplicates_ = 0;
};

/// A localizer of any kind with its listener.
class Robot {
   public:
    Tally tally;

    Robot(const LocalizerKind& kind, const Params& params, const MarkerMap& map = {},
          const WallMap& walls = {});

    bool add(const Sample& sample);
    void add(const std::vector<Sample>& samples);
    /// As of one message.
    bool add_together(const std::vector<Sample>& samples);
    void finish();
    void set_time(std::int64_t utime);
    [[nodiscard]] Checkpoint checkpoint() const;
    [[nodiscard]] bool restore(const Checkpoint& from);
    [[nodiscard]] int added() const { return added_; }

    [[nodiscard]] bool has_pose() const;
    [[nodiscard]] bool started() const;
    [[nodiscard]] Estimate estimate() const;
    [[nodiscard]] Estimate estimate(std::int64_t utime) const;
    [[nodiscard]] NoiseScale noise() const;
    [[nodiscard]] Pose<double> pose() const { return estimate().pose; }
    [[nodiscard]] Eigen::VectorXd state() const;
    [[nodiscard]] Eigen::MatrixXd covariance() const;

   private:
    using Any = std::variant<Localizer<double, kPoseStates>, Localizer<double, kCalibratedStates>,
                             Localizer<float, kPoseStates>, Localizer<float, kCalibratedStates>>;
    static Any make(const LocalizerKind& kind, const Params& params, const MarkerMap& map,
                    const WallMap& walls, Tally& tally);

    Any localizer_;
    int added_ = 0;
};

/// Every sample that was added is fused, pending or rejected, and only one of them.
void expect_sums_hold(const Robot& robot);

}  // namespace pilotage::test

/// Declares a suite that runs for every localizer, `GetParam()`.
#define PILOTAGE_LOCALIZER_SUITE(Suite)                                                \
    class Suite : public ::testing::TestWithParam<::pilotage::test::LocalizerKind> {}; \
    INSTANTIATE_TEST_SUITE_P(, Suite, ::testing::ValuesIn(::pilotage::test::kKinds),   \
                             ::pilotage::test::kind_name)
