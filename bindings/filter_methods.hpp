#pragma once
/// \file
/// What Python can do with any filter. A model is one line more where the filters are bound:
/// `def_predict<Filter, Model, Inputs>(c)` or `def_update<Model>(c)`.

#include <pybind11/eigen.h>
#include <pybind11/pybind11.h>

#include <string>

#include "marker_model.hpp"
#include "pilotage/filter/policy.hpp"
#include "pilotage/filter/update_report.hpp"

namespace pilotage::bindings {

/// UpdateReport of any size.
struct Report {
    Eigen::VectorXd innovation;
    Eigen::MatrixXd s;
    double nis, weight;
    UpdateFault fault;
};

template <int M>
Report any_size(const UpdateReport<double, M>& report) {
    return {report.innovation, report.s, report.nis, report.weight, report.fault};
}

/// \throws ValueError unless z is of m entries and r of m rows and columns
inline void expect_components(const Eigen::VectorXd& z, const Eigen::MatrixXd& r, int m) {
    if (z.size() != m || r.rows() != m || r.cols() != m) {
        const std::string n = std::to_string(m);
        throw pybind11::value_error("z must have shape (" + n + ",) and r (" + n + ", " + n +
                                    ") for this model");
    }
}

inline constexpr const char* kUpdate =
    "Measurement update. Nothing changes unless the report says accepted.";

template <typename Filter, typename Model>
Report update(Filter& filter, const Model& model, const Eigen::VectorXd& z,
              const Eigen::MatrixXd& r, const Policy& policy) {
    constexpr int M = Model::Values::RowsAtCompileTime;
    expect_components(z, r, M);
    return any_size(filter.update(model, Vector<double, M>(z), Matrix<double, M>(r), policy));
}

template <typename Filter>
Report update_by_marker(Filter& filter, const MarkerModel& model, const Eigen::VectorXd& z,
                        const Eigen::MatrixXd& r, const Policy& policy) {
    return model.visit([&](const auto& core) { return update(filter, core, z, r, policy); });
}

/// `update` by a model of the core.
template <typename Model, typename Filter>
void def_update(pybind11::class_<Filter>& c) {
    namespace py = pybind11;
    c.def("update", &update<Filter, Model>, py::arg("model"), py::arg("z"), py::arg("r"),
          py::arg_v("policy", Policy{}, "Policy()"), kUpdate);
}

/// `update` by what is seen of a marker.
template <typename Filter>
void def_update_by_marker(pybind11::class_<Filter>& c, const char* doc = kUpdate) {
    namespace py = pybind11;
    c.def("update", &update_by_marker<Filter>, py::arg("model"), py::arg("z"), py::arg("r"),
          py::arg_v("policy", Policy{}, "Policy()"), doc);
}

template <typename Filter, typename Model, int Inputs>
void def_predict(pybind11::class_<Filter>& c) {
    namespace py = pybind11;
    c.def("predict", &Filter::template predict<Model, Inputs>, py::arg("model"), py::arg("u"),
          py::arg("gamma"), py::arg("q"));
}

/// `state` and `covariance`.
template <typename Filter>
void def_estimate(pybind11::class_<Filter>& c) {
    // By value: a view would change under the caller's feet with the next step.
    c.def_property_readonly(
         "state", [](const Filter& f) { return typename Filter::State(f.state()); },
         "(n,) float, a copy")
        .def_property_readonly(
            "covariance",
            [](const Filter& f) { return typename Filter::Covariance(f.covariance()); },
            "(n, n) float, a copy");
}

}  // namespace pilotage::bindings
