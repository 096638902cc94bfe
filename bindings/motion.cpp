#include "bindings.hpp"
#include "models.hpp"
#include "motion_methods.hpp"
#include "pilotage/motion/calibrated.hpp"
#include "pilotage/motion/differential_drive.hpp"

namespace py = pybind11;

namespace pilotage::bindings {

namespace {

using Midpoint = Unicycle<double, Chord::midpoint>;
using Arc = Unicycle<double, Chord::arc>;
using CalibratedArc = Calibrated<Arc, double>;

/// A model that is made of its side slip alone.
template <typename Model>
void bind_unicycle(py::module_& m, const char* name, const char* doc) {
    py::class_<Model> c(m, name, doc);
    c.def(py::init([](double slip) { return Model{slip}; }), py::arg("slip_angle_rad") = 0.0);
    def_motion(c);
}

/// A model of held velocities that is made of the time they are held and a side slip.
template <typename Model>
void bind_velocity(py::module_& m, const char* name, const char* doc) {
    py::class_<Model> c(m, name, doc);
    c.def(py::init([](double dt, double slip) { return Model{dt, slip}; }), py::arg("dt_s"),
          py::arg("slip_angle_rad") = 0.0);
    def_motion(c);
}

/// A model that is made of one number.
template <typename Model>
void bind_of_one(py::module_& m, const char* name, const char* parameter, const char* doc) {
    py::class_<Model> c(m, name, doc);
    c.def(py::init([](double value) { return Model{value}; }), py::arg(parameter));
    def_motion(c);
}

}  // namespace

void bind_motion(py::module_& m) {
    bind_unicycle<Midpoint>(m, "MidpointUnicycle",
                            R"(u = (distance [m], turn [rad]), driven along the mid heading.

Eqs. 16 to 18 of Kiriy and Buehler 2002.
)");
    bind_unicycle<Arc>(m, "ArcUnicycle",
                       "u = (distance [m], turn [rad]), driven along the exact arc.");
    bind_unicycle<MoveAndTurn<double>>(
        m, "MoveAndTurn",
        "u = (distance [m], turn [rad]), a straight move and then a turn on the spot.");
    bind_of_one<DifferentialDrive<double>>(
        m, "DifferentialDrive", "track_width_m",
        R"(u = (left travel [m], right travel [m]), heading from the wheels.

Eqs. 16 to 22 of Kiriy and Buehler 2002; eqs. 31 to 35 of Tamas et al. 2008 without their arctan.
)");
    py::class_<GyroDrive<double>> gyro_drive(
        m, "GyroDrive",
        R"(u = (left travel [m], right travel [m], turn by the gyro [rad]).

Eqs. 16 to 19 of Kiriy and Buehler 2002; its B replaces eq. 22, which holds only where the heading comes
from the wheels.
)");
    def_motion(gyro_drive.def(py::init<>()));
    py::class_<CalibratedArc> calibrated(
        m, "CalibratedArc",
        R"(ArcUnicycle behind the calibration states gyro bias [rad/s], distance scale and
rotation scale (six states); u = (distance [m], turn [rad]) as measured.)");
    calibrated.def(
        py::init([](double gyro_time, double slip) { return CalibratedArc{Arc{slip}, gyro_time}; }),
        py::arg("gyro_time_s"), py::arg("slip_angle_rad") = 0.0);
    def_motion(calibrated);

    bind_velocity<EulerVelocity>(
        m, "EulerVelocity",
        R"(u = (speed [m/s], yaw rate [rad/s]) over dt_s, along the heading at the start.

Eqs. 5 and 6 of Kohler's final project report.
)");
    bind_velocity<MidpointVelocity>(
        m, "MidpointVelocity",
        "u = (speed [m/s], yaw rate [rad/s]) over dt_s, along the mid heading.");
    bind_velocity<ArcVelocity>(
        m, "ArcVelocity", "u = (speed [m/s], yaw rate [rad/s]) over dt_s, along the exact arc.");
    bind_of_one<LinearizedVelocity<double>>(
        m, "LinearizedVelocity", "dt_s",
        R"(ArcVelocity whose covariance moves by exp(A dt), linearised at the start of the step.

Eqs. 4 to 7 of Sousa, Costa, Moreira and Carvalho.
)");
    bind_of_one<PlanarVelocity<double>>(
        m, "PlanarVelocity", "dt_s",
        "u = (forward [m/s], leftward [m/s], yaw rate [rad/s]) of the body, held over dt_s.");
    py::class_<SkidSteer<double>> skid(
        m, "SkidSteer",
        R"(u = (right, left) speed of the wheels [m/s], held over dt_s.

Eqs. 29 and 30 of Tamas et al. 2008: the (3, 2) coefficients give forward and leftward velocity and
yaw rate [rad/m].
)");
    skid.def(
        py::init([](const Matrix<double, 3, 2>& a, double dt) { return SkidSteer<double>{a, dt}; }),
        py::arg("coefficients"), py::arg("dt_s"));
    def_motion(skid);
    bind_of_one<ConstantVelocity<double>>(
        m, "ConstantVelocity", "dt_s",
        R"(State (x, y, heading, speed [m/s], yaw rate [rad/s]), along the exact arc.

u = (acceleration [m/s^2], yaw acceleration [rad/s^2]) over dt_s, normally zero: its covariance is the
process noise.
)");
}

}  // namespace pilotage::bindings
