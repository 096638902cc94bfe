// Every key of the configuration: it reads back what it writes, and refuses what it cannot be.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "engine/config.hpp"
#include "support/files.hpp"

namespace pilotage::test {
namespace {

Config with_sensor() {
    Config config;
    (void)config.sensor("camera");
    return config;
}

std::string setting_error(const Field& field, const std::string& text) {
    return complaint<ConfigError>([&] { field.set(text, "robot.yaml:7"); });
}

TEST(ConfigSchemaTest, HasKeysOfItsOwnWithAMeaningEach) {
    Config config = with_sensor();
    std::set<std::string> keys;
    for (const Field& f : fields(config)) {
        EXPECT_TRUE(keys.insert(f.key).second) << f.key << " comes twice";
        EXPECT_FALSE(std::string(f.meaning).empty()) << f.key;
    }
    EXPECT_GT(keys.size(), 60U);
}

TEST(ConfigSchemaTest, EveryKeyIsAPlaceOfItsOwn) {
    Config config = with_sensor();
    std::set<const void*> places;
    for (const Field& f : fields(config)) {
        const void* place = std::visit(
            [](const auto& v) -> const void* {
                if constexpr (std::is_pointer_v<std::decay_t<decltype(v)>>)
                    return v;
                else
                    return v.value;
            },
            f.value);
        EXPECT_TRUE(places.insert(place).second) << f.key << " writes where another key writes";
    }
}

TEST(ConfigSchemaTest, DefaultsAreWithinTheirRanges) {
    Config config = with_sensor();
    for (const Field& f : fields(config)) {
        if (f.unset() || is_file(f.key)) continue;
        EXPECT_EQ(setting_error(f, f.text()), "");
    }
}

TEST(ConfigSchemaTest, EveryNumberReadsBackToTheLastBit) {
    Config config = with_sensor();
    for (const Field& f : fields(config)) {
        if (!std::holds_alternative<double*>(f.value)) continue;
        for (const char* text : {"0.1", "0.30000000000000004", "1e-09", "0.9999999999999999"}) {
            f.set(text, "");
            EXPECT_EQ(f.text(), text) << f.key;
        }
        f.set("+0.25", "");
        EXPECT_EQ(f.text(), "0.25") << f.key;
    }
}

TEST(ConfigSchemaTest, EveryChoiceReadsBackAndNamesTheOthers) {
    Config config = with_sensor();
    int choices = 0;
    for (const Field& f : fields(config)) {
        const auto* choice = std::get_if<Field::Choice>(&f.value);
        if (choice == nullptr) continue;
        ++choices;
        for (const std::string& name : choice->names) {
            f.set(name, "");
            EXPECT_EQ(f.text(), name) << f.key;
        }
        const std::string said = setting_error(f, "nonsense");
        EXPECT_NE(said.find(f.key + " is 'nonsense', expected one of "), std::string::npos) << said;
        for (const std::string& name : choice->names)
            EXPECT_NE(said.find(name), std::string::npos) << said;
    }
    EXPECT_EQ(choices, 1 + 2 + 5 + 1 + 1 + 2)
        << "filter, motion, clocks, resets, adaptation, what a sensor measures and how it fuses";
}

TEST(ConfigSchemaTest, NoNumberTakesWhatIsNone) {
    Config config = with_sensor();
    for (const Field& f : fields(config)) {
        const bool number = std::holds_alternative<double*>(f.value);
        if (!number && !std::holds_alternative<int*>(f.value)) continue;
        const std::string before = f.text();
        for (const char* text : {"",    " ",    "abc",   "1.0x", "1,5", "1 2",  "--1",
                                 "+-1", "0x10", ".nan",  "nan",  "NaN", ".inf", "-.inf",
                                 "inf", "-inf", "1e999", "true", "~",   "1e10", "-1e300"}) {
            const std::string said = setting_error(f, text);
            EXPECT_NE(said.find("robot.yaml:7: " + f.key + " is '" + text + "', expected a"),
                      std::string::npos)
                << f.key << " took '" << text << "' " << said;
        }
        EXPECT_EQ(f.text(), before) << "a refused value must not stay";
    }
}

TEST(ConfigSchemaTest, RangesAreKept) {
    Config config = with_sensor();
    for (const Field& f : fields(config)) {
        if (!std::holds_alternative<double*>(f.value)) continue;
        const auto takes = [&](const char* text) { return setting_error(f, text).empty(); };
        const bool any = f.range == Field::Range::any || f.range == Field::Range::unset_or_any;
        EXPECT_EQ(takes("-1"), any || f.range == Field::Range::not_zero) << f.key;
        EXPECT_EQ(takes("0"), any || f.range == Field::Range::not_negative) << f.key;
        EXPECT_EQ(takes("1"), f.range != Field::Range::probability) << f.key;
        EXPECT_TRUE(takes("0.5")) << f.key;
    }
}

TEST(ConfigSchemaTest, CapacityIsAWholeNumberOfSamples) {
    Config config;
    const Field capacity = field(config, "history.capacity", "");
    for (const char* bad : {"0", "-5", "1.5", "1e3", "1000001", "99999999999999999999"})
        EXPECT_NE(setting_error(capacity, bad).find("a whole number from 1 to 1000000"),
                  std::string::npos)
            << bad;
    capacity.set("1000000", "");
    EXPECT_EQ(config.params.history.capacity, 1'000'000);
}

TEST(ConfigSchemaTest, AChannelHasAName) {
    Config config;
    EXPECT_NE(setting_error(field(config, "gyro.channel", ""), ""), "");
}

TEST(ConfigSchemaTest, AnUnknownKeyNamesTheNearest) {
    const char* const pairs[][2] = {
        {"motion.headings", "motion.heading"},
        {"encoders.trackwidth_m", "encoders.track_width_m"},
        {"noise.gyro_rad_per_sqrt_sec", "noise.gyro_rad_per_sqrt_s"},
        {"calibration.gyro_bais.sigma", "calibration.gyro_bias.sigma"},
        {"inital.x_m", "initial.x_m"},
        {"sensors.camera.sigma_baering_rad", "sensors.camera.sigma_bearing_rad"},
        {"Map", "map"}};
    for (const auto& [wrong, right] : pairs) {
        Config config = with_sensor();
        EXPECT_EQ(complaint<ConfigError>(
                      [&, wrong = wrong] { (void)field(config, wrong, "robot.yaml:3"); }),
                  std::string("robot.yaml:3: unknown key '") + wrong +
                      "'; the nearest known key is '" + right + "'");
    }
}

TEST(ConfigSchemaTest, SpeakingOfASensorAddsIt) {
    Config config;
    field(config, "sensors.scanner.x_m", "").set("0.5", "");
    ASSERT_EQ(config.sensor_names, std::vector<std::string>{"scanner"});
    EXPECT_EQ(config.params.sensor_count, 1);
    EXPECT_EQ(config.params.sensors[0].x_m, 0.5);
    EXPECT_EQ(config.sensor_inputs[0].channel, "MARKERS");
    EXPECT_EQ(config.sensor("scanner"), 0) << "and only once";
    EXPECT_EQ(config.sensor("camera"), 1);
}

TEST(ConfigSchemaTest, AMisspeltKeyOfANewSensorDoesNotAddIt) {
    Config config;
    EXPECT_NE(complaint<ConfigError>([&] { (void)field(config, "sensors.cam.sgima", "x"); }), "");
    EXPECT_TRUE(config.sensor_names.empty());
}

TEST(ConfigSchemaTest, ThereIsRoomForEightSensors) {
    Config config;
    for (int i = 0; i < Params::kMaxSensors; ++i)
        EXPECT_EQ(config.sensor("s" + std::to_string(i)), i);
    const std::string said =
        complaint<ConfigError>([&] { (void)field(config, "sensors.ninth.x_m", "robot.yaml:9"); });
    EXPECT_NE(said.find("at most 8 sensors"), std::string::npos) << said;
    EXPECT_EQ(said.find("robot.yaml:9: "), 0U) << said;
    EXPECT_EQ(config.sensor("s3"), 3);
}

}  // namespace
}  // namespace pilotage::test
