#include <pybind11/eigen.h>

#include <algorithm>
#include <array>
#include <vector>

#include "arrays.hpp"
#include "bindings.hpp"
#include "pilotage/motion/calibrated.hpp"
#include "pilotage/motion/differential_drive.hpp"
#include "pilotage/motion/unicycle.hpp"

namespace py = pybind11;

namespace pilotage::bindings {

namespace {

using Midpoint = Unicycle<double, Chord::midpoint>;
using Arc = Unicycle<double, Chord::arc>;
using CalibratedArc = Calibrated<Arc, double>;

constexpr const char* kLinearize = R"(f(x, u) and its Jacobians.

Returns
-------
next : (n,) float, the state after the motion
a : (n, n) float, by the state
b : (3, m) float, the pose by the input
)";

template <typename Model, int N, int Inputs>
auto linearize(const Model& model, const Vector<double, N>& x, const Vector<double, Inputs>& u) {
    const auto step = model.linearize(x, u);
    return std::make_tuple(Vector<double, N>(step.next), Matrix<double, N>(step.a.dense()), step.b);
}

/// Rows of three, as numpy sees them.
using Poses = std::vector<std::array<double, 3>>;

py::array_t<double> as_array(const Poses& poses) {
    return py::array_t<double>({static_cast<py::ssize_t>(poses.size()), py::ssize_t{3}},
                               poses.empty() ? nullptr : poses.front().data());
}

void step(const Arc& model, const double* pose, const double* u, double* next) {
    using X = Eigen::Map<const Vector<double, 3>>;
    using U = Eigen::Map<const Vector<double, 2>>;
    const Pose<double> reached = model.linearize(X(pose), U(u)).next;
    std::copy_n(reached.data(), 3, next);
}

auto path(const Arc& model, const Vector<double, 3>& start, const Array<double>& u) {
    expect_shape(u, u.size() / 2, 2, "u");
    Poses poses(static_cast<std::size_t>(u.shape(0)) + 1);
    poses[0] = {start[0], start[1], start[2]};
    for (std::size_t i = 0; i + 1 < poses.size(); ++i)
        step(model, poses[i].data(), u.data() + 2 * i, poses[i + 1].data());
    return as_array(poses);
}

auto step_each(const Arc& model, const Array<double>& from, const Array<double>& u) {
    expect_shape(u, u.size() / 2, 2, "u");
    expect_shape(from, u.shape(0), 3, "x");
    Poses poses(static_cast<std::size_t>(u.shape(0)));
    for (std::size_t i = 0; i < poses.size(); ++i)
        step(model, from.data() + 3 * i, u.data() + 2 * i, poses[i].data());
    return as_array(poses);
}

}  // namespace

void bind_motion(py::module_& m) {
    py::class_<Midpoint>(m, "MidpointUnicycle",
                         R"(u = (distance [m], turn [rad]), driven along the mid heading.

Eqs. 16 to 18 of Kiriy and Buehler 2002.
)")
        .def(py::init([](double slip) { return Midpoint{slip}; }), py::arg("slip_angle_rad") = 0.0)
        .def("linearize", &linearize<Midpoint, 3, 2>, py::arg("x"), py::arg("u"), kLinearize);
    py::class_<Arc>(m, "ArcUnicycle", "u = (distance [m], turn [rad]), driven along the exact arc.")
        .def(py::init([](double slip) { return Arc{slip}; }), py::arg("slip_angle_rad") = 0.0)
        .def("linearize", &linearize<Arc, 3, 2>, py::arg("x"), py::arg("u"), kLinearize)
        .def("path", &path, py::arg("x"), py::arg("u"),
             "The poses (n + 1, 3) from x (3,) on, one step after the other, u (n, 2).")
        .def("step_each", &step_each, py::arg("x"), py::arg("u"),
             "The poses (n, 3) one step from each of x (n, 3), u (n, 2).");
    py::class_<DifferentialDrive<double>>(
        m, "DifferentialDrive",
        R"(u = (left travel [m], right travel [m]), heading from the wheels.

Eqs. 16 to 22 of Kiriy and Buehler 2002.
)")
        .def(py::init([](double width) { return DifferentialDrive<double>{width}; }),
             py::arg("track_width_m"))
        .def("linearize", &linearize<DifferentialDrive<double>, 3, 2>, py::arg("x"), py::arg("u"),
             kLinearize);
    py::class_<GyroDrive<double>>(
        m, "GyroDrive",
        R"(u = (left travel [m], right travel [m], turn by the gyro [rad]).

Eqs. 16 to 19 of Kiriy and Buehler 2002; its B replaces eq. 22, which holds only where the heading comes
from the wheels.
)")
        .def(py::init<>())
        .def("linearize", &linearize<GyroDrive<double>, 3, 3>, py::arg("x"), py::arg("u"),
             kLinearize);
    py::class_<CalibratedArc>(
        m, "CalibratedArc",
        R"(ArcUnicycle behind the calibration states gyro bias [rad/s], distance scale and
rotation scale (six states); u = (distance [m], turn [rad]) as measured.)")
        .def(py::init(
                 [](double gyro_time, double slip) { return CalibratedArc{Arc{slip}, gyro_time}; }),
             py::arg("gyro_time_s"), py::arg("slip_angle_rad") = 0.0)
        .def("linearize", &linearize<CalibratedArc, 6, 2>, py::arg("x"), py::arg("u"), kLinearize);
}

}  // namespace pilotage::bindings
