#pragma once
/// \file
/// One line checks every Jacobian of a model against dual numbers:
/// `expect_jacobians(motion, x, u)` and `expect_jacobians(measurement, x)`.

#include <gtest/gtest.h>

#include "support/dual.hpp"
#include "support/dual_models.hpp"
#include "support/matchers.hpp"
#include "support/scalars.hpp"

namespace pilotage::test {

/// The derivative of `f` by its argument, a column a pass.
template <typename Function, typename Scalar, int Cols>
[[nodiscard]] auto derivative(const Function& f, const Vector<Scalar, Cols>& at) {
    using Arguments = Vector<Dual<Scalar>, Cols>;
    constexpr int kRows = decltype(f(Arguments{}))::RowsAtCompileTime;
    Matrix<Scalar, kRows, Cols> result;
    for (int column = 0; column < Cols; ++column) {
        Arguments argument = at.template cast<Dual<Scalar>>();
        argument[column].slope = 1;
        const auto value = f(argument);
        for (int row = 0; row < kRows; ++row) result(row, column) = value[row].slope;
    }
    return result;
}

template <typename Scalar, int Rows, int Cols>
void expect_rows_close(const char* name, const Matrix<Scalar, Rows, Cols>& actual,
                       const Matrix<Scalar, Rows, Cols>& oracle) {
    for (int row = 0; row < Rows; ++row) {
        const Scalar norm = oracle.row(row).norm();
        EXPECT_LE((actual.row(row) - oracle.row(row)).norm(), kJacobian<Scalar> * norm)
            << name << ", row " << row << " of\n"
            << actual.format(kDigits) << "\nby dual numbers\n"
            << oracle.format(kDigits);
    }
}

/// Of a motion model, by the state and by the input.
template <typename Model, typename Scalar, int N, int Inputs>
void expect_jacobians(const Model& model, const Vector<Scalar, N>& x,
                      const Vector<Scalar, Inputs>& u) {
    using D = Dual<Scalar>;
    const auto trace = ::testing::Message() << "at x = " << x.transpose().format(kDigits)
                                            << ", u = " << u.transpose().format(kDigits);
    SCOPED_TRACE(trace);
    const auto dual = with_scalar<D>(model);
    const auto step = model.linearize(x, u);
    const Vector<D, N> fixed_x = x.template cast<D>();
    const Vector<D, Inputs> fixed_u = u.template cast<D>();
    // A calibrated model leaves out the rows of states that no input moves.
    Matrix<Scalar, N, Inputs> b = Matrix<Scalar, N, Inputs>::Zero();
    b.template topRows<decltype(step.b)::RowsAtCompileTime>() = step.b;
    expect_rows_close<Scalar, N, N>(
        "A", dense(step.a),
        derivative([&](const Vector<D, N>& at) { return dual.linearize(at, fixed_u).next; }, x));
    expect_rows_close<Scalar, N, Inputs>(
        "B", b,
        derivative([&](const Vector<D, Inputs>& at) { return dual.linearize(fixed_x, at).next; },
                   u));
}

/// Of a measurement model, by the states that it sees.
template <typename Model, typename Scalar, int N>
void expect_jacobians(const Model& model, const Vector<Scalar, N>& x) {
    using D = Dual<Scalar>;
    const auto trace = ::testing::Message() << "at x = " << x.transpose().format(kDigits);
    SCOPED_TRACE(trace);
    const auto dual = with_scalar<D>(model);
    const auto h = model.linearize(x);
    EXPECT_TRUE(h.defined);
    expect_rows_close(
        "H", h.jacobian,
        derivative([&](const Vector<D, N>& at) { return dual.linearize(at).value; }, x));
}

}  // namespace pilotage::test
