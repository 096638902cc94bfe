#pragma once
/// \file
/// What Python can do with any motion model.

#include <pybind11/eigen.h>

#include <tuple>

#include "arrays.hpp"
#include "pilotage/congruence.hpp"

namespace pilotage::bindings {

template <typename Linearize>
struct MotionSignature;
template <typename Model, typename Step, typename X, typename U>
struct MotionSignature<Step (Model::*)(const X&, const U&) const noexcept> {
    using State = X;
    using Input = U;
};

/// The vectors that a motion model takes.
template <typename Model>
using StateOf = typename MotionSignature<decltype(&Model::linearize)>::State;
template <typename Model>
using InputOf = typename MotionSignature<decltype(&Model::linearize)>::Input;

template <typename Model>
class MotionRows {
   public:
    using State = StateOf<Model>;
    using Input = InputOf<Model>;
    static constexpr pybind11::ssize_t kStates = State::RowsAtCompileTime;
    static constexpr pybind11::ssize_t kInputs = Input::RowsAtCompileTime;

    /// The states (n + 1, N) from x on, one step after the other.
    static auto path(const Model& model, const State& x, const Array<double>& u) {
        expect_shape(u, u.size() / kInputs, kInputs, "u");
        pybind11::array_t<double> states({u.shape(0) + 1, kStates});
        double* at = states.mutable_data();
        Eigen::Map<State>{at} = x;
        for (pybind11::ssize_t i = 0; i < u.shape(0); ++i, at += kStates)
            step(model, at, u.data() + kInputs * i, at + kStates);
        return states;
    }

    /// The states (n, N) one step from each of x.
    static auto step_each(const Model& model, const Array<double>& x, const Array<double>& u) {
        expect_shape(u, u.size() / kInputs, kInputs, "u");
        expect_shape(x, u.shape(0), kStates, "x");
        pybind11::array_t<double> states({u.shape(0), kStates});
        for (pybind11::ssize_t i = 0; i < u.shape(0); ++i)
            step(model, x.data() + kStates * i, u.data() + kInputs * i,
                 states.mutable_data() + kStates * i);
        return states;
    }

   private:
    static void step(const Model& model, const double* x, const double* u, double* next) {
        using X = Eigen::Map<const State>;
        using U = Eigen::Map<const Input>;
        Eigen::Map<State>{next} = model.linearize(State(X(x)), Input(U(u))).next;
    }
};

/// `linearize`, `path` and `step_each`.
template <typename Model>
pybind11::class_<Model>& def_motion(pybind11::class_<Model>& c) {
    namespace py = pybind11;
    using State = StateOf<Model>;
    using Rows = MotionRows<Model>;
    return c
        .def(
            "linearize",
            [](const Model& model, const State& x, const InputOf<Model>& u) {
                const auto step = model.linearize(x, u);
                using A = Matrix<double, State::RowsAtCompileTime>;
                return std::make_tuple(State(step.next), A(dense(step.a)), step.b);
            },
            py::arg("x"), py::arg("u"), R"(f(x, u) and its Jacobians.

Returns
-------
next : (n,) float, the state after the motion
a : (n, n) float, by the state
b : (n, m) float, by the input; without the rows of calibration states
)")
        .def("path", &Rows::path, py::arg("x"), py::arg("u"),
             "The states (k + 1, n) from x (n,) on, one step after the other, u (k, m).")
        .def("step_each", &Rows::step_each, py::arg("x"), py::arg("u"),
             "The states (k, n) one step from each of x (k, n), u (k, m).");
}

}  // namespace pilotage::bindings
