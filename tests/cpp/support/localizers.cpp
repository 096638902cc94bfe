#include "support/localizers.hpp"

namespace pilotage::test {

std::string kind_name(const ::testing::TestParamInfo<LocalizerKind>& kind) {
    return (kind.param.is_double ? "double" : "float") + std::to_string(kind.param.states);
}

void Tally::on_verdict(const Sample& sample, Verdict before, Verdict now) {
    EXPECT_NE(before, now) << "a verdict that changes nothing";
    if (now == Verdict::duplicate) {  // says nothing of the sample that it repeats
        EXPECT_EQ(before, Verdict::pending);
        ++duplicates_;
        return;
    }
    Verdict& verdict = verdicts_.emplace(sample, Verdict::pending).first->second;
    EXPECT_EQ(before, verdict) << "a " << name(now) << " that follows another verdict";
    verdict = now;
}

void Tally::on_sighting(const SightingReport& report) {
    reports.push_back(report);
}

int Tally::count(Verdict verdict) const {
    int n = verdict == Verdict::duplicate ? duplicates_ : 0;
    for (const auto& [sample, v] : verdicts_) n += v == verdict;
    return n;
}

int Tally::rejected() const {
    int n = duplicates_;
    for (const auto& [sample, v] : verdicts_) n += pilotage::rejected(v);
    return n;
}

Verdict Tally::of(const Sample& sample) const {
    const auto at = verdicts_.find(sample);
    return at == verdicts_.end() ? Verdict::pending : at->second;
}

Robot::Any Robot::make(const LocalizerKind& kind, const Params& params, const MarkerMap& map,
                       const WallMap& walls, Tally& tally) {
    const bool pose_only = kind.states == kPoseStates;
    if (kind.is_double && pose_only) return Any(std::in_place_index<0>, params, map, tally, walls);
    if (kind.is_double) return Any(std::in_place_index<1>, params, map, tally, walls);
    if (pose_only) return Any(std::in_place_index<2>, params, map, tally, walls);
    return Any(std::in_place_index<3>, params, map, tally, walls);
}

Robot::Robot(const LocalizerKind& kind, const Params& params, const MarkerMap& map,
             const WallMap& walls)
    : localizer_(make(kind, params, map, walls, tally)) {}

bool Robot::add(const Sample& sample) {
    ++added_;
    return std::visit([&](auto& localizer) { return localizer.add(sample); }, localizer_);
}

void Robot::add(const std::vector<Sample>& samples) {
    for (const Sample& sample : samples) add(sample);
}

bool Robot::add_together(const std::vector<Sample>& samples) {
    added_ += static_cast<int>(samples.size());
    return std::visit(
        [&](auto& localizer) { return localizer.add(samples.data(), samples.size()); }, localizer_);
}

void Robot::finish() {
    std::visit([](auto& localizer) { localizer.finish(); }, localizer_);
}

void Robot::set_time(std::int64_t utime) {
    std::visit([&](auto& localizer) { localizer.set_time(utime); }, localizer_);
}

Checkpoint Robot::checkpoint() const {
    return std::visit([](const auto& localizer) { return localizer.checkpoint(); }, localizer_);
}

bool Robot::restore(const Checkpoint& from) {
    return std::visit([&](auto& localizer) { return localizer.restore(from); }, localizer_);
}

bool Robot::has_pose() const {
    return std::visit([](const auto& localizer) { return localizer.has_pose(); }, localizer_);
}

bool Robot::started() const {
    return std::visit([](const auto& localizer) { return localizer.started(); }, localizer_);
}

Estimate Robot::estimate() const {
    return std::visit([](const auto& localizer) { return localizer.estimate(); }, localizer_);
}

Estimate Robot::estimate(std::int64_t utime) const {
    return std::visit([&](const auto& localizer) { return localizer.estimate(utime); }, localizer_);
}

NoiseScale Robot::noise() const {
    return std::visit([](const auto& localizer) { return localizer.noise(); }, localizer_);
}

Eigen::VectorXd Robot::state() const {
    return std::visit(
        [](const auto& localizer) -> Eigen::VectorXd {
            return localizer.filter().state().template cast<double>();
        },
        localizer_);
}

Eigen::MatrixXd Robot::covariance() const {
    return std::visit(
        [](const auto& localizer) -> Eigen::MatrixXd {
            return localizer.filter().covariance().template cast<double>();
        },
        localizer_);
}

void expect_sums_hold(const Robot& robot) {
    const Tally& tally = robot.tally;
    const int unheard =
        robot.added() - tally.count(Verdict::duplicate) - static_cast<int>(tally.verdicts().size());
    EXPECT_GE(unheard, 0) << "more verdicts than samples";
    EXPECT_EQ(robot.added(), tally.count(Verdict::fused) + tally.rejected() +
                                 tally.count(Verdict::pending) + unheard);
}

}  // namespace pilotage::test
