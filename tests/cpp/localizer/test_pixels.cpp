// Pixels of markers through the localizer: fused, recognised, searched with, refused.

#include <algorithm>

#include "support/images.hpp"
#include "support/localizers.hpp"
#include "support/sighting_drives.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_LOCALIZER_SUITE(PixelTest);

Params filmed_params() {
    Params params = gyro_params();
    params.sensors[0] = camera_sensor();
    params.initial.sigma_position_m = 0.3;
    params.initial.sigma_heading_rad = 0.1;
    return params;
}

/// Each way to tell which marker a pixel is of.
struct Way {
    bool ids;
    double radius_px;
};
constexpr Way kWays[] = {{true, 0}, {false, 0}, {false, 64}};

TEST_P(PixelTest, EndAnErrorOfTheStart) {
    const MarkerMap& map = kYard;
    for (const Filter filter : {Filter::ekf, Filter::ukf})
        for (const Way& way : kWays) {
            Params params = filmed_params();
            params.filter = filter;
            params.sensors[0].association_radius_pixel = way.radius_px;
            FilmedJourney film(map, params.sensors[0]);
            film.ids = way.ids;
            film.journey.truth = {0.15, -0.1, 0.03};
            Robot robot(GetParam(), params, map);
            robot.add(film.go(10, 0.4, 0.3));
            EXPECT_TRUE(same_pose(robot.pose(), film.journey.truth, 0.05));
            EXPECT_EQ(robot.estimate().status, Status::ok);
            EXPECT_LT(contradiction(robot.pose(), robot.estimate().covariance, film.journey.truth),
                      kRare);
            EXPECT_GT(robot.tally.count(Verdict::fused), 200);
            expect_sums_hold(robot);
        }
}

TEST_P(PixelTest, FindAPoseFromNothingAndAfterTheRobotWasCarriedOff) {
    const MarkerMap& map = kYard;
    for (const bool ids : {true, false}) {
        Params params = filmed_params();
        params.initial = {};
        FilmedJourney film(map, params.sensors[0]);
        film.ids = ids;
        film.journey.truth = {-3, 2, 1};
        Robot robot(GetParam(), params, map);
        robot.add(film.go(8, 0.5, 0.4));
        EXPECT_TRUE(same_pose(robot.pose(), film.journey.truth, 0.1)) << ids;
        EXPECT_EQ(robot.estimate().status, Status::ok);
        const auto found = robot.estimate().resets;
        film.journey.truth = {2, 1, -2};
        robot.add(film.go(10, 0.5, 0.4));
        EXPECT_TRUE(same_pose(robot.pose(), film.journey.truth, 0.1)) << ids;
        EXPECT_EQ(robot.estimate().status, Status::ok);
        EXPECT_GT(robot.estimate().resets, found);
    }
}

TEST_P(PixelTest, ThatAreNoneAreRefusedByReason) {
    const MarkerMap map({{1, 5, 0, 0.5, 0}, {2, -5, 0, 0.5, 0}});
    Params params = filmed_params();
    Robot robot(GetParam(), params, map);
    robot.add(encoders_at(0, 0, 0));
    const std::pair<Sample, Verdict> cases[] = {
        {pixel_at(1, 1, {kNan, 5}), Verdict::bad_value},
        {pixel_at(2, 1, {5, kInf}), Verdict::bad_value},
        {pixel_at(3, 1, {-0.6, 5}), Verdict::outside_image},
        {pixel_at(4, 1, {5, 479.6}), Verdict::outside_image},
        {pixel_at(5, 1, {1e300, 5}), Verdict::outside_image},
        {pixel_at(6, 3, {5, 5}), Verdict::unknown_marker},
        {pixel_at(7, 2, {5, 5}), Verdict::out_of_view}};
    for (const auto& [sample, verdict] : cases) robot.add(sample);
    Sample bad_sigma = pixel_at(8, 1, {5, 5});
    bad_sigma.payload.sighting.sigma[1] = 0;
    robot.add(bad_sigma);
    robot.add(encoders_at(kPeriod, 0, 0));
    for (const auto& [sample, verdict] : cases) EXPECT_EQ(robot.tally.of(sample), verdict);
    EXPECT_EQ(robot.tally.of(bad_sigma), Verdict::bad_value);
    EXPECT_EQ(robot.tally.count(Verdict::fused), 2) << "the motion";
    expect_sums_hold(robot);
}

/// A lens that shows the same twice, and a sensor whose camera is missing.
TEST_P(PixelTest, WhereTheCameraShowsNothingAreOutsideTheImage) {
    Params params = filmed_params();
    Intrinsics barrel = params.sensors[0].camera.intrinsics();
    barrel.distortion = {-0.4, 0, 0, 0, 0, 0, 0, 0};
    params.sensors[0].camera = {barrel, 0, 0};
    Robot folded(GetParam(), params, kYard);
    params.sensors[0].camera = {};
    Robot blind(GetParam(), params, kYard);
    const Sample corner = pixel_at(1, 1, {2, 2});
    for (Robot* robot : {&folded, &blind}) {
        robot->add(corner);
        EXPECT_EQ(robot->tally.of(corner), Verdict::outside_image);
    }
}

TEST_P(PixelTest, ArrivalOrderDoesNotMatter) {
    const MarkerMap& map = kYard;
    for (const Way& way : kWays) {
        Params params = filmed_params();
        params.sensors[0].association_radius_pixel = way.radius_px;
        FilmedJourney film(map, params.sensors[0]);
        film.ids = way.ids;
        const std::vector<Sample> ordered = film.go(6, 0.4, 0.4);
        std::vector<std::pair<double, Sample>> arrivals;
        Draw draw(8);
        for (const Sample& sample : ordered)
            arrivals.emplace_back(
                double(sample.utime) +
                    (sample.stream == Stream::sighting ? draw.uniform(0, 1'500'000) : 0),
                sample);
        std::stable_sort(arrivals.begin(), arrivals.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        Robot in_order(GetParam(), params, map), late(GetParam(), params, map);
        in_order.add(ordered);
        for (const auto& [time, sample] : arrivals) late.add(sample);
        for (Robot* robot : {&in_order, &late}) robot->finish();
        EXPECT_EQ(in_order.state(), late.state());
        EXPECT_EQ(in_order.covariance(), late.covariance());
        for (const auto& [sample, verdict] : in_order.tally.verdicts())
            EXPECT_EQ(late.tally.of(sample), verdict);
    }
}

TEST_P(PixelTest, NoiseIsLearnedFromThem) {
    const MarkerMap& map = kYard;
    Params params = filmed_params();
    params.noise.adaptation = NoiseAdaptation::on;
    FilmedJourney film(map, params.sensors[0]);
    film.sigma_px = 1;
    Robot robot(GetParam(), params, map);
    robot.add(film.go(60, 0.4, 0.3));
    EXPECT_NEAR(robot.noise().sensor(0), 2, 0.4) << "twice as noisy as configured";
}

}  // namespace
}  // namespace pilotage::test
