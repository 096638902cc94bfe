#include "pilotage/wall_map.hpp"

#include "bindings.hpp"
#include "engine/config_file.hpp"
#include "measurement_methods.hpp"
#include "models.hpp"

namespace py = pybind11;

namespace pilotage::bindings {

namespace {

WallMap make_map(const Array<double>& segments) {
    expect_shape(segments, segments.size() / 4, 4, "segments");
    std::vector<Wall> walls(static_cast<std::size_t>(segments.shape(0)));
    const double* row = segments.data();
    for (Wall& wall : walls) {
        wall = {row[0], row[1], row[2], row[3]};
        row += 4;
    }
    return checked_walls(std::move(walls), "WallMap");
}

/// A range for each pose and each angle from its heading.
py::array_t<double> cast(const WallMap& map, const Array<double>& poses,
                         const Array<double>& angles_rad) {
    expect_shape(poses, poses.size() / 3, 3, "poses");
    expect_length(angles_rad, angles_rad.size(), "angles_rad");
    py::array_t<double> ranges({poses.shape(0), angles_rad.size()});
    const double* pose = poses.data();
    double* range = ranges.mutable_data();
    for (py::ssize_t i = 0; i < poses.shape(0); ++i, pose += 3)
        for (py::ssize_t j = 0; j < angles_rad.size(); ++j)
            *range++ = WallRange<double>{&map, angles_rad.data()[j]}
                           .linearize({pose[kX], pose[kY], pose[kHeading]})
                           .value[0];
    return ranges;
}

}  // namespace

void bind_wall_map(py::module_& m) {
    py::class_<WallMap>(m, "WallMap", "The walls of a world, and what a beam meets among them.")
        .def(py::init(&make_map), py::arg("segments"),
             "segments : (n, 4) float, from x, y to x, y in frame map [m], in any order; raises "
             "ConfigError for a wall without length and for what is not finite")
        .def("__len__", [](const WallMap& map) { return map.walls().size(); })
        .def_property_readonly(
            "segments",
            [](const WallMap& map) {
                py::array_t<double> rows(
                    {static_cast<py::ssize_t>(map.walls().size()), py::ssize_t{4}});
                double* row = rows.mutable_data();
                for (const Wall& w : map.walls())
                    for (const double v : {w.from_x_m, w.from_y_m, w.to_x_m, w.to_y_m}) *row++ = v;
                return rows;
            },
            "(n, 4) float, from x, y to x, y in frame map [m]")
        .def("cast", &cast, py::arg("poses"), py::arg("angles_rad"),
             "Ranges [m] (n, k) to the nearest walls from poses (n, 3) at angles (k,) from their "
             "headings; inf where there is no wall.");
    py::class_<OnRobot<WallRange>> range(m, "WallRange",
                                         R"(Distance [m] to the nearest wall along a beam.

Not defined where the beam meets no wall, or one at less than 3 degrees.
)");
    range.def(
        py::init([](const WallMap& walls, double beam, const Vector<double, 3>& mounting) {
            return OnRobot<WallRange>{{&walls, beam}, {mounting[0], mounting[1], mounting[2]}};
        }),
        py::arg("walls"), py::arg("beam_rad"),
        py::arg("mounting") = Vector<double, 3>(Vector<double, 3>::Zero()), py::keep_alive<1, 2>(),
        R"(Parameters
----------
walls : WallMap
beam_rad : from the sensor's forward axis, left positive
mounting : (3,) float, the sensor's x, y [m] and yaw [rad] in the robot frame
)");
    def_measurement(range);
}

}  // namespace pilotage::bindings
