#include "pilotage/marker_map.hpp"

#include <pybind11/stl.h>

#include <optional>

#include "arrays.hpp"
#include "bindings.hpp"
#include "engine/config_file.hpp"

namespace py = pybind11;

namespace pilotage::bindings {

namespace {

MarkerMap make_map(const Array<std::int32_t>& ids, const Array<double>& positions,
                   const py::object& sigmas, const std::optional<Array<std::int32_t>>& labels) {
    const py::ssize_t n = ids.ndim() == 1 ? ids.shape(0) : -1;
    if (n < 0) throw py::value_error("ids must be one-dimensional");
    expect_shape(positions, n, 3, "positions");
    Array<double> sigma = Array<double>::ensure(sigmas);
    if (!sigma) throw py::error_already_set();
    if (sigma.ndim() != 0) expect_length(sigma, n, "sigmas");
    if (labels) expect_length(*labels, n, "labels");
    std::vector<Marker> markers;
    for (py::ssize_t i = 0; i < n; ++i)
        markers.push_back({ids.at(i), positions.at(i, 0), positions.at(i, 1), positions.at(i, 2),
                           sigma.ndim() == 0 ? *sigma.data() : sigma.at(i),
                           labels ? labels->at(i) : -1});
    return checked_map(std::move(markers), "MarkerMap");
}

}  // namespace

void bind_marker_map(py::module_& m) {
    py::class_<MarkerMap>(m, "MarkerMap", "The surveyed markers, sorted by id.")
        .def(py::init(&make_map), py::arg("ids"), py::arg("positions"), py::arg("sigmas") = 0.0,
             py::arg("labels") = py::none(),
             R"(Parameters
----------
ids : (n,) int, 0 or more, each once
positions : (n, 3) float, x, y in frame map and z above the ground [m]
sigmas : float or (n,) float, standard deviation of the survey in x and in y [m]
labels : (n,) int, class of look-alike markers (a pole's colour), -1 none; none at all if left out

Raises
------
ValueError
    If the map is empty, an id comes twice, a number is not finite or a label is below -1.
)")
        .def_static(
            "load", &load_map, py::arg("path"),
            "Reads a YAML list of {id, x, y, z, sigma, label}; ValueError names file, line and "
            "value.")
        .def(
            "save", [](const MarkerMap& map, const std::string& path) { save_map(map, path); },
            py::arg("path"), "Writes the YAML list that `load` reads.")
        .def("__len__", [](const MarkerMap& map) { return map.markers().size(); })
        .def("__repr__",
             [](const MarkerMap& map) {
                 return "MarkerMap(" + std::to_string(map.markers().size()) + " markers)";
             })
        .def_property_readonly(
            "ids",
            [](const MarkerMap& map) {
                std::vector<std::int32_t> ids;
                for (const Marker& marker : map.markers()) ids.push_back(marker.id);
                return owning_array(std::move(ids));
            },
            "(n,) int32")
        .def_property_readonly(
            "positions",
            [](const MarkerMap& map) {
                py::array_t<double> xyz(
                    {static_cast<py::ssize_t>(map.markers().size()), py::ssize_t{3}});
                double* out = xyz.mutable_data();
                for (const Marker& marker : map.markers())
                    for (const double v : {marker.x_m, marker.y_m, marker.z_m}) *out++ = v;
                return xyz;
            },
            "(n, 3) float [m]")
        .def_property_readonly(
            "sigmas",
            [](const MarkerMap& map) {
                std::vector<double> sigmas;
                for (const Marker& marker : map.markers()) sigmas.push_back(marker.sigma_m);
                return owning_array(std::move(sigmas));
            },
            "(n,) float [m]")
        .def_property_readonly(
            "labels",
            [](const MarkerMap& map) {
                std::vector<std::int32_t> labels;
                for (const Marker& marker : map.markers()) labels.push_back(marker.label);
                return owning_array(std::move(labels));
            },
            "(n,) int32, -1 where there is none");
}

}  // namespace pilotage::bindings
