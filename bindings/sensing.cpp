#include <pybind11/stl.h>

#include <algorithm>

#include "bindings.hpp"
#include "marker_model.hpp"
#include "measurement_methods.hpp"

namespace py = pybind11;

namespace pilotage::bindings {

namespace {

MarkerModel make_model(const Vector<double, 3>& marker, const std::vector<std::string>& components,
                       const Vector<double, 4>& mounting, double range_scale,
                       double range_offset_m) {
    const std::vector<std::string> known = {"bearing", "elevation", "range"};
    std::size_t last = 0;
    for (const std::string& component : components) {
        const auto at =
            std::find(known.begin() + static_cast<std::ptrdiff_t>(last), known.end(), component);
        if (at == known.end())
            throw py::value_error(
                "components are some of bearing, elevation, range, in this order; got '" +
                component + "'");
        last = static_cast<std::size_t>(at - known.begin()) + 1;
    }
    if (components.empty()) throw py::value_error("components must name at least one");
    const auto has = [&](const char* name) {
        return std::find(components.begin(), components.end(), name) != components.end();
    };
    Vector<double, 3> above = marker;
    above[2] -= mounting[2];
    return {above,
            has("bearing"),
            has("elevation"),
            has("range"),
            {mounting[0], mounting[1], mounting[3]},
            {range_scale, range_offset_m}};
}

}  // namespace

void bind_sensing(py::module_& m) {
    py::class_<MarkerModel>(m, "MarkerModel", "What a mounted sensor measures of one marker.")
        .def(py::init(&make_model), py::arg("marker"), py::arg("components"),
             py::arg("mounting") = Vector<double, 4>(Vector<double, 4>::Zero()),
             py::arg("range_scale") = 1.0, py::arg("range_offset_m") = 0.0,
             R"(Parameters
----------
marker : (3,) float, x, y in frame map, z above the ground [m]
components : some of "bearing" [rad], "elevation" [rad], "range" [m], in this order
mounting : (4,) float, the sensor's x, y, z [m] and yaw [rad] in the robot frame
range_scale, range_offset_m : reported = scale * true + offset
)")
        .def(
            "linearize",
            [](const MarkerModel& model, const Vector<double, 3>& pose) {
                return model.visit([&](const auto& core) { return linearize_at(core, pose); });
            },
            py::arg("pose"),
            R"(h(x) and its Jacobian: eqs. 23 to 25 of Kiriy and Buehler 2002 (25 with its signs corrected).

Returns
-------
value : (m,) float
jacobian : (m, 3) float, by (x, y, heading)
defined : bool, False at the marker itself
)")
        .def(
            "predict",
            [](const MarkerModel& model, const Array<double>& poses) {
                return model.visit([&](const auto& core) { return predict_each(core, poses); });
            },
            py::arg("poses"), "h(x) of many poses at once: (n, m) for (n, 3).")
        .def(
            "minus",
            [](const MarkerModel& model, const Eigen::VectorXd& z,
               const Eigen::VectorXd& predicted) {
                return model.visit([&](const auto& core) { return subtract(core, z, predicted); });
            },
            py::arg("z"), py::arg("predicted"),
            "Measured less predicted, (m,) each; bearings wrap.");
}

}  // namespace pilotage::bindings
