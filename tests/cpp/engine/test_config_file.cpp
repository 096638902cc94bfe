// Configurations as text and as files: read, written, and read again.

#include "engine/config_file.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/configs.hpp"
#include "support/files.hpp"

namespace pilotage::test {
namespace {

TEST(ConfigFileTest, WritesEveryKeyAndReadsItBack) {
    Config config = parsed(
        "initial: {x_m: 1, y_m: 2, heading_rad: 3}\n"
        "sensors: {camera: {}, scanner: {channel: SCAN}}\n"
        "map: [{id: 4, x: 0.1, y: 0.2, z: 0.3, sigma: 0.7}, {id: 2, x: 1e-7, y: -12345.678}]\n");
    const std::string text = to_yaml(config);
    EXPECT_EQ(to_yaml(parsed(text)), text);
    for (const Field& f : fields(config)) {
        if (is_file(f.key)) continue;
        const std::string last = f.key.substr(f.key.rfind('.') + 1);
        EXPECT_NE(text.find(last + ": " + f.text()), std::string::npos) << f.key;
    }
}

/// Each key in turn is set to something else: the text that is written must bring it back.
TEST(ConfigFileTest, EveryChangedKeyComesBack) {
    const Config plain =
        parsed("initial: {x_m: 1, y_m: 2, heading_rad: 3}\nsensors: {camera: {}}\n");
    Config probe = plain;
    const std::size_t count = fields(probe).size();
    for (std::size_t i = 0; i < count; ++i) {
        Config config = plain;
        const Field f = fields(config)[i];
        if (is_file(f.key)) continue;
        const std::string before = f.text();
        if (const auto* choice = std::get_if<Field::Choice>(&f.value))
            f.set(choice->names[(*choice->value + 1U) % choice->names.size()], "");
        else if (std::holds_alternative<int*>(f.value))
            f.set("777", "");
        else if (std::holds_alternative<double*>(f.value))
            f.set("0.4375", "");
        else
            f.set("OTHER", "");
        ASSERT_NE(f.text(), before) << f.key;
        Config back = parsed(to_yaml(config));
        EXPECT_EQ(fields(back)[i].text(), f.text()) << f.key;
        EXPECT_EQ(to_yaml(back), to_yaml(config)) << f.key;
    }
}

TEST(ConfigFileTest, ReadsBackNamesThatYamlWouldTakeForSomethingElse) {
    for (const char* name : {"yes", "null", "~", "1.5", "a: b", "# x", "- y", "{", "'", "\"", "\\",
                             "&a", "*", " blank ", "Straße", "!tag", "%"}) {
        Config config;
        config.encoders.channel = name;
        EXPECT_EQ(parsed(to_yaml(config)).encoders.channel, name);
        if (std::string(name).find('.') != std::string::npos) continue;
        config = {};
        (void)config.sensor(name);
        const std::string text = to_yaml(config);
        EXPECT_EQ(parsed(text).sensor_names.at(0), name) << text;
    }
}

TEST(ConfigFileTest, LeavesAStartThatIsNotGivenOut) {
    const std::string text = to_yaml(Config{});
    EXPECT_EQ(text.find(" heading_rad:"), std::string::npos);
    EXPECT_EQ(text.find("nan"), std::string::npos);
    EXPECT_TRUE(std::isnan(parsed(text).params.initial.x_m));
}

TEST(ConfigFileTest, ReadsTheMapFromAFileBesideIt) {
    const Folder folder;
    (void)folder.write("markers.yaml",
                       "- {id: 3, x: 1, y: 2, z: 0.5, sigma: 0.1}\n- {id: 1, x: 5, y: 6}\n");
    const Config config = load_config(folder.write("robot.yaml", "map: markers.yaml\n"));
    ASSERT_EQ(config.map.markers().size(), 2U);
    EXPECT_EQ(config.map.find(3)->sigma_m, 0.1);
    EXPECT_EQ(config.map.find(1)->z_m, 0);
    EXPECT_EQ(config.map_file, "markers.yaml");
    const Config absolute =
        parse_config("map: " + folder.path("markers.yaml") + "\n", "x", "/nowhere");
    EXPECT_EQ(absolute.map.markers().size(), 2U);
}

TEST(ConfigFileTest, ReadsTheMapThatStandsInIt) {
    const Config config = parsed("map:\n  - {id: 0, x: 1, y: 2}\n");
    EXPECT_EQ(config.map.markers().size(), 1U);
    EXPECT_TRUE(config.map_file.empty());
}

TEST(ConfigFileTest, AMapReadsBackToTheLastBit) {
    const Folder folder;
    const MarkerMap map({{7, 0.1, 1.0 / 3, -1e-17, 2.0 / 3}, {2147483647, 1e6, -123456.789, 4, 0}});
    save_map(map, folder.path("map.yaml"));
    const MarkerMap back = load_map(folder.path("map.yaml"));
    ASSERT_EQ(back.markers().size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        const Marker &a = map.markers()[i], &b = back.markers()[i];
        EXPECT_EQ(a.id, b.id);
        EXPECT_EQ(a.x_m, b.x_m);
        EXPECT_EQ(a.y_m, b.y_m);
        EXPECT_EQ(a.z_m, b.z_m);
        EXPECT_EQ(a.sigma_m, b.sigma_m);
    }
}

TEST(ConfigFileTest, TheReadyConfigurationsLoad) {
    const std::string folder = PILOTAGE_SOURCE_DIR "/configs";
    int found = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".yaml") continue;
        ++found;
        EXPECT_EQ(complaint<ConfigError>([&] { (void)load_config(entry.path().string()); }), "");
    }
    EXPECT_GE(found, 4);
}

}  // namespace
}  // namespace pilotage::test
