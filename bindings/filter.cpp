#include "pilotage/filter/ekf.hpp"

#include <pybind11/eigen.h>

#include <optional>

#include "bindings.hpp"
#include "filter_models.hpp"
#include "marker_model.hpp"
#include "pilotage/motion/calibrated.hpp"
#include "pilotage/motion/differential_drive.hpp"
#include "pilotage/params.hpp"

namespace py = pybind11;

namespace pilotage::bindings {

namespace {

/// UpdateReport of any size.
struct Report {
    Eigen::VectorXd innovation;
    Eigen::MatrixXd s;
    double nis, weight;
    UpdateFault fault;
};

const char* name(UpdateFault fault) {
    constexpr const char* names[] = {"", "gated", "undefined", "numeric"};
    return names[static_cast<int>(fault)];
}

template <int M>
Report any_size(const UpdateReport<double, M>& report) {
    return {report.innovation, report.s, report.nis, report.weight, report.fault};
}

template <int N, int M>
Report correct(Ekf<double, N>& filter, const Eigen::VectorXd& innovation, const Eigen::MatrixXd& h,
               const Eigen::MatrixXd& r, const Policy& policy) {
    return any_size(filter.correct(Vector<double, M>(innovation), Matrix<double, M, 3>(h),
                                   Matrix<double, M>(r), policy));
}

template <int N>
Report correct_any(Ekf<double, N>& filter, const Eigen::VectorXd& innovation,
                   const Eigen::MatrixXd& h, const Eigen::MatrixXd& r, const Policy& policy) {
    const auto m = innovation.size();
    if (h.rows() != m || h.cols() != 3 || r.rows() != m || r.cols() != m)
        throw py::value_error("innovation (m,), h (m, 3) and r (m, m) do not fit each other");
    switch (m) {
        case 1:
            return correct<N, 1>(filter, innovation, h, r, policy);
        case 2:
            return correct<N, 2>(filter, innovation, h, r, policy);
        case 3:
            return correct<N, 3>(filter, innovation, h, r, policy);
        default:
            throw py::value_error("an update has 1, 2 or 3 components");
    }
}

template <int N>
Report update(Ekf<double, N>& filter, const MarkerModel& model, const Eigen::VectorXd& z,
              const Eigen::MatrixXd& r, const Policy& policy) {
    return model.visit([&](const auto& core) {
        constexpr int M = std::decay_t<decltype(core)>::Values::RowsAtCompileTime;
        if (z.size() != M || r.rows() != M || r.cols() != M)
            throw py::value_error("z must have shape (m,) and r (m, m) for m components");
        return any_size(filter.update(core, Vector<double, M>(z), Matrix<double, M>(r), policy));
    });
}

template <typename Filter, typename Model, int Inputs>
void def_predict(py::class_<Filter>& c) {
    c.def("predict", &Filter::template predict<Model, Inputs>, py::arg("model"), py::arg("u"),
          py::arg("gamma"), py::arg("q"));
}

template <int N>
py::class_<Ekf<double, N>> bind_ekf(py::module_& m, const char* class_name, const char* doc) {
    using Filter = Ekf<double, N>;
    py::class_<Filter> c(m, class_name, doc);
    c.def(py::init<const Vector<double, N>&, const Matrix<double, N>&>(), py::arg("x"),
          py::arg("p"))
        // By value: a view would change under the caller's feet with the next step.
        .def_property_readonly(
            "state", [](const Filter& f) { return Vector<double, N>(f.state()); },
            "(n,) float, a copy")
        .def_property_readonly(
            "covariance", [](const Filter& f) { return Matrix<double, N>(f.covariance()); },
            "(n, n) float, a copy")
        .def("update", &update<N>, py::arg("model"), py::arg("z"), py::arg("r"),
             py::arg_v("policy", Policy{}, "Policy()"),
             "Measurement update, eqs. 10, 11 and 28 of Kiriy and Buehler 2002 (Joseph form), "
             "linearised at the "
             "state as it stands. Nothing changes unless the report says accepted.")
        .def("correct", &correct_any<N>, py::arg("innovation"), py::arg("h"), py::arg("r"),
             py::arg_v("policy", Policy{}, "Policy()"),
             "The update with innovation (m,) and h (m, 3) given, so that they may be taken at "
             "another point.");
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
                return Policy::make(Fusion::student_t, MarkerSensorParams{}.gate_false_reject, nu);
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
    auto ekf3 = bind_ekf<3>(m, "Ekf3", R"(The first paper's filter: x, y [m], heading [rad].

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
    def_measurements<PoseMeasurement>(ekf3, [](const auto& report) { return any_size(report); });
    auto ekf6 = bind_ekf<6>(
        m, "Ekf6",
        "The filter with calibration: x, y [m], heading [rad], gyro bias [rad/s], distance "
        "scale, rotation scale.");
    def_predict<Ekf6, Calibrated<Unicycle<double, Chord::arc>, double>, 2>(ekf6);
}

}  // namespace pilotage::bindings
