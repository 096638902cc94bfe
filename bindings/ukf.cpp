#include "pilotage/filter/ukf.hpp"

#include <pybind11/functional.h>

#include "bindings.hpp"
#include "filter_methods.hpp"
#include "filter_models.hpp"
#include "pilotage/motion/calibrated.hpp"
#include "pilotage/motion/differential_drive.hpp"

namespace py = pybind11;

namespace pilotage::bindings {

namespace {

Unscented make_set(double alpha, double beta, double kappa) {
    if (!(alpha > 0 && beta >= 0 && kappa >= 0))
        throw py::value_error(
            "alpha must be above 0, beta and kappa 0 or more: else a covariance may not be one");
    return {alpha, beta, kappa};
}

template <int N, typename Space = HeadingSpace>
py::class_<Ukf<double, N, Space>> bind_filter(py::module_& m, const char* name, const char* doc) {
    using Filter = Ukf<double, N, Space>;
    py::class_<Filter> c(m, name, doc);
    c.def(py::init<const Vector<double, N>&, const Matrix<double, N>&, const Unscented&>(),
          py::arg("x"), py::arg("p"), py::arg_v("unscented", Unscented{}, "Unscented()"));
    def_estimate(c);
    return c;
}

/// Of functions with up to so many arguments and values.
constexpr int kMost = 6;
using Most = Vector<double, kMost>;
using Function = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

auto transform(const Eigen::VectorXd& mean, const Eigen::MatrixXd& covariance, const Function& f,
               const Unscented& set) {
    const auto n = mean.size();
    if (covariance.rows() != n || covariance.cols() != n)
        throw py::value_error("mean (n,) and covariance (n, n) do not fit each other");
    if (n > kMost) throw py::value_error("unscented_transform takes up to 6 entries");
    // What has no variance has no points: a smaller mean is one of six among certain ones.
    Most x = Most::Zero();
    Matrix<double, kMost> p = Matrix<double, kMost>::Zero();
    x.head(n) = mean;
    p.topLeftCorner(n, n) = covariance;
    Eigen::Index m = -1;
    const auto padded = [&](const Most& at) {
        const Eigen::VectorXd value = f(at.head(n));
        if (m < 0) m = value.size();
        if (value.size() != m || m > kMost)
            throw py::value_error("f must return up to 6 entries, always as many");
        Most all = Most::Zero();
        all.head(m) = value;
        return all;
    };
    const auto y = unscented_transform(x, p, padded, set);
    return std::make_tuple(Eigen::VectorXd(y.mean.head(m)),
                           Eigen::MatrixXd(y.covariance.topLeftCorner(m, m)));
}

void bind_unscented(py::module_& m) {
    py::class_<Unscented>(
        m, "Unscented",
        R"(The set of sigma points: mean +- sqrt(c) times the columns of a Cholesky root.

c = alpha^2 (n + kappa), with n the entries that have a variance. ``Unscented()`` is the set of 2n
points with equal weights, ``Unscented(kappa=1)`` that of eq. 14 of Tamas et al. 2008.
)")
        .def(py::init(&make_set), py::arg("alpha") = Unscented{}.alpha,
             py::arg("beta") = Unscented{}.beta, py::arg("kappa") = Unscented{}.kappa,
             "alpha above 0, beta and kappa 0 or more: no covariance comes out indefinite then.")
        .def_readonly("alpha", &Unscented::alpha, "spread of the points")
        .def_readonly("beta", &Unscented::beta, "weight of the mean's shift in the covariance")
        .def_readonly("kappa", &Unscented::kappa, "added to n");
    m.def(
        "unscented_transform", &transform, py::arg("mean"), py::arg("covariance"), py::arg("f"),
        py::arg_v("unscented", Unscented{}, "Unscented()"),
        R"(Mean and covariance of f(x), eqs. 14 to 17 of Tamas et al. 2008; none of its values an angle.

Parameters
----------
mean : (n,) float, n up to 6
covariance : (n, n) float
f : from (n,) float to (m,) float, m up to 6

Returns
-------
mean : (m,) float
covariance : (m, m) float
)");
}

}  // namespace

void bind_ukf(py::module_& m) {
    bind_unscented(m);
    using Arc = Unicycle<double, Chord::arc>;
    using Ukf3 = Ukf<double, 3>;
    using Ukf6 = Ukf<double, 6>;
    auto ukf3 = bind_filter<3>(m, "Ukf3",
                               R"(Ekf3's unscented counterpart: x, y [m], heading [rad].

It takes the models that Ekf3 takes and uses their values alone, eqs. 14 to 28 of Tamas et al. 2008.
``predict(model, u, gamma, q)``: u the model's input, gamma its covariance, q (3,) the variances
added to the states. Sigma points are of state and input; with gamma zero, of the state alone.
)");
    def_predict<Ukf3, Unicycle<double, Chord::midpoint>, 2>(ukf3);
    def_predict<Ukf3, Arc, 2>(ukf3);
    def_predict<Ukf3, DifferentialDrive<double>, 2>(ukf3);
    def_predict<Ukf3, GyroDrive<double>, 3>(ukf3);
    def_update_by_marker(ukf3);
    def_motions<PoseMotion>(ukf3);
    def_measurements<PoseMeasurement>(ukf3);
    auto ukf6 = bind_filter<6>(m, "Ukf6", "Ekf6's unscented counterpart, with its models.");
    def_predict<Ukf6, Calibrated<Arc, double>, 2>(ukf6);
    def_update_by_marker(ukf6);
    auto ukf5 = bind_filter<5>(m, "Ukf5", "Ekf5's unscented counterpart.");
    def_update_by_marker(ukf5);
    def_motions<VelocityMotion>(ukf5);
    def_measurements<PoseMeasurement>(ukf5);
    def_measurements<VelocityMeasurement>(ukf5);
    auto ukf4 = bind_filter<4, PlainSpace>(
        m, "Ukf4", "The unscented filter of four states, none an angle; of an echo's parameters.");
    def_measurements<EchoMeasurement>(ukf4);
}

}  // namespace pilotage::bindings
