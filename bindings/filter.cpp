#include "pilotage/filter/ekf.hpp"

#include "bindings.hpp"
#include "filter_methods.hpp"
#include "filter_models.hpp"
#include "pilotage/motion/calibrated.hpp"
#include "pilotage/motion/differential_drive.hpp"
#include "pilotage/params.hpp"

namespace py = pybind11;

namespace pilotage::bindings {

namespace {

const char* name(UpdateFault fault) {
    constexpr const char* names[] = {"", "gated", "undefined", "numeric"};
    return names[static_cast<int>(fault)];
}

template <int Seen, int M, int N>
Report correct(Ekf<double, N>& filter, const Eigen::VectorXd& innovation, const Eigen::MatrixXd& h,
               const Eigen::MatrixXd& r, const Policy& policy) {
    return any_size(filter.correct(Vector<double, M>(innovation), Matrix<double, M, Seen>(h),
                                   Matrix<double, M>(r), policy));
}

template <int N, int Seen>
Report correct_any(Ekf<double, N>& filter, const Eigen::VectorXd& innovation,
                   const Eigen::MatrixXd& h, const Eigen::MatrixXd& r, const Policy& policy) {
    const auto m = innovation.size();
    if (h.rows() != m || h.cols() != Seen || r.rows() != m || r.cols() != m)
        throw py::value_error("innovation (m,), h (m, " + std::to_string(Seen) +
                              ") and r (m, m) do not fit each other");
    switch (m) {
        case 1:
            return correct<Seen, 1>(filter, innovation, h, r, policy);
        case 2:
            return correct<Seen, 2>(filter, innovation, h, r, policy);
        case 3:
            return correct<Seen, 3>(filter, innovation, h, r, policy);
        default:
            throw py::value_error("an update has 1, 2 or 3 components");
    }
}

/// \tparam Seen the states that a Jacobian given to `correct` is by
template <int N, int Seen>
py::class_<Ekf<double, N>> bind_ekf(py::module_& m, const char* class_name, const char* doc) {
    using Filter = Ekf<double, N>;
    py::class_<Filter> c(m, class_name, doc);
    c.def(py::init<const Vector<double, N>&, const Matrix<double, N>&>(), py::arg("x"),
          py::arg("p"));
    def_estimate(c);
    def_update_by_marker(
        c,
        "Measurement update, eqs. 10, 11 and 28 of Kiriy and Buehler 2002 (Joseph form), "
        "linearised at the "
        "state as it stands. Nothing changes unless the report says accepted.");
    const std::string seen = std::to_string(Seen);
    c.def("correct", &correct_any<N, Seen>, py::arg("innovation"), py::arg("h"), py::arg("r"),
          py::arg_v("policy", Policy{}, "Policy()"),
          ("The update with innovation (m,) and h (m, " + seen +
           ") given, so that they may be taken at another point.")
              .c_str());
    return c;
}

}  // namespace

void bind_filter(py::module_& m) {
    py::class_<Policy>(m, "Policy", "How an innovation decides about its own update.")
        .def(py::init<>(), "Every finite innovation is fused with full weight.")
        .def_static(
            "gate", [](double p) { return Policy::make(Fusion::gate, p, Policy{}.student_t_dof); },
            py::arg("false_reject"),
            "Rejects an innovation whose NIS is above the chi-square quantile.")
        .def_static(
            "student_t",
            [](double nu) {
                return Policy::make(Fusion::student_t, SensorParams{}.gate_false_reject, nu);
            },
            py::arg("dof") = Policy{}.student_t_dof, "Weights by (nu + d) / (nu + NIS), at most 1.")
        .def(
            "gate_nis", [](const Policy& p, int dof) { return p.gate_nis[dof - 1]; },
            py::arg("dof"), "The limit on the NIS for 1, 2 or 3 degrees of freedom.");
    py::class_<Report>(m, "UpdateReport", "What an update did.")
        .def_readonly("innovation", &Report::innovation, "(m,) float, measured less predicted")
        .def_readonly("s", &Report::s, "(m, m) float, H P H' + R")
        .def_readonly("nis", &Report::nis, "normalised innovation squared")
        .def_readonly("weight", &Report::weight, "robust weight, 0 when not taken")
        .def_property_readonly("accepted",
                               [](const Report& r) { return r.fault == UpdateFault::none; })
        .def_property_readonly(
            "fault", [](const Report& r) { return name(r.fault); },
            "'', 'gated', 'undefined' or 'numeric'");
    using Ekf3 = Ekf<double, 3>;
    using Ekf6 = Ekf<double, 6>;
    auto ekf3 = bind_ekf<3, 3>(m, "Ekf3", R"(The first paper's filter: x, y [m], heading [rad].

``predict(model, u, gamma, q)`` is the time update, eqs. 8 and 9: u the model's input, gamma its
covariance, q (3,) the variances added to the states.
)");
    def_predict<Ekf3, Unicycle<double, Chord::midpoint>, 2>(ekf3);
    def_predict<Ekf3, Unicycle<double, Chord::arc>, 2>(ekf3);
    def_predict<Ekf3, DifferentialDrive<double>, 2>(ekf3);
    def_predict<Ekf3, GyroDrive<double>, 3>(ekf3);
    ekf3.def("propagate", &Ekf3::propagate<Matrix<double, 3>, 3, 2>, py::arg("next"), py::arg("a"),
             py::arg("b"), py::arg("gamma"), py::arg("q"),
             "The time update with next (3,), a (3, 3) and b (3, 2) given, so that they may be "
             "taken at another "
             "point.");
    def_motions<PoseMotion>(ekf3);
    def_measurements<PoseMeasurement>(ekf3);
    auto ekf6 = bind_ekf<6, 3>(
        m, "Ekf6",
        "The filter with calibration: x, y [m], heading [rad], gyro bias [rad/s], distance "
        "scale, rotation scale.");
    def_predict<Ekf6, Calibrated<Unicycle<double, Chord::arc>, double>, 2>(ekf6);
    auto ekf5 = bind_ekf<5, 5>(
        m, "Ekf5",
        "The filter with velocities as states: x, y [m], heading [rad], speed [m/s], "
        "yaw rate [rad/s].");
    def_motions<VelocityMotion>(ekf5);
    def_measurements<PoseMeasurement>(ekf5);
    def_measurements<VelocityMeasurement>(ekf5);
}

}  // namespace pilotage::bindings
