#pragma once
/// \file
/// Gives a filter the models of models.hpp.

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <variant>

#include "filter_methods.hpp"
#include "models.hpp"
#include "motion_methods.hpp"

namespace pilotage::bindings {

/// `predict` by any alternative of Motion, a std::variant.
template <typename Motion, typename Filter>
void def_motions(pybind11::class_<Filter>& c) {
    namespace py = pybind11;
    c.def(
        "predict",
        [](Filter& filter, const Motion& motion, const Eigen::VectorXd& u,
           const Eigen::MatrixXd& gamma, const typename Filter::State& q) {
            const auto predict = [&](const auto& model) {
                using Input = InputOf<std::decay_t<decltype(model)>>;
                constexpr int m = Input::RowsAtCompileTime;
                if (u.size() != m || gamma.rows() != m || gamma.cols() != m)
                    throw py::value_error("u must have shape (m,) and gamma (m, m), m = " +
                                          std::to_string(m));
                filter.predict(model, Input(u), Matrix<double, m>(gamma), q);
            };
            std::visit(predict, motion);
        },
        py::arg("model"), py::arg("u"), py::arg("gamma"), py::arg("q"));
}

/// `update` by any alternative of Measurement, a std::variant.
template <typename Measurement, typename Filter>
void def_measurements(pybind11::class_<Filter>& c) {
    namespace py = pybind11;
    c.def(
        "update",
        [](Filter& filter, const Measurement& measurement, const Eigen::VectorXd& z,
           const Eigen::MatrixXd& r, const Policy& policy) {
            return std::visit(
                [&](const auto& model) { return update(filter, model, z, r, policy); },
                measurement);
        },
        py::arg("model"), py::arg("z"), py::arg("r"), py::arg_v("policy", Policy{}, "Policy()"),
        kUpdate);
}

}  // namespace pilotage::bindings
