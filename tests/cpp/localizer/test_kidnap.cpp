// A robot that is carried off unnoticed while it drives: sightings tell, and tell where to.

#include <algorithm>

#include "support/journeys.hpp"
#include "support/localizers.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_LOCALIZER_SUITE(KidnapTest);

const MarkerMap kFiveMarkers({{1, 6, 2, 0.4, 0},
                              {2, -3, 5, 0.3, 0},
                              {3, 4, -4, 0.2, 0},
                              {4, -7, -2, 0.4, 0},
                              {5, 14, 9, 0.3, 0}});

/// In metres, with the heading counted as a metre for each 20 degrees.
double off_by(const Pose<double>& a, const Pose<double>& b) {
    const Pose<double> off = minus(a, b);
    return std::max(off.head<2>().norm(), std::abs(off[kHeading]) / 0.35);
}

/// Drives a bend and sees some of the markers in each frame.
class Drive {
   public:
    explicit Drive(const LocalizerKind& kind, std::size_t in_view = 2, unsigned seed = 1)
        : robot(kind, gyro_params(), kFiveMarkers), journey(seen_, seed), in_view_(in_view) {}

    Robot robot;
    Journey journey;

    /// Until the next frame is fused; the markers in it change.
    Estimate frame() {
        std::vector<Marker> seen;
        for (std::size_t i = 0; i < in_view_; ++i)
            seen.push_back(kFiveMarkers.markers()[(first_ + i) % kFiveMarkers.markers().size()]);
        if (++frames_ % 10 == 0) ++first_;
        seen_ = MarkerMap(seen);
        robot.add(journey.go(0.1, 0.5, 0.2));
        return robot.estimate();
    }

    [[nodiscard]] double error() const { return off_by(robot.pose(), journey.truth); }

   private:
    MarkerMap seen_;
    std::size_t in_view_, first_ = 0;
    int frames_ = 0;
};

struct Carried {
    const char* name;
    Pose<double> by;
};

TEST_P(KidnapTest, IsNotOkFromTheThirdFrameOnUntilItIsFoundAgainWithinFiveSeconds) {
    for (const Carried& carried :
         {Carried{"3 m", {3, 0, 0}}, Carried{"15 m", {-9, 12, 0}}, Carried{"40 deg", {0, 0, 0.7}},
          Carried{"3 m and 40 deg", {0, -3, -0.7}}, Carried{"round", {1, 1, 3}}})
        for (const std::size_t in_view : {2U, 3U})
            for (unsigned seed = 1; seed <= 3; ++seed) {
                SCOPED_TRACE(carried.name + std::string(", seed ") + std::to_string(seed) + ", " +
                             std::to_string(in_view) + " in view");
                Drive drive(GetParam(), in_view, seed);
                for (int i = 0; i < 50; ++i) drive.frame();
                ASSERT_EQ(drive.robot.estimate().status, Status::ok);
                drive.journey.truth += carried.by;
                drive.journey.truth[kHeading] = wrap(drive.journey.truth[kHeading]);
                int frames = 0;
                for (bool found = false; !found && frames < 50; ++frames) {
                    const Estimate e = drive.frame();
                    found = e.status == Status::ok && drive.error() < 0.5;
                    EXPECT_TRUE(found || frames < 2 || e.status != Status::ok)
                        << "OK and " << drive.error() << " m off after frame " << frames + 1;
                }
                EXPECT_LT(frames, 50) << drive.error() << " m off";
                for (int i = 0; i < 20; ++i) {
                    const Estimate e = drive.frame();
                    EXPECT_TRUE(e.status != Status::ok ||
                                contradiction(e.pose, e.covariance, drive.journey.truth) < kRare);
                }
                EXPECT_EQ(drive.robot.estimate().status, Status::ok);
                EXPECT_EQ(drive.robot.estimate().resets, 1) << "counted once";
                EXPECT_EQ(drive.robot.estimate().found, 1) << "and as its own";
                EXPECT_LT(drive.error(), 0.3);
                expect_sums_hold(drive.robot);
            }
}

TEST_P(KidnapTest, KeepsTheCalibrationThatWasLearnt) {
    if (GetParam().states == kPoseStates) return;
    Params params = gyro_params();
    params.gyro_bias.sigma = 0.02;
    Robot robot(GetParam(), params, kFiveMarkers);
    Journey journey(kFiveMarkers);
    journey.gyro_bias = 0.01;
    robot.add(journey.go(20, 0.5, 0.2));
    const double bias = robot.state()[kGyroBias];
    EXPECT_NEAR(bias, 0.01, 0.002);
    journey.truth[kX] += 4;
    robot.add(journey.go(3, 0.5, 0.2));
    EXPECT_EQ(robot.estimate().resets, 1);
    EXPECT_NEAR(robot.state()[kGyroBias], bias, 0.003);
}

