#include "yaml_nodes.hpp"

#include <cmath>
#include <fstream>
#include <sstream>

namespace pilotage::yaml {

std::string at(const std::string& where, const YAML::Mark& mark) {
    return mark.is_null() ? where : where + ":" + std::to_string(mark.line + 1);
}

void fail(const std::string& where, const YAML::Node& node, const std::string& what) {
    throw ConfigError(at(where, node.Mark()) + ": " + what);
}

std::string read_file(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw ConfigError(path + ": cannot be opened; does it exist, and may it be read?");
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

YAML::Node parse_yaml(const std::string& text, const std::string& where) {
    try {
        return YAML::Load(text);
    } catch (const YAML::Exception& error) {
        throw ConfigError(at(where, error.mark) + ": not YAML: " + error.msg);
    }
}

std::string beside(const std::string& folder, const std::string& name) {
    return name.front() != '/' && !folder.empty() ? folder + "/" + name : name;
}

double number(const YAML::Node& node, const std::string& what, const std::string& where) {
    double value = 0;
    if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value))
        fail(where, node,
             what + " is '" + (node.IsScalar() ? node.Scalar() : "not a scalar") +
                 "', expected a finite number");
    return value;
}

std::int32_t whole_number(const YAML::Node& node, const std::string& what,
                          const std::string& where) {
    const double v = number(node, what, where);
    if (v != std::floor(v) || v < 0 || v > 2147483647.0)
        fail(where, node,
             what + " is '" + node.Scalar() + "', expected a whole number of 0 or more");
    return static_cast<std::int32_t>(v);
}

}  // namespace pilotage::yaml
