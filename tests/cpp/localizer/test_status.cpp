// What the status promises, and when it changes.

#include "support/localizers.hpp"
#include "support/robots.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_LOCALIZER_SUITE(StatusTest);

const MarkerMap kLeftAndRight({{1, 6, 2, 0.4, 0}, {2, 6, -2, 0, 0}});

/// A robot that stands, told the time and shown a marker so many times: the two by turns, or one.
void stand(Robot& robot, std::int64_t utime, int shown = 0, bool by_turns = true) {
    for (; shown > 0; --shown) {
        const Marker& marker = kLeftAndRight.markers()[by_turns ? shown % 2 : 0];
        robot.add(sighting_at(utime - shown, marker.id, view({0, 0, 0}, marker)));
    }
    robot.add(encoders_at(utime, 0, 0));
}

constexpr int kConfirming = Agreement::kConfirming;

TEST_P(StatusTest, WaitsForAPoseAndForMotion) {
    Params params = plain_params();
    Robot robot(GetParam(), params, kLeftAndRight);
    EXPECT_EQ(robot.estimate().status, Status::waiting);
    robot.add(gyro_at(0, 0));
    EXPECT_EQ(robot.estimate().status, Status::waiting);
    EXPECT_FALSE(robot.started());
    stand(robot, kPeriod);
    EXPECT_EQ(robot.estimate().status, Status::initializing);
    EXPECT_TRUE(robot.started());
}

TEST_P(StatusTest, IsNotOkBeforeSightingsInARowConfirmThePose) {
    Robot robot(GetParam(), plain_params(), kLeftAndRight);
    for (int i = 0; i < 100; ++i) stand(robot, i * kPeriod);
    EXPECT_EQ(robot.estimate().status, Status::initializing);
    stand(robot, 100 * kPeriod, kConfirming - 1);
    EXPECT_EQ(robot.estimate().reason, Reason::unconfirmed);
    Vector<double, 3> off = view({0, 0, 0}, kLeftAndRight.markers()[0]);
    off[0] += 1;
    robot.add(sighting_at(101 * kPeriod - 1, 1, off));  // the row is broken
    stand(robot, 101 * kPeriod);
    stand(robot, 102 * kPeriod, kConfirming - 1);
    EXPECT_EQ(robot.estimate().status, Status::initializing);
    stand(robot, 103 * kPeriod, 1);
    EXPECT_EQ(robot.estimate().status, Status::ok);
}

TEST_P(StatusTest, IsConfirmedByTwoMarkersWhereTheMapHasThem) {
    for (const bool has_two : {true, false}) {
        Robot robot(GetParam(), plain_params(),
                    has_two ? kLeftAndRight : MarkerMap({kLeftAndRight.markers()[0]}));
        stand(robot, 0);
        stand(robot, kSecond, 3 * kConfirming, false);
        if (has_two) {
            EXPECT_EQ(robot.estimate().status, Status::initializing);
            EXPECT_EQ(robot.estimate().reason, Reason::one_marker);
            EXPECT_EQ(robot.estimate().value, 3 * kConfirming);
            robot.add(sighting_at(kSecond + 1, 2, {2, 0, 1}));  // the other one, somewhere else
            stand(robot, 2 * kSecond, kConfirming, false);
            EXPECT_EQ(robot.estimate().reason, Reason::one_marker);
            stand(robot, 3 * kSecond, 1);
        }
        EXPECT_EQ(robot.estimate().status, Status::ok) << has_two;
    }
}

TEST_P(StatusTest, IsNotConfirmedByARejectedSighting) {
    Robot robot(GetParam(), plain_params(), kLeftAndRight);
    stand(robot, 0);
    robot.add(sighting_at(1, 77, {0.1, 0.1, 5}));
    stand(robot, kPeriod);
    EXPECT_EQ(robot.estimate().status, Status::initializing);
}

TEST_P(StatusTest, BecomesDeadReckoningWithoutSightingsAndOkWithOne) {
    Params params = plain_params();
    params.status.dead_reckoning_after_s = 3;
    Robot robot(GetParam(), params, kLeftAndRight);
    stand(robot, 0);
    stand(robot, kSecond, kConfirming);
    stand(robot, 4 * kSecond - 1);
    EXPECT_EQ(robot.estimate().status, Status::ok);
    stand(robot, 4 * kSecond);
    EXPECT_EQ(robot.estimate().status, Status::dead_reckoning);
    stand(robot, 5 * kSecond, 1);
    EXPECT_EQ(robot.estimate().status, Status::ok);
}

/// 95 % of a plane Gaussian of sigma s lie within 2.4477 s.
TEST_P(StatusTest, IsOkOnlyWhereThe95PercentRadiusIsBelowTheAlertLimit) {
    for (const bool below : {true, false}) {
        Params params = plain_params();
        params.initial.sigma_position_m = 0.2;
        params.sensors[0].sigma_bearing_rad = 1e3;  // confirms and tells nothing
        params.status.alert_limit_m = 0.2 * 2.4477 * (below ? 1.01 : 0.99);
        Robot robot(GetParam(), params, kLeftAndRight);
        stand(robot, 0);
        for (int i = 1; i <= kConfirming; ++i)
            robot.add(sighting_at(i, 1 + i % 2, {0.3, kNan, kNan}));
        stand(robot, kPeriod);
        EXPECT_EQ(robot.estimate().status, below ? Status::ok : Status::dead_reckoning);
    }
}

TEST_P(StatusTest, CountsTheLongAxisOfTheEllipse) {
    Params params = plain_params();
    params.status.alert_limit_m = 1;
    Robot robot(GetParam(), params, kLeftAndRight);
    stand(robot, 0);
    // Along the diagonal sigma is 0.5 m, across it 0.01 m; x and y alone have 0.35 m.
    Sample reset = reset_at(1, {0, 0, 0}, {1, 1, 0.01});
    const double covariance[] = {0.12505, 0.12495, 0.12505, 0, 0, 1e-4};
    std::copy(std::begin(covariance), std::end(covariance), reset.payload.reset.covariance);
    robot.add(reset);
    for (int i = 0; i < kConfirming; ++i) {
        Sample seen = sighting_at(2 + i, 1 + i % 2, {0.3, kNan, kNan});
        seen.payload.sighting.sigma[0] = 1e3;
        robot.add(seen);
    }
    stand(robot, kPeriod);
    EXPECT_EQ(robot.estimate().reason, Reason::unsure);
    EXPECT_EQ(robot.estimate().status, Status::dead_reckoning) << "0.5 m * 2.4477 > 1 m";
}

TEST_P(StatusTest, FallsBackWhenTheDriveMakesThePoseUnsure) {
    Params params = plain_params();
    params.noise.position_m_per_sqrt_m = 0.3;
    params.status.alert_limit_m = 1;
    params.status.dead_reckoning_after_s = 1e6;
    Robot robot(GetParam(), params, kLeftAndRight);
    stand(robot, 0);
    stand(robot, kPeriod, kConfirming);
    bool was_ok = false;
    for (int i = 2; i < 300; ++i) {
        robot.add(encoders_at(i * kPeriod, 10 * (i - 1), 10 * (i - 1)));
        was_ok |= robot.estimate().status == Status::ok;
    }
    EXPECT_TRUE(was_ok);
    EXPECT_EQ(robot.estimate().status, Status::dead_reckoning);
}

}  // namespace
}  // namespace pilotage::test
