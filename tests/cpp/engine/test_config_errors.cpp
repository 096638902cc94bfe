// A configuration that cannot be used says where, which key, which value, and what would be right.

#include <gtest/gtest.h>

#include "engine/config_file.hpp"
#include "support/configs.hpp"
#include "support/files.hpp"

namespace pilotage::test {
namespace {

#define EXPECT_SAID(yaml, start) \
    EXPECT_EQ(refusal(yaml).substr(0, std::string(start).size()), start) << refusal(yaml)

TEST(ConfigErrorTest, AnUnknownKeyIsNamedWithItsLineAndTheNearest) {
    EXPECT_SAID("motion: {heading: gyro}\nnoise:\n  wheel_m_per_sqrt: 1\n",
                "robot.yaml:3: unknown key 'noise.wheel_m_per_sqrt'; the nearest known key is "
                "'noise.wheel_m_per_sqrt_m'");
    EXPECT_SAID("sensors:\n  camera:\n    sigma_bearing: 0.1\n",
                "robot.yaml:3: unknown key 'sensors.camera.sigma_bearing'; the nearest known key "
                "is 'sensors.camera.sigma_bearing_rad'");
    EXPECT_SAID("maps: x.yaml\n",
                "robot.yaml:1: unknown key 'maps'; the nearest known key is 'map'");
}

TEST(ConfigErrorTest, AnUnknownSectionIsNoBetterForBeingEmpty) {
    EXPECT_SAID("gyro: {}\nsensor: {}\n", "robot.yaml:2: unknown key 'sensor'");
    EXPECT_SAID("gyro: {channel: {}}\n", "robot.yaml:1: ");
    EXPECT_SAID("encoders:\n  wheels: {}\n", "robot.yaml:2: unknown key 'encoders.wheels'");
    EXPECT_EQ(refusal("sensors: {}\n"), "") << "no sensor is a robot by dead reckoning";
}

TEST(ConfigErrorTest, ASectionThatHoldsItselfIsRefused) {
    EXPECT_SAID("&a {motion: *a}\n", "robot.yaml:1: unknown key 'motion.motion.motion'");
    EXPECT_SAID("&a {sensors: *a}\n", "robot.yaml:1: unknown key 'sensors.sensors.sensors'");
    EXPECT_SAID("sensors: {camera: {fusion: &a {fusion: *a}}}\n",
                "robot.yaml:1: 'sensors.camera.fusion' needs a value");
    EXPECT_SAID("map: &a [*a]\n", "robot.yaml:1: a marker is written");
}

TEST(ConfigErrorTest, AKeyThatComesTwiceIsNamed) {
    EXPECT_SAID("gyro: {channel: A}\nencoders: {}\ngyro: {channel: B}\n",
                "robot.yaml:3: key 'gyro' comes twice");
    EXPECT_SAID("gyro:\n  channel: A\n  time: utime\n  channel: B\n",
                "robot.yaml:4: key 'channel' comes twice");
    EXPECT_SAID("sensors:\n  camera: {}\n  camera: {x_m: 1}\n",
                "robot.yaml:3: key 'camera' comes twice");
    EXPECT_SAID("map: [{id: 1, x: 1, y: 1, x: 2}]\n", "robot.yaml:1: key 'x' comes twice");
}

TEST(ConfigErrorTest, NumbersThatAreNoneAreRefusedWithTheirLine) {
    EXPECT_SAID("\nencoders:\n  track_width_m: .nan\n",
                "robot.yaml:3: encoders.track_width_m is '.nan', expected a number above 0");
    EXPECT_SAID("encoders: {latency_s: .inf}\n",
                "robot.yaml:1: encoders.latency_s is '.inf', expected a");
    EXPECT_SAID("encoders: {track_width_m: wide}\n",
                "robot.yaml:1: encoders.track_width_m is 'wide', expected a number above 0");
    EXPECT_SAID("encoders: {track_width_m: -0.5}\n",
                "robot.yaml:1: encoders.track_width_m is '-0.5', expected a number above 0");
    EXPECT_SAID("encoders: {left_m_per_tick: 0}\n",
                "robot.yaml:1: encoders.left_m_per_tick is '0', expected a number other than 0");
    EXPECT_SAID(
        "sensors: {c: {gate_false_reject: 1}}\n",
        "robot.yaml:1: sensors.c.gate_false_reject is '1', expected a number between 0 and");
    EXPECT_SAID("motion: {source: odometry}\n",
                "robot.yaml:1: motion.source is 'odometry', expected one of encoders, velocity");
    EXPECT_SAID("history: {capacity: many}\n",
                "robot.yaml:1: history.capacity is 'many', expected");
}

TEST(ConfigErrorTest, AValueMustBeAValueAndASectionASection) {
    EXPECT_SAID("encoders: {track_width_m: [1, 2]}\n",
                "robot.yaml:1: 'encoders.track_width_m' needs a value");
    EXPECT_SAID("encoders: {track_width_m: }\n",
                "robot.yaml:1: 'encoders.track_width_m' needs a value");
    EXPECT_SAID("encoders: 5\n", "robot.yaml:1: unknown key 'encoders'");
    EXPECT_SAID("sensors:\n  camera:\n", "robot.yaml:2: 'sensors.camera' needs a value");
    EXPECT_SAID("sensors:\n  camera: 7\n", "robot.yaml:2: unknown key 'sensors.camera'");
    for (const char* text : {"", "5", "- a\n- b\n", "~", "# nothing\n"})
        EXPECT_SAID(text, "robot.yaml: a configuration is a YAML map of sections");
    EXPECT_SAID("? [a, b]\n: 1\n", "robot.yaml:1: a key must be a word");
}

TEST(ConfigErrorTest, TextThatIsNoYamlSaysWhereItBreaks) {
    EXPECT_SAID("gyro: {channel: A\nencoders: 1\n", "robot.yaml:");
    EXPECT_NE(refusal("gyro: {channel: A\nencoders: 1\n").find("not YAML"), std::string::npos);
    EXPECT_NE(refusal("gyro:\n\tchannel: A\n"), "");
}

TEST(ConfigErrorTest, AStartIsGivenInFullOrNotAtAll) {
    for (const char* part :
         {"{x_m: 1}", "{x_m: 1, y_m: 2}", "{heading_rad: 0}", "{y_m: 0, heading_rad: 1}"})
        EXPECT_SAID(std::string("initial: ") + part + "\n",
                    "robot.yaml: initial needs x_m, y_m and heading_rad together, or none of them");
    EXPECT_EQ(refusal("initial: {sigma_position_m: 2}\n"), "");
}

TEST(ConfigErrorTest, InputsMayNotShareAChannelUnlessTheyAreSensors) {
    EXPECT_SAID("sensors: {camera: {channel: GYRO}}\n",
                "robot.yaml: sensors.camera.channel 'GYRO' is another input's channel as well");
    EXPECT_SAID("gyro: {channel: ENCODERS}\n",
                "robot.yaml: gyro.channel 'ENCODERS' is another input's channel as well");
    EXPECT_SAID("pose_reset: {channel: GYRO}\n",
                "robot.yaml: pose_reset.channel 'GYRO' is another input's channel as well");
    EXPECT_EQ(refusal("sensors: {left: {channel: CAMERA}, right: {channel: CAMERA}}\n"), "");
    EXPECT_EQ(refusal("encoders: {channel: ODO}\nvelocity: {channel: ODO}\n"), "")
        << "only one of them is an input";
}

TEST(ConfigErrorTest, AnOutputMayNotBeAnInput) {
    EXPECT_SAID("output: {pose: ENCODERS}\n",
                "robot.yaml: output.pose 'ENCODERS' is an input's channel");
}

TEST(ConfigErrorTest, ARateOfPosesIsOneThatTimeCanBeCountedBy) {
    for (const std::string rate : {"1e-300", "0.05", "1001", "1e9"})
        EXPECT_SAID("output: {rate_hz: " + rate + "}\n", "robot.yaml: output.rate_hz is ");
    for (const std::string rate : {"0", "0.1", "1000"})
        EXPECT_EQ(refusal("output: {rate_hz: " + rate + "}\n"), "");
}

TEST(ConfigErrorTest, ASensorsNameIsOneWord) {
    EXPECT_SAID("sensors:\n  front.left: {x_m: 1}\n", "robot.yaml:2: ");
    EXPECT_SAID("sensors:\n  '': {x_m: 1}\n", "robot.yaml:2: ");
}

TEST(ConfigErrorTest, ANinthSensorIsToldWhere) {
    std::string yaml = "sensors:\n";
    for (int i = 0; i < 9; ++i) yaml += "  s" + std::to_string(i) + ": {}\n";
    EXPECT_SAID(yaml, "robot.yaml:10: sensors.s8: there can be at most 8 sensors");
}

TEST(ConfigErrorTest, AFileThatIsNotThereIsNamed) {
    const Folder folder;
    EXPECT_EQ(complaint<ConfigError>([&] { (void)load_config(folder.path("none.yaml")); }),
              folder.path("none.yaml") + ": cannot be opened; does it exist, and may it be read?");
    const std::string robot = folder.write("robot.yaml", "gyro: {}\nmap: none.yaml\n");
    const std::string error = complaint<ConfigError>([&] { (void)load_config(robot); });
    EXPECT_NE(error.find(folder.path("none.yaml") + ": cannot be opened"), std::string::npos)
        << error;
    EXPECT_NE(complaint<ConfigError>([&] { (void)load_config(folder.path("")); }), "")
        << "a folder";
}

}  // namespace
}  // namespace pilotage::test
