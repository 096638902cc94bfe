// What is measured of the pose without markers: positions, headings, poses, ranges to walls.

#include <algorithm>

#include "support/localizers.hpp"
#include "support/random.hpp"
#include "support/robots.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_LOCALIZER_SUITE(FixTest);

/// A room of 10 m by 10 m.
const WallMap kRoom({{-5, -3, 5, -3}, {5, -3, 5, 7}, {5, 7, -5, 7}, {-5, 7, -5, -3}});

Params sensor_params(Measures measures) {
    Params params = plain_params();
    params.initial.sigma_position_m = 0.3;
    params.initial.sigma_heading_rad = 0.1;
    SensorParams& sensor = params.sensors[0];
    sensor.measures = measures;
    sensor.x_m = 0.4;
    sensor.y_m = -0.2;
    sensor.yaw_rad = 0.3;
    sensor.sigma_position_m = 0.02;
    sensor.sigma_heading_rad = 0.01;
    sensor.sigma_range_m = 0.02;
    return params;
}

/// The pose of the sensor on a robot.
Pose<double> mounted(const Pose<double>& robot, const SensorParams& sensor) {
    const double c = std::cos(robot[kHeading]), s = std::sin(robot[kHeading]);
    return {robot[kX] + c * sensor.x_m - s * sensor.y_m,
            robot[kY] + s * sensor.x_m + c * sensor.y_m, robot[kHeading] + sensor.yaw_rad};
}

/// Range along a beam to the walls of the room, by its sides.
double to_wall(const Pose<double>& sensor, double angle_rad) {
    const double c = std::cos(sensor[kHeading] + angle_rad),
                 s = std::sin(sensor[kHeading] + angle_rad);
    const double across = c > 0 ? (5 - sensor[kX]) / c : (-5 - sensor[kX]) / c;
    const double along = s > 0 ? (7 - sensor[kY]) / s : (-3 - sensor[kY]) / s;
    return std::min(across, along);
}

/// What the sensor says at a pose: alternately its position, its heading, both, or three beams.
std::vector<Sample> measured(std::int64_t utime, const Pose<double>& robot,
                             const SensorParams& sensor, int i) {
    const Pose<double> at = mounted(robot, sensor);
    if (sensor.measures == Measures::walls) {
        std::vector<Sample> beams;
        for (std::uint16_t k = 0; k < 3; ++k)
            beams.push_back(beam_at(utime, 2.0 * k - 0.3, to_wall(at, 2.0 * k - 0.3), k));
        return beams;
    }
    Pose<double> value = at;
    if (i % 3 == 0) value[kHeading] = kNan;
    if (i % 3 == 1) value[kX] = value[kY] = kNan;
    return {fix_at(utime, value, i)};
}

/// On an arc, a measurement every tenth of a second between the motion samples.
std::vector<Sample> drive_with(const Params& params, const Pose<double>& start) {
    std::vector<Sample> samples = drive(500, 9, 11);
    for (int i = 1; i < 99; ++i) {
        const std::int64_t t = i * 100'003;
        const Pose<double> at = after_arc(start, 0.5e-6 * double(t), 0.2e-6 * double(t));
        for (const Sample& sample : measured(t, at, params.sensors[0], i))
            samples.push_back(sample);
    }
    std::sort(samples.begin(), samples.end(), InOrder{});
    return samples;
}

TEST_P(FixTest, WithoutNoiseKeepTheTruth) {
    for (const Filter filter : {Filter::ekf, Filter::ukf})
        for (const Measures measures : {Measures::pose, Measures::walls}) {
            Params params = sensor_params(measures);
            params.filter = filter;
            params.initial.sigma_position_m = params.initial.sigma_heading_rad = 0;
            Robot robot(GetParam(), params, {}, kRoom);
            for (const Sample& sample : drive_with(params, {0, 0, 0})) {
                if (!robot.add(sample)) continue;
                const double t = double(sample.utime) * 1e-6;
                // The mean over a covariance is not the value at the mean: of an arc a little, of a
                // range about a corner more.
                const double tolerance = filter == Filter::ekf         ? GetParam().tolerance
                                         : measures == Measures::walls ? 0.01
                                                                       : 1e-3;
                ASSERT_TRUE(
                    same_pose(robot.pose(), after_arc({0, 0, 0}, 0.5 * t, 0.2 * t), tolerance));
            }
            EXPECT_EQ(robot.tally.rejected(), 0);
            expect_sums_hold(robot);
        }
}

TEST_P(FixTest, EndAnErrorOfTheStart) {
    for (const Filter filter : {Filter::ekf, Filter::ukf})
        for (const Measures measures : {Measures::pose, Measures::walls}) {
            Params params = sensor_params(measures);
            params.filter = filter;
            const Pose<double> start(0.3, -0.2, 0.08);
            Robot robot(GetParam(), params, {}, kRoom);
            robot.add(drive_with(params, start));
            EXPECT_TRUE(same_pose(robot.pose(), after_arc(start, 5, 2), 0.02));
            EXPECT_EQ(robot.estimate().status, Status::ok) << "confirmed without any marker";
        }
}

