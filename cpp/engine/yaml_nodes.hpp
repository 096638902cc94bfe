#pragma once
/// \file
/// Reading YAML such that what is wrong is named with its file and line.

#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <set>
#include <string>

#include "config.hpp"

namespace pilotage::yaml {

[[nodiscard]] std::string at(const std::string& where, const YAML::Mark& mark);

[[noreturn]] void fail(const std::string& where, const YAML::Node& node, const std::string& what);

/// \throws ConfigError
[[nodiscard]] std::string read_file(const std::string& path);
[[nodiscard]] YAML::Node parse_yaml(const std::string& text, const std::string& where);

/// Where a file is that a configuration names.
/// \param folder of the configuration
[[nodiscard]] std::string beside(const std::string& folder, const std::string& name);

/// A finite number. \param what names it in errors
[[nodiscard]] double number(const YAML::Node& node, const std::string& what,
                            const std::string& where);
/// A whole number of 0 or more.
[[nodiscard]] std::int32_t whole_number(const YAML::Node& node, const std::string& what,
                                        const std::string& where);

/// Calls visit(key, key's node, value) for each pair; yaml-cpp takes a key that comes twice in
/// silence, we do not.
template <typename Visit>
void each_pair(const YAML::Node& map, const std::string& where, const Visit& visit) {
    std::set<std::string> seen;
    for (const auto& pair : map) {
        if (!pair.first.IsScalar()) fail(where, pair.first, "a key must be a word");
        const std::string key = pair.first.Scalar();
        if (!seen.insert(key).second) fail(where, pair.first, "key '" + key + "' comes twice");
        visit(key, pair.first, pair.second);
    }
}

}  // namespace pilotage::yaml
