#pragma once
/// \file
/// Configuration and marker map as YAML.

#include <string>

#include "config.hpp"

namespace pilotage {

/// Reads a configuration file and the map that it names. \throws ConfigError
[[nodiscard]] Config load_config(const std::string& path);

/// Reads a configuration from text. \param where its name in errors \param folder of relative map
/// files
/// \throws ConfigError
[[nodiscard]] Config parse_config(const std::string& yaml, const std::string& where,
                                  const std::string& folder);

/// The section `detectors` as Config keeps it. \throws ConfigError
[[nodiscard]] std::string kept_section(const std::string& yaml, const std::string& where);

/// The whole configuration as YAML, every key with its value, the map written out in it.
[[nodiscard]] std::string to_yaml(const Config& config);

/// A map file: a YAML list of {id, x, y, z, sigma}; z and sigma are 0 where missing.
/// \throws ConfigError, also for an empty list and for an id that comes twice
[[nodiscard]] MarkerMap load_map(const std::string& path);
void save_map(const MarkerMap& map, const std::string& path);
[[nodiscard]] std::string to_yaml(const MarkerMap& map);

[[nodiscard]] std::string to_yaml(const WallMap& map);

/// Refuse what would make a map unusable. \throws ConfigError
[[nodiscard]] MarkerMap checked_map(std::vector<Marker> markers, const std::string& where);
[[nodiscard]] WallMap checked_walls(std::vector<Wall> walls, const std::string& where);

}  // namespace pilotage