TEST_P(KidnapTest, AFifthOfOutliersNeitherMovesItNorMakesItLostForLong) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
        Robot robot(GetParam(), gyro_params(), kFiveMarkers);
        Journey journey(kFiveMarkers, seed);
        Draw draw(seed);
        int not_ok = 0, lost = 0, lost_in_a_row = 0;
        for (int frame = 0; frame < 600; ++frame) {
            for (Sample sample : journey.go(0.1, 0.5, 0.2)) {
                if (sample.stream == Stream::sighting && draw.uniform(0, 1) < 0.2) {
                    sample.payload.sighting.value[0] = draw.uniform(-3.1, 3.1);
                    sample.payload.sighting.value[2] = draw.uniform(1, 20);
                }
                robot.add(sample);
            }
            const Estimate e = robot.estimate();
            not_ok += e.status != Status::ok;
            lost_in_a_row = e.status == Status::lost ? lost_in_a_row + 1 : 0;
            lost = std::max(lost, lost_in_a_row);
            ASSERT_LT(off_by(e.pose, journey.truth), 0.35) << "frame " << frame;
        }
        EXPECT_LE(not_ok, 30) << "of 600 frames, seed " << seed;
        EXPECT_LE(lost, 10) << "a second";
        EXPECT_EQ(robot.estimate().resets, 0);
    }
}

TEST_P(KidnapTest, APoseFromOutsideThatIsWrongByAMetreIsCorrected) {
    for (const Pose<double>& wrong :
         {Pose<double>(1, 0, 0), Pose<double>(0, -1, 0), Pose<double>(0.7, 0.7, 0.3)}) {
        Drive drive(GetParam());
        for (int i = 0; i < 30; ++i) drive.frame();
        drive.robot.add(
            reset_at(drive.journey.utime + 1, drive.journey.truth + wrong, {0.1, 0.1, 0.05}));
        int frames = 0;
        for (bool right = false; !right && frames < 50; ++frames) {
            const Estimate e = drive.frame();
            right = e.status == Status::ok;
            EXPECT_TRUE(!right || drive.error() < 0.4) << drive.error() << " m off";
        }
        EXPECT_LT(frames, 50);
        for (int i = 0; i < 20; ++i) drive.frame();
        EXPECT_LT(drive.error(), 0.15);
        const Estimate e = drive.robot.estimate();
        EXPECT_LE(e.found, 1);
        EXPECT_EQ(e.resets, 1 + e.found) << "the operator's and its own";
    }
}

/// Times of what was seen and searched for are of the clock that dates them.
TEST_P(KidnapTest, IsFoundAgainAfterTheClockWasSet) {
    for (const std::int64_t by : {-3600 * kSecond, 3600 * kSecond}) {
        Robot robot(GetParam(), gyro_params(), kFiveMarkers);
        Journey journey(kFiveMarkers);
        robot.add(journey.go(5, 0.5, 0.2));
        robot.add(reset_at(journey.utime + 1, journey.truth, {0.1, 0.1, 0.05}));
        robot.add(journey.go(5, 0.5, 0.2));
        ASSERT_EQ(robot.estimate().status, Status::ok);
        journey.utime += by;
        robot.set_time(journey.utime);
        robot.add(journey.go(2, 0.5, 0.2));
        journey.truth[kX] += 3;
        robot.add(journey.go(5, 0.5, 0.2));
        EXPECT_EQ(robot.estimate().status, Status::ok);
        EXPECT_LT(off_by(robot.pose(), journey.truth), 0.3);
    }
}

/// How far a search looks back is no matter of what the history still has.
TEST_P(KidnapTest, IsFoundAgainInWhateverOrderThingsArrive) {
    const std::vector<Marker>& all = kFiveMarkers.markers();
    MarkerMap seen({all.begin(), all.begin() + 2});
    Journey journey(seen, 4);
    std::vector<Sample> samples = journey.go(4, 0.5, 0.2);
    const auto more = [&](const std::vector<Sample>& s) {
        samples.insert(samples.end(), s.begin(), s.end());
    };
    seen = MarkerMap({all.begin() + 2, all.end()});
    more(journey.go(4, 0.5, 0.2));
    journey.truth[kX] += 3;
    more(journey.go(3, 0.5, 0.2));
    Robot in_order(GetParam(), gyro_params(), kFiveMarkers);
    in_order.add(samples);
    EXPECT_EQ(in_order.estimate().found, 1);
    for (const unsigned seed : {1U, 2U, 3U}) {
        Draw draw(seed);
        std::vector<std::pair<double, std::size_t>> arrival;
        for (std::size_t i = 0; i < samples.size(); ++i)
            arrival.emplace_back(double(samples[i].utime) + draw.uniform(0, 0.95e6 * seed / 2), i);
        std::sort(arrival.begin(), arrival.end());
        Robot late(GetParam(), gyro_params(), kFiveMarkers);
        for (const auto& [time, i] : arrival) late.add(samples[i]);
        EXPECT_TRUE(close(late.state(), in_order.state(), GetParam().is_double ? 1e-9 : 1e-4));
        EXPECT_EQ(late.estimate().found, 1);
        expect_sums_hold(late);
    }
}

}  // namespace
}  // namespace pilotage::test
