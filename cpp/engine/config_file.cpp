#include "config_file.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include "intrinsics_file.hpp"
#include "pilotage/examine.hpp"
#include "yaml_nodes.hpp"

namespace pilotage {

using namespace yaml;

namespace {

Marker parse_marker(const YAML::Node& node, const std::string& where) {
    if (!node.IsMap())
        fail(where, node, "a marker is written {id: 1, x: 2.0, y: 3.0, z: 0.0, sigma: 0.01}");
    Marker marker;
    bool id = false, x = false, y = false;
    each_pair(
        node, where, [&](const std::string& key, const YAML::Node& name, const YAML::Node& value) {
            if (key == "id") {
                marker.id = whole_number(value, key, where);
                id = true;
            } else if (key == "x") {
                marker.x_m = number(value, key, where);
                x = true;
            } else if (key == "y") {
                marker.y_m = number(value, key, where);
                y = true;
            } else if (key == "z") {
                marker.z_m = number(value, key, where);
            } else if (key == "sigma") {
                marker.sigma_m = number(value, key, where);
                if (marker.sigma_m < 0)
                    fail(where, value, "sigma is '" + value.Scalar() + "', expected 0 or more");
            } else if (key == "label") {
                marker.label = whole_number(value, key, where);
            } else {
                fail(where, name,
                     "unknown key '" + key + "' in a marker; known: id, x, y, z, sigma, label");
            }
        });
    if (!id || !x || !y) fail(where, node, "a marker needs id, x and y");
    return marker;
}

MarkerMap parse_map(const YAML::Node& list, const std::string& where) {
    if (!list.IsSequence())
        fail(where, list,
             "a map is a list of markers: - {id: 1, x: 2.0, y: 3.0, z: 0.0, sigma: 0.01}");
    std::vector<Marker> markers;
    std::set<std::int32_t> ids;
    for (const auto& node : list) {
        markers.push_back(parse_marker(node, where));
        if (!ids.insert(markers.back().id).second)
            fail(where, node, "marker id " + std::to_string(markers.back().id) + " comes twice");
    }
    return checked_map(std::move(markers), where);
}

/// One line of walls from corner to corner.
void parse_line(const YAML::Node& line, const std::string& where, std::vector<Wall>& walls) {
    const auto is_point = [](const YAML::Node& n) { return n.IsSequence() && n.size() == 2; };
    const bool points =
        line.IsSequence() && line.size() >= 2 && std::all_of(line.begin(), line.end(), is_point);
    if (!points)
        fail(where, line, "a line of walls is a list of corners: - [[0, 0], [5, 0], [5, 10]]");
    const auto at = [&](std::size_t i, int axis) {
        return number(line[i][axis], axis == 0 ? "x" : "y", where);
    };
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        walls.push_back({at(i, 0), at(i, 1), at(i + 1, 0), at(i + 1, 1)});
}

WallMap parse_walls(const YAML::Node& list, const std::string& where) {
    if (!list.IsSequence() || list.size() == 0)
        fail(where, list, "walls are a list of lines from corner to corner: - [[0, 0], [5, 0]]");
    std::vector<Wall> walls;
    for (const auto& line : list) parse_line(line, where, walls);
    return checked_walls(std::move(walls), where);
}

/// The name in a key `sensors.NAME.intrinsics`.
std::string sensor_of(const std::string& key) {
    const auto dot = key.find('.') + 1;
    return key.substr(dot, key.rfind('.') - dot);
}

/// Takes what stands in the configuration itself, or in the file that it names.
void apply_file(Config& config, const std::string& key, const YAML::Node& value,
                const std::string& where, const std::string& folder) {
    std::string name = where;
    YAML::Node list = value;
    if (value.IsScalar()) {
        name = beside(folder, value.Scalar());
        list = parse_yaml(key == "map" || key == "walls" ? read_file(name) : read_calibration(name),
                          name);
    }
    if (key == "map")
        config.map = parse_map(list, name);
    else if (key == "walls")
        config.walls = parse_walls(list, name);
    else
        config.calibrate(sensor_of(key), parse_intrinsics(list, name));
}

/// Writes a section that is kept as it stands. Quotes stay: they make text of what looks like a
/// number.
void keep(const YAML::Node& node, const std::string& where, YAML::Emitter& out, int depth = 0) {
    constexpr int deepest = 20;  // an alias may hold what it stands in
    if (depth > deepest) fail(where, node, "this is nested too deep");
    if (node.IsMap()) {
        out << YAML::BeginMap;
        each_pair(node, where,
                  [&](const std::string& key, const YAML::Node&, const YAML::Node& value) {
                      out << YAML::Key << key << YAML::Value;
                      keep(value, where, out, depth + 1);
                  });
        out << YAML::EndMap;
    } else if (node.IsSequence()) {
        out << YAML::BeginSeq;
        for (const auto& item : node) keep(item, where, out, depth + 1);
        out << YAML::EndSeq;
    } else if (node.IsNull()) {
        out << YAML::Null;
    } else {
        const bool quoted = node.Tag() == "!";
        if (quoted) out << YAML::DoubleQuoted;
        out << node.Scalar();
    }
}

/// \return the section in the form in which it is kept; empty if it is
std::string kept_section(const YAML::Node& section, const std::string& where) {
    if (section.IsNull()) return "";
    if (!section.IsMap()) fail(where, section, "'detectors' is a section, by sensor");
    YAML::Emitter out;
    keep(section, where, out);
    return out.c_str();
}

std::string indented(const std::string& text) {
    std::istringstream lines(text);
    std::string result;
    for (std::string line; std::getline(lines, line);) result += "  " + line + "\n";
    return result;
}

/// Whether there are keys under it.
bool is_section(Config& config, const std::string& key) {
    const std::string prefix = key + ".";
    const auto under = [&](const Field& f) { return f.key.compare(0, prefix.size(), prefix) == 0; };
    const std::vector<Field> list = fields(config);
    return key == "sensors" || std::any_of(list.begin(), list.end(), under);
}

void apply(Config& config, const YAML::Node& node, const std::string& prefix,
           const std::string& where, const std::string& folder) {
    each_pair(node, where,
              [&](const std::string& name, const YAML::Node& at_key, const YAML::Node& value) {
                  const std::string key = prefix + name;
                  const std::string line = at(where, at_key.Mark());
                  const bool file = is_file(key);
                  if (key == "detectors") {
                      config.detectors = kept_section(value, where);
                  } else if (file && !value.IsScalar()) {
                      (void)field(config, key, line);  // an unknown key is named
                      apply_file(config, key, value, where, folder);
                  } else if (value.IsMap()) {
                      if (prefix == "sensors.") {
                          config.sensor(name, line);
                          // The other keys depend on it, wherever it stands.
                          if (const YAML::Node measures = value["measures"]; measures.IsDefined())
                              if (measures.IsScalar())
                                  field(config, key + ".measures", line)
                                      .set(measures.Scalar(), at(where, measures.Mark()));
                      }
                      // No key has more parts than three; by an alias to what it stands in, YAML
                      // may hold sections without end.
                      const bool deep = std::count(key.begin(), key.end(), '.') >= 2;
                      if ((deep || value.size() == 0) && !is_section(config, key)) {
                          (void)field(config, key, line);  // an unknown key is named
                          fail(where, at_key, "'" + key + "' needs a value");
                      }
                      apply(config, value, key + ".", where, folder);
                  } else if (value.IsScalar()) {
                      field(config, key, line).set(value.Scalar(), at(where, value.Mark()));
                      if (file) apply_file(config, key, value, where, folder);
                  } else {
                      fail(where, at_key, "'" + key + "' needs a value");
                  }
              });
}

}  // namespace

MarkerMap checked_map(std::vector<Marker> markers, const std::string& where) {
    if (markers.empty())
        throw ConfigError(where + ": the map has no marker; at least one is needed");
    std::set<std::int32_t> ids;
    for (const Marker& m : markers) {
        const std::string name = where + ": marker " + std::to_string(m.id);
        if (m.id < 0) throw ConfigError(name + ": an id is 0 or more (-1 means unknown)");
        if (!ids.insert(m.id).second) throw ConfigError(name + " comes twice");
        for (const double v : {m.x_m, m.y_m, m.z_m, m.sigma_m})
            if (!std::isfinite(v)) throw ConfigError(name + ": x, y, z and sigma must be finite");
        if (m.sigma_m < 0) throw ConfigError(name + ": sigma must be 0 or more");
        if (m.label < -1) throw ConfigError(name + ": a label is 0 or more (-1 means none)");
    }
    return MarkerMap(std::move(markers));
}

WallMap checked_walls(std::vector<Wall> walls, const std::string& where) {
    for (const Wall& w : walls) {
        for (const double v : {w.from_x_m, w.from_y_m, w.to_x_m, w.to_y_m})
            if (!(std::abs(v) <= kFarthest))
                throw ConfigError(where + ": a wall's corners must be finite and within 1e7 m");
        if (w.from_x_m == w.to_x_m && w.from_y_m == w.to_y_m)
            throw ConfigError(where + ": a wall begins and ends at " + std::to_string(w.from_x_m) +
                              ", " + std::to_string(w.from_y_m));
    }
    return WallMap(std::move(walls));
}

MarkerMap load_map(const std::string& path) {
    return parse_map(parse_yaml(read_file(path), path), path);
}

std::string kept_section(const std::string& yaml, const std::string& where) {
    return kept_section(parse_yaml(yaml, where), where);
}

Config load_config(const std::string& path) {
    const auto slash = path.rfind('/');
    return parse_config(read_file(path), path,
                        slash == std::string::npos ? "" : path.substr(0, slash));
}

Config parse_config(const std::string& yaml, const std::string& where, const std::string& folder) {
    Config config;
    const YAML::Node root = parse_yaml(yaml, where);
    if (!root.IsMap()) throw ConfigError(where + ": a configuration is a YAML map of sections");
    apply(config, root, "", where, folder);
    check(config, where);
    return config;
}

std::string to_yaml(const MarkerMap& map) {
    YAML::Emitter out;
    out.SetDoublePrecision(17);
    out << YAML::BeginSeq;
    for (const Marker& m : map.markers()) {
        out << YAML::Flow << YAML::BeginMap << YAML::Key << "id" << YAML::Value << m.id << YAML::Key
            << "x" << YAML::Value << m.x_m << YAML::Key << "y" << YAML::Value << m.y_m << YAML::Key
            << "z" << YAML::Value << m.z_m << YAML::Key << "sigma" << YAML::Value << m.sigma_m;
        if (m.label >= 0) out << YAML::Key << "label" << YAML::Value << m.label;
        out << YAML::EndMap;
    }
    out << YAML::EndSeq;
    return std::string(out.c_str()) + "\n";
}

std::string to_yaml(const Config& config) {
    Config copy = config;
    YAML::Node root(YAML::NodeType::Map);
    for (const Field& f : fields(copy)) {
        if (f.unset() || is_map(f.key)) continue;
        const Intrinsics* camera = nullptr;
        if (is_file(f.key)) {
            camera = &copy.params.sensors[copy.sensor(sensor_of(f.key))].camera.intrinsics();
            if (!camera->any()) continue;
        }
        YAML::Node node = root;
        std::istringstream path(f.key);
        std::string part, last;
        for (std::getline(path, last, '.'); std::getline(path, part, '.'); last = part)
            node.reset(node[last]);
        if (camera != nullptr)
            node[last] = to_node(*camera);
        else
            node[last] = f.text();
    }
    std::ostringstream text;
    text << root << "\n";
    if (!config.detectors.empty()) text << "detectors:\n" << indented(config.detectors);
    if (!config.map.markers().empty()) text << "map:\n" << to_yaml(config.map);
    if (!config.walls.walls().empty()) text << "walls:\n" << to_yaml(config.walls);
    return text.str();
}

std::string to_yaml(const WallMap& map) {
    YAML::Emitter out;
    out.SetDoublePrecision(17);
    out << YAML::BeginSeq;
    for (const Wall& w : map.walls())
        out << YAML::Flow << YAML::BeginSeq << YAML::BeginSeq << w.from_x_m << w.from_y_m
            << YAML::EndSeq << YAML::BeginSeq << w.to_x_m << w.to_y_m << YAML::EndSeq
            << YAML::EndSeq;
    out << YAML::EndSeq;
    return std::string(out.c_str()) + "\n";
}

void save_map(const MarkerMap& map, const std::string& path) {
    std::ofstream file(path);
    file << to_yaml(map);
    if (!file.flush()) throw ConfigError(path + ": cannot be written");
}

}  // namespace pilotage
