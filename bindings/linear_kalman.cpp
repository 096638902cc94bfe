#include "pilotage/filter/linear_kalman.hpp"

#include <variant>

#include "bindings.hpp"
#include "filter_methods.hpp"

namespace py = pybind11;

namespace pilotage::bindings {

namespace {

/// LinearKalman of as many states as it was given.
class AnyLinearKalman {
   public:
    AnyLinearKalman(const Eigen::VectorXd& x, const Eigen::MatrixXd& p) : filter_(sized(x, p)) {}

    [[nodiscard]] Eigen::VectorXd state() const {
        return std::visit([](const auto& f) -> Eigen::VectorXd { return f.state(); }, filter_);
    }
    [[nodiscard]] Eigen::MatrixXd covariance() const {
        return std::visit([](const auto& f) -> Eigen::MatrixXd { return f.covariance(); }, filter_);
    }

    void predict(const Eigen::MatrixXd& a, const Eigen::VectorXd& bu, const Eigen::MatrixXd& q) {
        std::visit(
            [&](auto& f) {
                constexpr int N = std::decay_t<decltype(f)>::State::RowsAtCompileTime;
                if (!square(a, N) || bu.size() != N || !square(q, N))
                    throw py::value_error("a (n, n), bu (n,) and q (n, n) do not fit n states");
                f.predict(Matrix<double, N>(a), Vector<double, N>(bu), Matrix<double, N>(q));
            },
            filter_);
    }

    Report update(const Eigen::VectorXd& z, const Eigen::MatrixXd& h, const Eigen::MatrixXd& r,
                  const Policy& policy) {
        return std::visit(
            [&](auto& f) {
                constexpr int N = std::decay_t<decltype(f)>::State::RowsAtCompileTime;
                if (h.rows() != z.size() || h.cols() != N || !square(r, z.size()))
                    throw py::value_error("z (m,), h (m, n) and r (m, m) do not fit n states");
                const auto update = [&](auto rows) {
                    constexpr int M = decltype(rows)::value;
                    return any_size(f.update(Vector<double, M>(z), Matrix<double, M, N>(h),
                                             Matrix<double, M>(r), policy));
                };
                switch (z.size()) {
                    case 1:
                        return update(std::integral_constant<int, 1>{});
                    case 2:
                        return update(std::integral_constant<int, 2>{});
                    case 3:
                        return update(std::integral_constant<int, 3>{});
                    default:
                        throw py::value_error("an update has 1, 2 or 3 components");
                }
            },
            filter_);
    }

   private:
    template <int N>
    using Filter = LinearKalman<double, N>;
    using Sized = std::variant<Filter<1>, Filter<2>, Filter<3>, Filter<4>>;

    static bool square(const Eigen::MatrixXd& m, Eigen::Index n) {
        return m.rows() == n && m.cols() == n;
    }

    static Sized sized(const Eigen::VectorXd& x, const Eigen::MatrixXd& p) {
        if (!square(p, x.size()))
            throw py::value_error("x (n,) and p (n, n) do not fit each other");
        switch (x.size()) {
            case 1:
                return Filter<1>(x, p);
            case 2:
                return Filter<2>(x, p);
            case 3:
                return Filter<3>(x, p);
            case 4:
                return Filter<4>(x, p);
            default:
                throw py::value_error("LinearKalman has 1 to 4 states");
        }
    }

    Sized filter_;
};

}  // namespace

void bind_linear_kalman(py::module_& m) {
    py::class_<AnyLinearKalman>(m, "LinearKalman",
                                R"(The Kalman filter of a linear system of 1 to 4 states.

Eqs. 3, 4 and 7 to 11 of Tamas et al. 2008, x = A x + B u + w and z = H x + v, with Q the covariance
of w and R that of v. No state is an angle.
)")
        .def(py::init<const Eigen::VectorXd&, const Eigen::MatrixXd&>(), py::arg("x"), py::arg("p"))
        .def_property_readonly("state", &AnyLinearKalman::state, "(n,) float, a copy")
        .def_property_readonly("covariance", &AnyLinearKalman::covariance, "(n, n) float, a copy")
        .def("predict", &AnyLinearKalman::predict, py::arg("a"), py::arg("bu"), py::arg("q"),
             R"(Time update, eqs. 7 and 8.

Parameters
----------
a : (n, n) float
bu : (n,) float, what the input adds: b @ u
q : (n, n) float
)")
        .def("update", &AnyLinearKalman::update, py::arg("z"), py::arg("h"), py::arg("r"),
             py::arg_v("policy", Policy{}, "Policy()"),
             R"(Measurement update, eqs. 9 to 11 as the Joseph form.

Nothing changes unless the report says accepted.

Parameters
----------
z : (m,) float, m up to 3
h : (m, n) float
r : (m, m) float
)");
}

}  // namespace pilotage::bindings
