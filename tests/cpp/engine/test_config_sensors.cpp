// Sensors that measure something else than markers, and the walls that they measure.

#include <gtest/gtest.h>

#include <fstream>

#include "engine/config_file.hpp"
#include "support/configs.hpp"
#include "support/files.hpp"
#include "support/matchers.hpp"

namespace pilotage::test {
namespace {

TEST(ConfigSensorTest, KeysAreThoseThatMeanSomething) {
    const Config c = parsed(
        "sensors:\n"
        "  gps: {sigma_position_m: 0.03, x_m: 0.2, measures: pose}\n"
        "  laser: {measures: walls, sigma_range_m: 0.02}\n"
        "  camera: {sigma_bearing_rad: 0.01}\n");
    EXPECT_EQ(c.params.sensors[0].measures, Measures::pose) << "wherever it stands in the section";
    EXPECT_EQ(c.params.sensors[0].sigma_position_m, 0.03);
    EXPECT_EQ(c.params.sensors[1].measures, Measures::walls);
    EXPECT_EQ(c.params.sensors[2].measures, Measures::markers);
    EXPECT_NE(refusal("sensors: {gps: {measures: pose, sigma_bearing_rad: 0.1}}")
                  .find("unknown key 'sensors.gps.sigma_bearing_rad'"),
              std::string::npos);
    EXPECT_NE(refusal("sensors: {camera: {sigma_position_m: 0.1}}").find("unknown key"),
              std::string::npos);
    EXPECT_NE(refusal("sensors: {gps: {measures: position}}")
                  .find("measures is 'position', expected one of markers, pose, walls"),
              std::string::npos);
}

TEST(ConfigSensorTest, TheChannelFollowsWhatIsMeasured) {
    const Config c = parsed(
        "sensors: {camera: {}, gps: {measures: pose}, laser: {measures: walls}, dock: {measures: "
        "pose, "
        "channel: DOCK}, front: {measures: pixels}}");
    const char* expected[] = {"MARKERS", "FIX", "WALLS", "DOCK", "PIXELS"};
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(c.sensor_inputs[i].channel, expected[i]);
    Config by_key;
    field(by_key, "sensors.gps.measures", "").set("pose", "");
    EXPECT_EQ(by_key.sensor_inputs[0].channel, "FIX");
    EXPECT_EQ(parsed(to_yaml(c)).sensor_inputs[3].channel, "DOCK") << "written and read again";
    EXPECT_EQ(to_yaml(parsed(to_yaml(c))), to_yaml(c));
}

TEST(ConfigSensorTest, WallsStandInTheConfigurationOrInAFile) {
    const std::string list = "[[[0, 0], [4, 0], [4, 3]], [[1, 1], [2, 1.5]]]";
    const Config here = parsed("walls: " + list);
    ASSERT_EQ(here.walls.walls().size(), 3U);
    EXPECT_EQ(here.walls.walls()[1].from_x_m, 4);
    EXPECT_EQ(here.walls.walls()[1].to_y_m, 3);
    EXPECT_EQ(here.walls.walls()[2].to_y_m, 1.5);
    const Folder folder;
    std::ofstream(folder.path("walls.yaml")) << list;
    const Config there = parse_config("walls: walls.yaml", "robot.yaml", folder.path(""));
    EXPECT_EQ(to_yaml(there.walls), to_yaml(here.walls));
    EXPECT_EQ(there.walls_file, "walls.yaml");
    EXPECT_EQ(to_yaml(parsed(to_yaml(here))), to_yaml(here));
}

TEST(ConfigSensorTest, WallsThatAreNoneAreNamed) {
    const char* const bad[][2] = {
        {"walls: []", "walls are a list of lines"},
        {"walls: 3x", "3x: cannot be opened"},
        {"walls: [[0, 0], [1, 0]]", "a line of walls is a list of corners"},
        {"walls: [[[0, 0]]]", "a line of walls is a list of corners"},
        {"walls: [[[0, 0], [1, a]]]", "y is 'a', expected a finite number"},
        {"walls: [[[0, 0], [1, .nan]]]", "y is '.nan', expected a finite number"},
        {"walls: [[[2, 1], [2, 1]]]", "a wall begins and ends at 2"},
        {"walls: [[[0, 0], [1e9, 0]]]", "within 1e7 m"}};
    for (const auto& [yaml, what] : bad)
        EXPECT_NE(refusal(yaml).find(what), std::string::npos) << refusal(yaml);
}

TEST(ConfigSensorTest, WhatARobotCannotDoWithoutIsNamed) {
    const std::string map = "map: [{id: 1, x: 1, y: 2}]\n", walls = "walls: [[[0, 0], [1, 0]]]\n";
    EXPECT_NE(missing(parsed(map)).find("'sensors' is missing"), std::string::npos);
    EXPECT_NE(missing(parsed("sensors: {camera: {}}")).find("'map' is missing"), std::string::npos);
    EXPECT_NE(missing(parsed(map + "sensors: {laser: {measures: walls}}")).find("'walls'"),
              std::string::npos);
    EXPECT_EQ(missing(parsed("sensors: {gps: {measures: pose}}")), "");
    EXPECT_EQ(missing(parsed(walls + "sensors: {laser: {measures: walls}}")), "");
    EXPECT_EQ(missing(parsed(map + "sensors: {camera: {}}")), "");
    const std::string pixels = "sensors: {front: {measures: pixels}}";
    EXPECT_NE(missing(parsed(pixels)).find("'map'"), std::string::npos);
    EXPECT_NE(missing(parsed(map + pixels)).find("'sensors.front.intrinsics' is missing"),
              std::string::npos);
}

}  // namespace
}  // namespace pilotage::test
