#include "engine/config.hpp"

#include <pybind11/stl.h>
#include <pybind11/typing.h>

#include <algorithm>
#include <optional>

#include "bindings.hpp"
#include "engine/config_file.hpp"
#include "text.hpp"

namespace py = pybind11;

namespace pilotage::bindings {

namespace {

using Section = py::typing::Dict<py::str, py::object>;

Field find(Config& config, const std::string& key) {
    try {
        return field(config, key, "configuration");
    } catch (const ConfigError& error) {
        throw py::key_error(error.what());
    }
}

py::object get(Config& config, const std::string& key) {
    const Field f = find(config, key);
    if (const auto* number = std::get_if<double*>(&f.value)) return py::float_(**number);
    if (const auto* integer = std::get_if<int*>(&f.value)) return py::int_(**integer);
    return py::str(f.text());
}

void set(Config& config, const std::string& key, const py::object& value) {
    const Field f = find(config, key);
    if (is_map(key)) throw py::value_error("set Config." + key + " instead");
    if (is_file(key)) throw py::value_error("call Config.set_camera instead of setting " + key);
    f.set(py::str(value), "configuration");
}

std::vector<std::string> sensors_of(const Config& config, Measures what) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < config.sensor_names.size(); ++i)
        if (config.params.sensors[i].measures == what) names.push_back(config.sensor_names[i]);
    return names;
}

std::size_t number_of(const Config& config, const std::string& sensor) {
    const auto& names = config.sensor_names;
    const auto at = std::find(names.begin(), names.end(), sensor);
    if (at == names.end())
        throw py::key_error("there is no sensor '" + sensor + "' in the configuration");
    return static_cast<std::size_t>(at - names.begin());
}

std::optional<CameraModel> camera_of(const Config& config, const std::string& sensor) {
    const CameraModel& camera = config.params.sensors[number_of(config, sensor)].camera;
    return camera.intrinsics().any() ? std::optional(camera) : std::nullopt;
}

void set_camera(Config& config, const std::string& sensor, const CameraModel& camera) {
    const std::size_t i = number_of(config, sensor);
    config.sensor_cameras[i] = {camera.roll_rad(), camera.pitch_rad(), ""};
    config.params.sensors[i].camera = camera;
}

Section detectors(const Config& config) {
    if (config.detectors.empty()) return {};
    const py::object section =
        py::module_::import("yaml").attr("safe_load")(readable(config.detectors));
    return section.is_none() ? Section() : Section(section);
}

void set_detectors(Config& config, const Section& section) {
    const py::str yaml = py::module_::import("yaml").attr("safe_dump")(section);
    config.detectors = kept_section(yaml, "Config.detectors");
}

}  // namespace

void bind_config(py::module_& m) {
    py::class_<Config>(m, "Config", R"(All that a run needs besides its input.

Keys are dotted, as in the file: ``config["sensors.camera.sigma_bearing_rad"] = 0.02``. Speaking of a
sensor that is not there adds it. `describe` lists every key with its value and meaning.
)")
        .def(py::init<>())
        .def(py::init<const Config&>(), py::arg("other"), "A copy.")
        .def_static(
            "parse",
            [](const std::string& yaml) { return parse_config(yaml, "configuration", ""); },
            py::arg("yaml"), "Reads YAML text; raises ConfigError.")
        .def(
            "to_yaml", [](const Config& config) { return to_yaml(config); },
            "Every key with its value, and the map.")
        .def("__getitem__", &get, py::arg("key"), "Raises KeyError naming the nearest known key.")
        .def("__setitem__", &set, py::arg("key"), py::arg("value"),
             "Raises KeyError naming the nearest known key, ConfigError for an impossible value.")
        .def(
            "describe",
            [](Config& config) {
                std::vector<std::tuple<std::string, std::string, std::string>> rows;
                for (const Field& f : fields(config))
                    rows.emplace_back(f.key, f.unset() ? "" : f.text(), f.meaning);
                return rows;
            },
            "(key, value, meaning) of every key.")
        .def(
            "check", [](const Config& config) { check(config, "configuration"); },
            "Raises ConfigError if the parts do not fit together.")
        .def_property_readonly(
            "sensors", [](const Config& config) { return config.sensor_names; },
            "Names of the sensors.")
        .def_property_readonly(
            "marker_sensors",
            [](const Config& config) { return sensors_of(config, Measures::markers); },
            "Names of those that measure markers.")
        .def_property_readonly(
            "pixel_sensors",
            [](const Config& config) { return sensors_of(config, Measures::pixels); },
            "Names of those that measure pixels.")
        .def("camera", &camera_of, py::arg("sensor"),
             "The CameraModel of a sensor by its name, None if it has no intrinsics; KeyError if "
             "there is no such sensor.")
        .def("set_camera", &set_camera, py::arg("sensor"), py::arg("camera"),
             "Gives a sensor a camera, with its roll and pitch; KeyError if there is no such "
             "sensor.")
        .def_property("detectors", &detectors, &set_detectors,
                      "The section of that name as it stands, by sensor; empty where there is "
                      "none. The node passes over it.")
        .def_readwrite("map", &Config::map, "The MarkerMap.")
        .def_readwrite("walls", &Config::walls, "The WallMap.");
    m.def("load_config", &load_config, py::arg("path"),
          "Reads a configuration file and the map that it names; raises ConfigError naming file "
          "and line.");
}

}  // namespace pilotage::bindings
