#include <pybind11/eigen.h>

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
        .def("linearize", &linearize<Arc, 3, 2>, py::arg("x"), py::arg("u"), kLinearize);
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
