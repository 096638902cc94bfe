#include "bindings.hpp"
#include "measurement_methods.hpp"
#include "models.hpp"

namespace py = pybind11;

namespace pilotage::bindings {

namespace {

using Plane = Vector<double, 2>;

const Vector<double, 3> kAtTheOrigin = Vector<double, 3>::Zero();

PlanarMounting<double> mounted_at(const Vector<double, 3>& mounting) {
    return {mounting[0], mounting[1], mounting[2]};
}

void bind_marker_measurements(py::module_& m) {
    py::class_<OnRobot<RelativePosition>> relative(
        m, "RelativePosition",
        R"((forward, leftward) [m] from a mounted sensor to a marker.

Eqs. 8 and 9 of Sousa, Costa, Moreira and Carvalho.
)");
    relative.def(py::init([](const Plane& marker, const Vector<double, 3>& mounting) {
                     return OnRobot<RelativePosition>{{marker}, mounted_at(mounting)};
                 }),
                 py::arg("marker"), py::arg("mounting") = kAtTheOrigin,
                 R"(Parameters
----------
marker : (2,) float, x, y in frame map [m]
mounting : (3,) float, the sensor's x, y [m] and yaw [rad] in the robot frame
)");
    def_measurement(relative);
    m.def("relative_position_noise", &relative_position_noise<double>, py::arg("relative_m"),
          py::arg("sigma_distance_per_m"), py::arg("sigma_bearing_rad"),
          R"(R (2, 2) [m^2] of a RelativePosition, its axes along the line of sight and across it.

Eqs. 13 to 16 of Sousa, Costa, Moreira and Carvalho, with eq. 15 transposed as it should be; relative_m
(2,) is measured or predicted.
)");
    py::class_<WorldBearingSighting> bearing(
        m, "WorldBearing",
        R"(Direction from a marker to the robot in frame map [rad]; it does not see the heading.

Eq. 4 of Kohler's final project report, its innovation wrapped.
)");
    bearing.def(py::init([](const Plane& marker) {
                    return WorldBearingSighting{{marker[0], marker[1], 0}};
                }),
                py::arg("marker"), "marker : (2,) float, x, y in frame map [m]");
    def_measurement(bearing);
}

void bind_fixes(py::module_& m) {
    py::class_<OnRobot<PositionFix>> position(
        m, "PositionFix", "x, y [m] in frame map of a point of the robot, such as an antenna.");
    position.def(
        py::init([](const Plane& arm) { return OnRobot<PositionFix>{{}, {arm[0], arm[1], 0}}; }),
        py::arg("lever_arm") = Plane(Plane::Zero()),
        "lever_arm : (2,) float, forward and leftward of the robot's origin [m]");
    def_measurement(position);
    py::class_<OnRobot<HeadingFix>> heading(m, "HeadingFix",
                                            "Heading [rad] from +x of frame map: a compass.");
    heading.def(py::init([](double offset) { return OnRobot<HeadingFix>{{}, {0, 0, offset}}; }),
                py::arg("offset_rad") = 0.0, "offset_rad : read less the robot's heading");
    def_measurement(heading);
    py::class_<OnRobot<PoseFix>> pose(m, "PoseFix", "x, y [m] and heading [rad] of a sensor.");
    pose.def(py::init([](const Vector<double, 3>& mounting) {
                 return OnRobot<PoseFix>{{}, mounted_at(mounting)};
             }),
             py::arg("mounting") = kAtTheOrigin,
             "mounting : (3,) float, the sensor's x, y [m] and yaw [rad] in the robot frame");
    def_measurement(pose);
}

void bind_velocity_measurements(py::module_& m) {
    py::class_<Speed<double>> speed(m, "Speed", "The state's speed [m/s], its fourth entry.");
    def_measurement(speed.def(py::init<>()));
    py::class_<YawRate<double>> rate(m, "YawRate",
                                     "The state's yaw rate [rad/s], its fifth entry.");
    def_measurement(rate.def(py::init<>()));
    py::class_<WheelTravel<double>> travel(
        m, "WheelTravel",
        R"((left, right) travel [m] within dt_s, of a state with speed and yaw rate.

Eqs. 19 and 20 of Kiriy and Buehler 2002, solved for the wheels.
)");
    travel.def(py::init([](double width, double dt) { return WheelTravel<double>{width, dt}; }),
               py::arg("track_width_m"), py::arg("dt_s"));
    def_measurement(travel);
}

void bind_echo(py::module_& m) {
    py::class_<EchoEnvelope<double>> echo(
        m, "EchoEnvelope",
        R"(The envelope of an ultrasonic echo at a time, of the state (A0, tau [s], T [s], alpha).

Eq. 38 of Tamas et al. 2008 with the sign of its exponent put right; zero before tau, highest at
tau + alpha T, not defined unless T and alpha are positive.
)");
    echo.def(py::init([](double time) { return EchoEnvelope<double>{time}; }), py::arg("time_s"))
        .def_static(
            "at_times",
            [](const Vector<double, kEchoStates>& state, const Array<double>& times_s) {
                expect_length(times_s, times_s.size(), "times_s");
                py::array_t<double> values(times_s.size());
                const auto envelope = [&](double time) {
                    return EchoEnvelope<double>{time}.linearize(state).value[0];
                };
                std::transform(times_s.data(), times_s.data() + times_s.size(),
                               values.mutable_data(), envelope);
                return values;
            },
            py::arg("state"), py::arg("times_s"), "The envelope (n,) of one echo at times (n,).");
    def_measurement(echo);
}

}  // namespace

void bind_measurements(py::module_& m) {
    bind_marker_measurements(m);
    bind_fixes(m);
    bind_velocity_measurements(m);
    bind_echo(m);
}

}  // namespace pilotage::bindings