TEST_P(FixTest, AreReportedWithTheirInnovation) {
    const Params params = sensor_params(Measures::pose);
    Robot robot(GetParam(), params);
    robot.add(encoders_at(0, 0, 0));
    robot.add(fix_at(1, {0.5, kNan, kNan}));
    robot.add(fix_at(2, mounted({0.1, 0.2, 0}, params.sensors[0]), 1));
    robot.add(encoders_at(kPeriod, 0, 0));
    ASSERT_EQ(robot.tally.reports.size(), 2U);
    EXPECT_EQ(robot.tally.reports[0].verdict, Verdict::bad_value) << "half a position";
    const SightingReport& report = robot.tally.reports[1];
    EXPECT_EQ(report.verdict, Verdict::fused);
    EXPECT_EQ(report.id, kUnknownId);
    EXPECT_EQ(report.dof, 3);
    EXPECT_NEAR(report.innovation[kX], 0.1, 1e-6);
    EXPECT_NEAR(report.innovation[kY], 0.2, 1e-6);
    EXPECT_NEAR(report.innovation[kHeading], 0, 1e-6);
    EXPECT_GT(report.sigma[kX], 0.3) << "of the start and of the fix";
}

TEST_P(FixTest, AWholePoseIsAStart) {
    Params params = sensor_params(Measures::pose);
    params.initial = {};
    Robot robot(GetParam(), params);
    robot.add(encoders_at(0, 0, 0));
    const Pose<double> true_pose(3, -2, 2.5);
    const Pose<double> sensor = mounted(true_pose, params.sensors[0]);
    const Sample position = fix_at(1, {sensor[kX], sensor[kY], kNan});
    robot.add(position);
    robot.add(encoders_at(kPeriod, 0, 0));
    EXPECT_EQ(robot.tally.of(position), Verdict::not_initialized);
    EXPECT_FALSE(robot.has_pose());
    robot.add(fix_at(kPeriod + 1, sensor));
    robot.add(encoders_at(2 * kPeriod, 0, 0));
    EXPECT_TRUE(same_pose(robot.pose(), true_pose, 1e-5));
    const SightingReport& report = robot.tally.reports.back();
    EXPECT_EQ(report.verdict, Verdict::fused);
    EXPECT_EQ(report.dof, 0) << "there was nothing to hold it against";
    EXPECT_EQ(report.nis, 0) << "means over reports stay numbers";
    const double lever_m = std::hypot(0.4, 0.2);
    EXPECT_NEAR(robot.covariance().topLeftCorner(2, 2).trace(),
                2 * 0.02 * 0.02 + lever_m * lever_m * 0.01 * 0.01, 1e-6)
        << "a heading's error moves the robot about the sensor";
    EXPECT_EQ(robot.estimate().status, Status::initializing) << "one fix confirms nothing";
}

TEST_P(FixTest, ABeamThatMeetsNoWallIsRejected) {
    Robot robot(GetParam(), sensor_params(Measures::walls), {}, WallMap({{2, -5, 2, 5}}));
    robot.add(encoders_at(0, 0, 0));
    const Sample away = beam_at(1, kPi<double>, 2), grazing = beam_at(2, 1.26, 20),
                 good = beam_at(3, -0.3, 1.6);
    for (const Sample& beam : {away, grazing, good}) robot.add(beam);
    robot.add(encoders_at(kPeriod, 0, 0));
    EXPECT_EQ(robot.tally.of(away), Verdict::no_match);
    EXPECT_EQ(robot.tally.of(grazing), Verdict::no_match);
    EXPECT_EQ(robot.tally.of(good), Verdict::fused);
}

TEST_P(FixTest, ArrivalOrderDoesNotMatter) {
    for (const Measures measures : {Measures::pose, Measures::walls}) {
        const Params params = sensor_params(measures);
        const std::vector<Sample> samples = drive_with(params, {0.3, -0.2, 0.08});
        Robot in_order(GetParam(), params, {}, kRoom), shuffled(GetParam(), params, {}, kRoom);
        in_order.add(samples);
        Draw draw(1);
        std::vector<std::pair<double, Sample>> arrivals;
        for (const Sample& sample : samples)
            arrivals.emplace_back(
                double(sample.utime) +
                    (sample.stream == Stream::motion ? 0 : draw.uniform(0, 1'500'000)),
                sample);
        std::stable_sort(arrivals.begin(), arrivals.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        for (const auto& [arrival, sample] : arrivals) shuffled.add(sample);
        EXPECT_EQ(shuffled.state(), in_order.state());
        EXPECT_EQ(shuffled.covariance(), in_order.covariance());
        EXPECT_EQ(shuffled.tally.rejected(), in_order.tally.rejected());
    }
}

TEST_P(FixTest, NoiseIsLearnedFromThem) {
    Params params = sensor_params(Measures::pose);
    params.noise.adaptation = NoiseAdaptation::on;
    params.sensors[0].x_m = params.sensors[0].y_m = params.sensors[0].yaw_rad = 0;
    Robot robot(GetParam(), params);
    Draw draw(2);
    for (int i = 0; i < 4000; ++i) {
        robot.add(encoders_at(i * kPeriod, i * 10, i * 10, i));
        const double x = 0.01 * i + draw.normal<double, 1>()[0] * 0.04,
                     y = draw.normal<double, 1>()[0] * 0.04;
        robot.add(fix_at(i * kPeriod, {x, y, draw.normal<double, 1>()[0] * 0.02}, i));
    }
    EXPECT_NEAR(robot.noise().sensor(0), 2, 0.4) << "twice as noisy as configured";
}

}  // namespace
}  // namespace pilotage::test
