// The defaults must be usable as they stand, and say themselves whether six
// states are needed.

#include "pilotage/params.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pilotage::test {
namespace {

TEST(ParamsTest, FreezeTheCalibrationUnlessASigmaOrAWalkIsGiven) {
    EXPECT_FALSE(Params{}.calibrates());
    for (CalibrationParams Params::* state :
         {&Params::gyro_bias, &Params::distance_scale, &Params::rotation_scale}) {
        Params by_sigma, by_walk, by_value;
        (by_sigma.*state).sigma = 1e-6;
        (by_walk.*state).walk = 1e-6;
        (by_value.*state).initial = 0.9;
        EXPECT_TRUE(by_sigma.calibrates());
        EXPECT_TRUE(by_walk.calibrates());
        EXPECT_FALSE(by_value.calibrates()) << "a frozen value needs no state";
    }
}

TEST(ParamsTest, CorrectNothingByDefault) {
    const Params params;
    EXPECT_EQ(params.gyro_bias.initial, 0);
    EXPECT_EQ(params.distance_scale.initial, 1);
    EXPECT_EQ(params.rotation_scale.initial, 1);
    EXPECT_EQ(params.motion.slip_angle_rad, 0);
    for (const SensorParams& sensor : params.sensors) {
        EXPECT_EQ(sensor.range_scale, 1);
        EXPECT_EQ(sensor.range_offset_m, 0);
        EXPECT_EQ(sensor.x_m, 0);
        EXPECT_EQ(sensor.yaw_rad, 0);
    }
}

TEST(ParamsTest, WaitForAStartPoseByDefault) {
    const InitialParams start = Params{}.initial;
    EXPECT_TRUE(std::isnan(start.x_m) && std::isnan(start.y_m) && std::isnan(start.heading_rad));
    EXPECT_EQ(start.sigma_position_m, 0.1);
    EXPECT_NEAR(start.sigma_heading_rad * 180 / 3.14159265358979, 3, 1e-12);
}

TEST(ParamsTest, HoldTwoSecondsAtTwoHundredHertzOfEveryStream) {
    const HistoryParams history = Params{}.history;
    EXPECT_EQ(history.window_s, 2);
    EXPECT_GE(history.capacity, 2 * 200 * 3);
}

}  // namespace
}  // namespace pilotage::test
