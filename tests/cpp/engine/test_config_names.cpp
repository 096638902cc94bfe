// Names in a configuration: whatever people can read on one line, in any script, and nothing else.

#include <gtest/gtest.h>

#include "engine/config.hpp"
#include "support/files.hpp"

namespace pilotage::test {
namespace {

const std::string kReadable[] = {"GYRO",
                                 "front left",
                                 "Kamera_hinten-2",
                                 u8"R\u00fcckfahrkamera",
                                 u8"\u76f8\u6a5f",
                                 u8"\u00a0",
                                 u8"\u07ff\u0800\ud7ff\ue000\ufffd",
                                 u8"\U00010000\U0001f916\U0010fffd",
                                 "~ !#%&*{}[]"};

// What a terminal or a log would make something else of.
const std::string kControl[] = {"a\nb",
                                "a\rb",
                                "\t",
                                "\x1b[31m",
                                "\x7f",
                                {"a\0b", 3},
                                "\x1f",
                                // next line, line and paragraph separator, mark of the byte order
                                "\xc2\x80",
                                "\xc2\x85",
                                "\xc2\x9f",
                                "\xe2\x80\xa8",
                                "\xe2\x80\xa9",
                                "\xef\xbb\xbf",
                                "\xef\xbf\xbe",
                                "\xef\xbf\xbf",
                                "\xf0\x9f\xbf\xbf"};

// Cut off, without a beginning, longer than need be, surrogates, past the last character.
const std::string kNoUtf8[] = {"caf\xe9",
                               "\xc3",
                               "a\xe2\x82",
                               "\xe2\x82 ",
                               "\x80",
                               "\xbf",
                               "\xc0\x80",
                               "\xc1\xbf",
                               "\xe0\x80\xaf",
                               "\xe0\x9f\xbf",
                               "\xf0\x80\x80\xaf",
                               "\xf0\x8f\xbf\xbf",
                               "\xed\xa0\x80",
                               "\xed\xbf\xbf",
                               "\xf4\x90\x80\x80",
                               "\xf5\x80\x80\x80",
                               "\xff",
                               "\xf8\x88\x80\x80\x80"};

/// Of a channel and of a sensor.
void expect_taken(const std::string& name, bool taken) {
    Config config;
    const Field channel = field(config, "gyro.channel", "");
    const std::string before = channel.text();
    const std::string of_channel =
        complaint<ConfigError>([&] { channel.set(name, "robot.yaml:7"); });
    const std::string of_sensor =
        complaint<ConfigError>([&] { (void)config.sensor(name, "robot.yaml:7"); });
    EXPECT_EQ(of_channel.empty(), taken) << name;
    EXPECT_EQ(of_sensor.empty(), taken) << name;
    EXPECT_EQ(channel.text(), taken ? name : before);
    EXPECT_EQ(config.sensor_names.size(), taken ? 1U : 0U);
    if (taken) return;
    for (const std::string& said : {of_channel, of_sensor}) {
        EXPECT_EQ(said.find("robot.yaml:7: "), 0U) << said;
        EXPECT_NE(said.find("expected 1 to 60 bytes of readable text"), std::string::npos) << said;
    }
}

TEST(ConfigNameTest, MayBeOfAnyScript) {
    for (const std::string& name : kReadable) expect_taken(name, true);
}

TEST(ConfigNameTest, HasNoControlCharacters) {
    for (const std::string& name : kControl) expect_taken(name, false);
}

TEST(ConfigNameTest, IsUtf8) {
    for (const std::string& name : kNoUtf8) expect_taken(name, false);
}

TEST(ConfigNameTest, IsLegibleInAnError) {
    Config config;
    EXPECT_EQ(complaint<ConfigError>([&] {
                  field(config, "gyro.channel", "").set({"a\0b\x1b[31m\u00fc\xff", 11}, "x:1");
              }),
              "x:1: gyro.channel is 'a?b?[31m\u00fc?', expected 1 to 60 bytes of readable text");
}

TEST(ConfigNameTest, IsOneToSixtyBytesLong) {
    expect_taken("", false);
    expect_taken(std::string(60, 'a'), true);
    expect_taken(std::string(61, 'a'), false);
    expect_taken(std::string(58, 'a') + u8"\u00fc", true);
    expect_taken(std::string(59, 'a') + u8"\u00fc", false);
}

TEST(ConfigNameTest, OfAMapIsAFileWhateverItIsCalled) {
    Config config;
    const Field map = field(config, "map", "");
    map.set("maps/" + std::string(200, 'm') + ".yaml", "");
    EXPECT_EQ(config.map_file.size(), 210U);
    EXPECT_NE(complaint<ConfigError>([&] { map.set("", "robot.yaml:1"); }).find("a file"),
              std::string::npos);
}

}  // namespace
}  // namespace pilotage::test
