#include "pilotage/sensing/camera_model.hpp"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "arrays.hpp"
#include "bindings.hpp"
#include "engine/config.hpp"
#include "engine/intrinsics_file.hpp"
#include "pilotage/association/nearest_projection.hpp"

namespace py = pybind11;

namespace pilotage::bindings {

namespace {

CameraModel make_camera(const std::array<int, 2>& size, const std::array<double, 4>& matrix,
                        const std::vector<double>& distortion, double roll_rad, double pitch_rad) {
    for (const auto& [name, angle] : {std::pair{"roll_rad", roll_rad}, {"pitch_rad", pitch_rad}})
        if (!std::isfinite(angle))
            throw py::value_error(std::string("CameraModel: ") + name + " is " +
                                  std::to_string(angle) + ", expected a finite number");
    const Intrinsics intrinsics{size[0], size[1], matrix[0], matrix[1], matrix[2], matrix[3], {}};
    return {checked_intrinsics(intrinsics, distortion, "CameraModel"), roll_rad, pitch_rad};
}

/// `of` of each row of (n, Columns), which has as many values as its result.
template <int Columns, typename Function>
py::array_t<double> each_row(const Array<double>& rows, const char* name, const Function& of) {
    using Row = Vector<double, Columns>;
    constexpr py::ssize_t values = decltype(of(Row{}).value)::RowsAtCompileTime;
    const py::ssize_t n = rows.ndim() == 2 ? rows.shape(0) : rows.size() / Columns;
    expect_shape(rows, n, Columns, name);
    py::array_t<double> result({n, values});
    const double* in = rows.data();
    double* out = result.mutable_data();
    for (py::ssize_t i = 0; i < n; ++i, in += Columns)
        out = std::copy_n(of(Row(Eigen::Map<const Row>(in))).value.data(), values, out);
    return result;
}

py::array_t<double> angle_covariance(const CameraModel& camera, const Array<double>& pixels,
                                     const Array<double>& covariance) {
    const py::ssize_t n = pixels.ndim() == 2 ? pixels.shape(0) : pixels.size() / 2;
    expect_shape(pixels, n, 2, "pixels");
    if (covariance.ndim() != 3 || covariance.shape(0) != n || covariance.shape(1) != 2 ||
        covariance.shape(2) != 2)
        throw py::value_error("covariance must have shape (" + std::to_string(n) + ", 2, 2)");
    py::array_t<double> result({n, py::ssize_t{2}, py::ssize_t{2}});
    using RowMajor = Eigen::Matrix<double, 2, 2, Eigen::RowMajor>;
    for (py::ssize_t i = 0; i < n; ++i) {
        const Vector<double, 2> pixel(pixels.at(i, 0), pixels.at(i, 1));
        const auto h = camera.angles(pixel);
        Eigen::Map<RowMajor> out(result.mutable_data(i));
        out = h.jacobian * Eigen::Map<const RowMajor>(covariance.data(i)) * h.jacobian.transpose();
        if (!h.defined) out.setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    return result;
}

py::array_t<std::int32_t> associate_pixels(const CameraModel& camera,
                                           const Vector<double, 4>& mounting,
                                           const Vector<double, 3>& pose, const MarkerMap& map,
                                           const Array<double>& pixels, double radius_pixel,
                                           const std::optional<Array<std::int32_t>>& labels) {
    const py::ssize_t n = pixels.ndim() == 2 ? pixels.shape(0) : pixels.size() / 2;
    expect_shape(pixels, n, 2, "pixels");
    if (labels) expect_length(*labels, n, "labels");
    if (!(radius_pixel > 0))
        throw py::value_error("radius_pixel is " + std::to_string(radius_pixel) +
                              ", expected pixels above 0");
    SensorParams sensor;
    sensor.x_m = mounting[0];
    sensor.y_m = mounting[1];
    sensor.z_m = mounting[2];
    sensor.yaw_rad = mounting[3];
    sensor.camera = camera;
    std::vector<Sighting> seen;
    for (py::ssize_t i = 0; i < n; ++i)
        seen.push_back({{pixels.at(i, 0), pixels.at(i, 1), NAN},
                        {NAN, NAN, NAN},
                        kUnknownId,
                        labels ? labels->at(i) : -1});
    std::vector<const Sighting*> places;
    for (const Sighting& pixel : seen) places.push_back(&pixel);
    std::vector<NearestProjection<double>> found(seen.size());
    find_nearest_projections<double>(pose, map, sensor, radius_pixel, places.data(), places.size(),
                                     found.data(), [](std::int32_t) { return true; });
    std::vector<std::int32_t> ids;
    for (const auto& nearest : found) ids.push_back(nearest.id);
    return owning_array(std::move(ids));
}

std::string describe(const CameraModel& camera) {
    const Intrinsics& c = camera.intrinsics();
    return "CameraModel(size=(" + std::to_string(c.width_px) + ", " + std::to_string(c.height_px) +
           "))";
}

}  // namespace

void bind_camera_model(py::module_& m) {
    py::class_<CameraModel>(m, "CameraModel",
                            R"(A camera on the robot: from points to pixels and back.

OpenCV's pinhole with its radial and tangential distortion. Pixel (0, 0) is the centre of the top
left one, u to the right, v down. The level sensor frame has its origin at the sensor, x along its
forward axis (the mounting's yaw) in the horizontal plane, y left and z up.
)")
        .def(py::init(&make_camera), py::arg("size"), py::arg("matrix"),
             py::arg("distortion") = std::vector<double>{}, py::arg("roll_rad") = 0.0,
             py::arg("pitch_rad") = 0.0,
             R"(Parameters
----------
size : (width, height) of the image [px]
matrix : (fx, fy, cx, cy) [px]
distortion : none, 4 (k1 k2 p1 p2), 5 (and k3) or 8 (and k4 k5 k6) numbers
roll_rad, pitch_rad : of the camera body in the level sensor frame, R = Ry(pitch) Rx(roll): positive
    pitch looks down, positive roll lowers the right side

Raises
------
ValueError
    Naming what is not finite, not positive, or of the wrong length.
)")
        .def(
            "project",
            [](const CameraModel& camera, const Array<double>& points) {
                return each_row<3>(points, "points", [&](const Vector<double, 3>& point) {
                    return camera.project(point);
                });
            },
            py::arg("points"),
            "Pixels (n, 2) of points (n, 3) in the level sensor frame [m]; NaN behind the camera "
            "and beyond where the distortion is one-to-one. They may lie outside the image.")
        .def(
            "rays",
            [](const CameraModel& camera, const Array<double>& pixels) {
                return each_row<2>(pixels, "pixels", [&](const Vector<double, 2>& pixel) {
                    return camera.ray(pixel);
                });
            },
            py::arg("pixels"),
            "Unit vectors (n, 3) in the level sensor frame towards what is seen at pixels (n, 2); "
            "NaN where no point is seen.")
        .def(
            "angles",
            [](const CameraModel& camera, const Array<double>& pixels) {
                return each_row<2>(pixels, "pixels", [&](const Vector<double, 2>& pixel) {
                    return camera.angles(pixel);
                });
            },
            py::arg("pixels"),
            "(n, 2): azimuth, left positive, and elevation, up positive [rad], of what is seen at "
            "pixels (n, 2): bearing and elevation of a sighting. NaN where no point is seen.")
        .def("angle_covariance", &angle_covariance, py::arg("pixels"), py::arg("covariance"),
             "Covariance (n, 2, 2) of the angles [rad^2] from that of the pixels (n, 2, 2) [px^2], "
             "to first order.")
        .def_property_readonly(
            "size",
            [](const CameraModel& camera) {
                return std::pair(camera.intrinsics().width_px, camera.intrinsics().height_px);
            },
            "(width, height) [px]")
        .def_property_readonly(
            "matrix",
            [](const CameraModel& camera) {
                const Intrinsics& c = camera.intrinsics();
                return std::tuple(c.fx_px, c.fy_px, c.cx_px, c.cy_px);
            },
            "(fx, fy, cx, cy) [px]")
        .def_property_readonly(
            "distortion", [](const CameraModel& camera) { return camera.intrinsics().distortion; },
            "k1 k2 p1 p2 k3 k4 k5 k6")
        .def_property_readonly("roll_rad", &CameraModel::roll_rad)
        .def_property_readonly("pitch_rad", &CameraModel::pitch_rad)
        .def_property_readonly("rotation", &CameraModel::rotation,
                               "(3, 3), from OpenCV's camera frame (x right, y down, z forward) to "
                               "the level sensor frame")
        .def_property_readonly(
            "widest_rad", [](const CameraModel& camera) { return std::atan(camera.widest()); },
            "Angle from the optical axis within which the distortion is one-to-one.")
        .def("__repr__", &describe);
    m.def("associate_pixels", &associate_pixels, py::arg("camera"), py::arg("mounting"),
          py::arg("pose"), py::arg("map"), py::arg("pixels"), py::arg("radius_pixel"),
          py::arg("labels") = py::none(),
          R"(Which markers pixels are of: the one projected nearest, within a radius.

Section 2 of Kiriy and Buehler 2002, where the radius is 64. Of two pixels at one marker the nearer has it.

Parameters
----------
camera : CameraModel
mounting : (4,) float, the sensor's x, y, z [m] and yaw [rad] in the robot frame
pose : (3,) float, x, y [m] and heading [rad] of the robot in frame map
map : MarkerMap
pixels : (n, 2) float
radius_pixel : below which a projection is near
labels : (n,) int, class of look-alike markers, -1 any

Returns
-------
(n,) int32, ids of markers, -1 where there is none
)");
}

}  // namespace pilotage::bindings
