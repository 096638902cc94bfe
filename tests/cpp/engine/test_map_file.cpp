// Marker maps that cannot be used say which marker, and where.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/config_file.hpp"
#include "support/files.hpp"

namespace pilotage::test {
namespace {

std::string map_error(const std::string& yaml) {
    const Folder folder;
    const std::string path = folder.write("map.yaml", yaml);
    std::string error = complaint<ConfigError>([&] { (void)load_map(path); });
    if (const auto at = error.find(path); at == 0) error.replace(0, path.size(), "map.yaml");
    return error;
}

TEST(MapFileTest, ReadsAMarkerALine) {
    EXPECT_EQ(
        map_error("- {id: 1, x: 2, y: 3}\n- id: 2\n  x: 1.5e1\n  y: -3\n  z: 0.5\n  sigma: 0\n"),
        "");
}

TEST(MapFileTest, AnEmptyMapIsOfNoUse) {
    const std::string none = "map.yaml: the map has no marker; at least one is needed";
    EXPECT_EQ(map_error("[]\n"), none);
    EXPECT_NE(map_error(""), "");
    EXPECT_NE(complaint<ConfigError>([] { (void)parse_config("map: []\n", "c", ""); }), "");
    EXPECT_NE(complaint<ConfigError>([] { (void)parse_config("map: {}\n", "c", ""); }), "");
    EXPECT_NE(complaint<ConfigError>([] { (void)parse_config("map:\n", "c", ""); }), "");
}

TEST(MapFileTest, AnIdThatComesTwiceIsNamedWithItsLine) {
    EXPECT_EQ(map_error("- {id: 1, x: 2, y: 3}\n- {id: 4, x: 2, y: 3}\n- {id: 1, x: 5, y: 6}\n"),
              "map.yaml:3: marker id 1 comes twice");
}

TEST(MapFileTest, AnIdIsAWholeNumberThatFits) {
    for (const char* id : {"-1", "1.5", "2147483648", "1e20"})
        EXPECT_EQ(
            map_error(std::string("- {id: ") + id + ", x: 0, y: 0}\n"),
            std::string("map.yaml:1: id is '") + id + "', expected a whole number of 0 or more");
    EXPECT_EQ(map_error("- {id: 2147483647, x: 0, y: 0}\n"), "");
}

TEST(MapFileTest, ALabelIsAWholeNumberThatSurvivesSavingAndLoading) {
    EXPECT_EQ(map_error("- {id: 1, x: 0, y: 0, label: -1}\n"),
              "map.yaml:1: label is '-1', expected a whole number of 0 or more");
    EXPECT_EQ(map_error("- {id: 1, x: 0, y: 0, label: red}\n"),
              "map.yaml:1: label is 'red', expected a finite number");
    const Folder folder;
    const std::string path = folder.path("map.yaml");
    save_map(MarkerMap({{1, 0, 0, 0, 0, 7}, {2, 1, 0, 0, 0}}), path);
    const MarkerMap map = load_map(path);
    EXPECT_EQ(map.markers()[0].label, 7);
    EXPECT_EQ(map.markers()[1].label, -1);
}

TEST(MapFileTest, ACoordinateIsAFiniteNumber) {
    for (const char* bad : {".nan", ".inf", "-.inf", "here", "''", "1 2", "1e999"})
        EXPECT_EQ(map_error(std::string("- {id: 1, x: 1, y: 2}\n- {id: 2, x: ") + bad + ", y: 0}\n")
                      .substr(0, 18),
                  "map.yaml:2: x is '")
            << bad;
    EXPECT_NE(map_error("- {id: 1, x: [1], y: 0}\n"), "");
    EXPECT_NE(map_error("- {id: 1, x: , y: 0}\n"), "");
}

TEST(MapFileTest, AMarkerHasAnIdAndAPlaceAndNothingUnknown) {
    EXPECT_EQ(map_error("- {id: 1, x: 2, y: 3}\n- {x: 2, y: 3}\n"),
              "map.yaml:2: a marker needs id, x and y");
    EXPECT_EQ(map_error("- {id: 1, y: 3}\n"), "map.yaml:1: a marker needs id, x and y");
    EXPECT_EQ(map_error("- {id: 1, x: 2, y: 3, height: 4}\n"),
              "map.yaml:1: unknown key 'height' in a marker; known: id, x, y, z, sigma, label");
    EXPECT_EQ(map_error("- {id: 1, x: 2, y: 3, sigma: -0.1}\n"),
              "map.yaml:1: sigma is '-0.1', expected 0 or more");
    EXPECT_EQ(map_error("- 5\n").substr(0, 35), "map.yaml:1: a marker is written {id");
    EXPECT_EQ(map_error("id: 1\nx: 2\n").substr(0, 35), "map.yaml:1: a map is a list of mark");
}

TEST(MapFileTest, AMapMadeInMemoryIsCheckedAsWell) {
    const auto error = [](const std::vector<Marker>& markers) {
        return complaint<ConfigError>([&] { (void)checked_map(markers, "map"); });
    };
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(error({{1, 0, 0, 0, 0}}), "");
    EXPECT_NE(error({}), "");
    EXPECT_EQ(error({{5, 0, 0, 0, 0}, {5, 1, 0, 0, 0}}), "map: marker 5 comes twice");
    EXPECT_EQ(error({{-1, 0, 0, 0, 0}}), "map: marker -1: an id is 0 or more (-1 means unknown)");
    for (const Marker& bad : {Marker{3, nan, 0, 0, 0}, Marker{3, 0, nan, 0, 0},
                              Marker{3, 0, 0, HUGE_VAL, 0}, Marker{3, 0, 0, 0, nan}})
        EXPECT_EQ(error({bad}), "map: marker 3: x, y, z and sigma must be finite");
    EXPECT_EQ(error({{3, 0, 0, 0, -1}}), "map: marker 3: sigma must be 0 or more");
    EXPECT_EQ(error({{3, 0, 0, 0, 0, -2}}), "map: marker 3: a label is 0 or more (-1 means none)");
}

TEST(MapFileTest, AFileThatCannotBeReadOrWrittenIsNamed) {
    const Folder folder;
    EXPECT_EQ(complaint<ConfigError>([&] { (void)load_map(folder.path("none")); }),
              folder.path("none") + ": cannot be opened; does it exist, and may it be read?");
    EXPECT_EQ(complaint<ConfigError>([&] { save_map(MarkerMap(), folder.path("no/such")); }),
              folder.path("no/such") + ": cannot be written");
}

}  // namespace
}  // namespace pilotage::test
