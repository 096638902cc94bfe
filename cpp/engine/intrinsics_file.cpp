#include "intrinsics_file.hpp"

#include <algorithm>
#include <cmath>

#include "config.hpp"
#include "words.hpp"
#include "yaml_nodes.hpp"

namespace pilotage {

using namespace yaml;

namespace {

YAML::Node needed(const YAML::Node& node, const char* key, const std::string& where) {
    if (!node.IsMap())
        fail(where, node,
             "a camera's calibration has the keys image_width, image_height, camera_matrix and "
             "distortion_coefficients");
    const YAML::Node value = node[key];
    if (!value.IsDefined())
        fail(where, node,
             std::string("'") + key +
                 "' is missing; a calibration has image_width, image_height, camera_matrix and "
                 "distortion_coefficients, as OpenCV and ROS write them");
    return value;
}

/// The numbers of a matrix, row by row.
std::vector<double> numbers(const YAML::Node& node, const char* key, const std::string& where) {
    const YAML::Node matrix = needed(node, key, where);
    const YAML::Node data = matrix.IsMap() ? matrix["data"] : matrix;
    if (!data.IsDefined() || !data.IsSequence())
        fail(where, matrix, std::string(key) + " has no 'data', a list of numbers");
    std::vector<double> values;
    for (const auto& value : data) values.push_back(number(value, key, where));
    return values;
}

YAML::Node matrix_node(int rows, int columns, const std::vector<double>& values) {
    YAML::Node node;
    node["rows"] = rows;
    node["cols"] = columns;
    for (const double v : values) node["data"].push_back(words("%.17g", v));
    node.SetStyle(YAML::EmitterStyle::Flow);
    return node;
}

}  // namespace

std::string read_calibration(const std::string& path) {
    std::string text = read_file(path);
    // "%YAML:1.0" is no directive of YAML. Its line stays, so that lines count as in the file.
    if (text.compare(0, 5, "%YAML") == 0) text.erase(0, std::min(text.find('\n'), text.size()));
    return text;
}

Intrinsics parse_intrinsics(const YAML::Node& node, const std::string& where) {
    const auto size = [&](const char* key) {
        return whole_number(needed(node, key, where), key, where);
    };
    if (node.IsMap()) each_pair(node, where, [](const auto&...) {});  // none comes twice
    Intrinsics c;
    c.width_px = size("image_width");
    c.height_px = size("image_height");
    const std::vector<double> m = numbers(node, "camera_matrix", where);
    if (m.size() != 9)
        fail(where, node["camera_matrix"],
             words("camera_matrix has %d numbers, expected 9: fx 0 cx, 0 fy cy, 0 0 1",
                   static_cast<int>(m.size())));
    if (m[1] != 0 || m[3] != 0 || m[6] != 0 || m[7] != 0 || m[8] != 1)
        fail(where, node["camera_matrix"],
             "camera_matrix is not of the form fx 0 cx, 0 fy cy, 0 0 1");
    c.fx_px = m[0];
    c.cx_px = m[2];
    c.fy_px = m[4];
    c.cy_px = m[5];
    if (const YAML::Node model = node["distortion_model"]; model.IsDefined() && model.IsScalar())
        if (const std::string& name = model.Scalar();
            name != "plumb_bob" && name != "rational_polynomial")
            fail(where, model,
                 "distortion_model is '" + name +
                     "', expected plumb_bob or rational_polynomial; calibrate with one of them");
    return checked_intrinsics(c, numbers(node, "distortion_coefficients", where),
                              at(where, node.Mark()));
}

YAML::Node to_node(const Intrinsics& c) {
    YAML::Node node;
    node["image_width"] = c.width_px;
    node["image_height"] = c.height_px;
    node["camera_matrix"] = matrix_node(3, 3, {c.fx_px, 0, c.cx_px, 0, c.fy_px, c.cy_px, 0, 0, 1});
    node["distortion_coefficients"] =
        matrix_node(1, Intrinsics::kMostCoefficients, {c.distortion.begin(), c.distortion.end()});
    return node;
}

Intrinsics checked_intrinsics(Intrinsics intrinsics, const std::vector<double>& distortion,
                              const std::string& where) {
    const auto fail = [&](const std::string& what) { throw ConfigError(where + ": " + what); };
    const Intrinsics& c = intrinsics;
    if (c.width_px < 1 || c.height_px < 1)
        fail(
            words("the image size is %d x %d, expected the width and height in pixels of the "
                  "images that were calibrated",
                  c.width_px, c.height_px));
    for (const auto& [name, value] : {std::pair{"fx", c.fx_px}, {"fy", c.fy_px}})
        if (!(std::isfinite(value) && value > 0))
            fail(words("%s is %g, expected a focal length in pixels above 0", name, value));
    for (const auto& [name, value] : {std::pair{"cx", c.cx_px}, {"cy", c.cy_px}})
        if (!std::isfinite(value)) fail(words("%s is %g, expected a finite number", name, value));
    const std::size_t n = distortion.size();
    if (n != 0 && n != 4 && n != 5 && n != 8)
        fail(
            words("there are %d distortion coefficients, expected 4 (k1 k2 p1 p2), 5 (and k3) or "
                  "8 (and k4 k5 k6) of OpenCV's standard or rational model; calibrate without "
                  "the thin prism, tilted and fisheye models",
                  static_cast<int>(n)));
    for (std::size_t i = 0; i < n; ++i)
        if (!std::isfinite(distortion[i]))
            fail(words("distortion coefficient %d is %g, expected a finite number",
                       static_cast<int>(i) + 1, distortion[i]));
    std::copy(distortion.begin(), distortion.end(), intrinsics.distortion.begin());
    return intrinsics;
}

}  // namespace pilotage
