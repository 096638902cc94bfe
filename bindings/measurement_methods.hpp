#pragma once
/// \file
/// What Python can do with any measurement model.

#include <pybind11/eigen.h>

#include <algorithm>
#include <tuple>

#include "arrays.hpp"
#include "pilotage/state.hpp"

namespace pilotage::bindings {

template <typename Model>
auto linearize_at(const Model& model, const Vector<double, Model::kStates>& x) {
    const auto h = model.linearize(x);
    return std::make_tuple(Eigen::VectorXd(h.value), Eigen::MatrixXd(h.jacobian), h.defined);
}

template <typename Model>
pybind11::array_t<double> predict_each(const Model& model, const Array<double>& states) {
    constexpr pybind11::ssize_t m = Model::Values::RowsAtCompileTime, n = Model::kStates;
    expect_shape(states, states.size() / n, n, "states");
    pybind11::array_t<double> values({states.shape(0), m});
    const double* x = states.data();
    double* value = values.mutable_data();
    for (pybind11::ssize_t i = 0; i < states.shape(0); ++i, x += n, value += m) {
        const Vector<double, Model::kStates> at = Eigen::Map<const decltype(at)>(x);
        const auto h = model.linearize(at);
        std::copy_n(h.value.data(), m, value);
    }
    return values;
}

template <typename Model>
Eigen::VectorXd subtract(const Model& model, const Eigen::VectorXd& z,
                         const Eigen::VectorXd& predicted) {
    using Values = typename Model::Values;
    if (z.size() != Values::RowsAtCompileTime || predicted.size() != z.size())
        throw pybind11::value_error("z and predicted need one entry a component");
    return model.minus(Values(z), Values(predicted));
}

/// `linearize`, `predict` and `minus` of a model of the core.
template <typename Model>
pybind11::class_<Model>& def_measurement(pybind11::class_<Model>& c) {
    namespace py = pybind11;
    return c
        .def("linearize", &linearize_at<Model>, py::arg("x"), R"(h(x) and its Jacobian.

Returns
-------
value : (m,) float
jacobian : (m, n) float, by the states that it sees
defined : bool, whether there is anything to measure, and a derivative to trust
)")
        .def("predict", &predict_each<Model>, py::arg("states"),
             "h(x) of many states at once: (k, m) for (k, n).")
        .def("minus", &subtract<Model>, py::arg("z"), py::arg("predicted"),
             "Measured less predicted, (m,) each; angles wrap.");
}

}  // namespace pilotage::bindings
