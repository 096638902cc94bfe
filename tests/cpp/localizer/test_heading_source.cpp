// Where the change of heading comes from: gyro, wheels, or both, and what happens when the gyro is
// silent.

#include "support/localizers.hpp"
#include "support/random.hpp"
#include "support/robots.hpp"

namespace pilotage::test {
namespace {

PILOTAGE_LOCALIZER_SUITE(HeadingSourceTest);

/// Wheels that say 0.2 rad/s at 0.5 m/s, a gyro that says `rate` beside them.
double heading_after_3_s(const LocalizerKind& kind, HeadingSource source, double rate,
                         Params params = plain_params()) {
    params.motion.heading = source;
    Robot robot(kind, params);
    for (const Sample& motion : drive(150, 9, 11)) {
        robot.add(gyro_at(motion.utime, rate));
        robot.add(motion);
    }
    return robot.pose()[kHeading];
}

TEST_P(HeadingSourceTest, IsTheGyroTheWheelsOrBoth) {
    EXPECT_NEAR(heading_after_3_s(GetParam(), HeadingSource::gyro, 0.3), 0.9, 1e-4);
    EXPECT_NEAR(heading_after_3_s(GetParam(), HeadingSource::wheels, 0.3), 0.6, 1e-4);
    const NoiseParams noise;
    const double gyro = std::pow(noise.gyro_rad_per_sqrt_s, 2);          // per second
    const double wheels = std::pow(noise.wheel_m_per_sqrt_m, 2) / 0.25;  // of 0.45 + 0.55 m
    const double mean = (0.9 / gyro + 0.6 / wheels) / (1 / gyro + 1 / wheels);
    EXPECT_NEAR(heading_after_3_s(GetParam(), HeadingSource::both, 0.3), mean, 1e-4);
}

TEST_P(HeadingSourceTest, SubtractsTheGyrosFrozenBias) {
    Params params = plain_params();
    params.gyro_bias.initial = 0.05;
    EXPECT_NEAR(heading_after_3_s(GetParam(), HeadingSource::gyro, 0.3, params), 0.75, 1e-4);
    EXPECT_NEAR(heading_after_3_s(GetParam(), HeadingSource::wheels, 0.3, params), 0.6, 1e-4);
}

TEST_P(HeadingSourceTest, UsesTheWheelsBeforeTheGyroSpeaksAndWhileItIsSilent) {
    Robot robot(GetParam(), params_with(HeadingSource::gyro));
    double expected = 0;
    std::int64_t last_gyro = -1;
    for (const Sample& motion : drive(400, 9, 11)) {
        const std::int64_t t = motion.utime;
        // Heard from 1 s to 3 s and from 6 s on, 5 ms before the motion sample.
        const bool heard = (t >= kSecond && t < 3 * kSecond) || t >= 6 * kSecond;
        const bool known = t - last_gyro <= kSecond / 2 && last_gyro >= 0;
        if (heard) {
            last_gyro = t - 5000;
            robot.add(gyro_at(last_gyro, 0.3));
        }
        robot.add(motion);
        const bool held = last_gyro >= 0 && t - last_gyro <= kSecond / 2;
        if (t > 0) expected += (known && held ? 0.3 : 0.2) * 0.02;
        ASSERT_NEAR(robot.pose()[kHeading], wrap(expected), 1e-4) << "at " << t << " us";
    }
}

/// The gyro's turn is not lost at its first sample, nor when it comes back: constant turning goes
/// on.
TEST_P(HeadingSourceTest, LosesNoTurnWhenTheGyroComesAndGoes) {
    Robot robot(GetParam(), params_with(HeadingSource::gyro));
    for (const Sample& motion : drive(1000, 9, 11)) {
        if ((motion.utime / kSecond) % 3 == 1) robot.add(gyro_at(motion.utime - 7000, 0.2));
        robot.add(motion);
    }
    EXPECT_TRUE(same_pose(robot.pose(), after_arc({0, 0, 0}, 10, 4), GetParam().tolerance));
}

TEST_P(HeadingSourceTest, TakesAGyroOfAnyRateAndPhase) {
    Draw draw(5);
    Params params = params_with(HeadingSource::gyro);
    params.wheels.track_width_m = 1e-4;  // a tick is any turn: these wheels contradict no gyro
    for (const double period : {1'700.0, 20'000.0, 33'333.0, 170'000.0}) {
        Robot robot(GetParam(), params);
        std::vector<Sample> samples = drive(500, 10, 10);
        double turned = 0;
        std::int64_t last = 0;
        samples.push_back(gyro_at(0, 0));
        for (int i = 1; double(i + 1) * period < 10e6; ++i) {
            const std::int64_t t = std::llround(i * period);
            const double rate = draw.uniform(-0.5, 0.5);
            samples.push_back(gyro_at(t, rate));
            turned += rate * double(t - last) * 1e-6;
            last = t;
        }
        samples.push_back(gyro_at(10 * kSecond, 0.1));  // at the last motion sample
        turned += 0.1 * double(10 * kSecond - last) * 1e-6;
        std::sort(samples.begin(), samples.end(), InOrder{});
        robot.add(samples);
        EXPECT_NEAR(robot.pose()[kHeading], wrap(turned), GetParam().tolerance) << period;
    }
}

TEST_P(HeadingSourceTest, CorrectsAVelocityMessagesTurnAsWell) {
    Params params = params_with(HeadingSource::gyro);
    params.motion.source = MotionSource::velocity;
    Robot robot(GetParam(), params);
    for (int i = 0; i <= 100; ++i) {
        robot.add(gyro_at(i * kPeriod, 0.3));
        robot.add(velocity_at(i * kPeriod, 0.5, 0.1));
    }
    EXPECT_TRUE(same_pose(robot.pose(), after_arc({0, 0, 0}, 1, 0.6), GetParam().tolerance));
}

}  // namespace
}  // namespace pilotage::test
