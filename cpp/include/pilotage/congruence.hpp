#pragma once
/// \file
/// A P A', the product that moves a covariance, once as the equation stands and once for each
/// transition whose structure is worth using. Every planar motion has the same A: the identity but
/// for the heading column, which holds the displacement turned by 90 degrees (eq. 21 of Kiriy and
/// Buehler 2002).

#include "pilotage/state.hpp"

namespace pilotage {

/// A of a planar motion that displaces the pose by (dx, dy) in frame map:
/// [1 0 -dy; 0 1 dx; 0 0 1].
template <typename Scalar>
struct HeadingShear {
    Scalar dx = 0, dy = 0;

    [[nodiscard]] Matrix<Scalar, 3> dense() const noexcept {
        Matrix<Scalar, 3> a = Matrix<Scalar, 3>::Identity();
        a(kX, kHeading) = -dy;
        a(kY, kHeading) = dx;
        return a;
    }
};

/// A of a planar motion whose input is corrected by three calibration states: [shear C; 0 I].
/// Further states stay as they are.
template <typename Scalar>
struct CalibratedTransition {
    HeadingShear<Scalar> shear;
    Matrix<Scalar, 3>
        by_calibration;  ///< C, the pose by (gyro bias, distance scale, rotation scale)

    [[nodiscard]] Matrix<Scalar, 6> dense() const noexcept {
        Matrix<Scalar, 6> a = Matrix<Scalar, 6>::Identity();
        a.template topLeftCorner<3, 3>() = shear.dense();
        a.template topRightCorner<3, 3>() = by_calibration;
        return a;
    }
};

/// A as a matrix, whatever its structure.
template <typename Structure>
[[nodiscard]] auto dense(const Structure& a) noexcept {
    return a.dense();
}

template <typename Scalar, int N>
[[nodiscard]] const Matrix<Scalar, N>& dense(const Matrix<Scalar, N>& a) noexcept {
    return a;
}

/// As the equation stands, for any A.
template <typename Scalar, int N>
[[nodiscard]] Matrix<Scalar, N> congruence(const Matrix<Scalar, N>& a,
                                           const Matrix<Scalar, N>& p) noexcept {
    return a * p * a.transpose();
}

/// The rows and columns of `p` that belong to the pose, sheared in place. Here and below only the
/// lower triangle is read and written.
template <typename Scalar, int N>
void shear_pose(const HeadingShear<Scalar>& a, Matrix<Scalar, N>& p) noexcept {
    const Scalar hh = p(kHeading, kHeading);
    const Scalar hx = p(kHeading, kX) - a.dy * hh;
    const Scalar hy = p(kHeading, kY) + a.dx * hh;
    p(kX, kX) -= a.dy * (p(kHeading, kX) + hx);
    p(kY, kX) += a.dx * p(kHeading, kX) - a.dy * hy;
    p(kY, kY) += a.dx * (p(kHeading, kY) + hy);
    p(kHeading, kX) = hx;
    p(kHeading, kY) = hy;
    each<N - kPoseStates>([&](int i) {
        p(kPoseStates + i, kX) -= a.dy * p(kPoseStates + i, kHeading);
        p(kPoseStates + i, kY) += a.dx * p(kPoseStates + i, kHeading);
    });
}

template <typename Scalar>
[[nodiscard]] Matrix<Scalar, 3> congruence(const HeadingShear<Scalar>& a,
                                           const Matrix<Scalar, 3>& p) noexcept {
    Matrix<Scalar, 3> result;
    fill_lower(result, [&](int i, int j) { return p(i, j); });
    shear_pose(a, result);
    return result;
}

template <typename Scalar, int N>
[[nodiscard]] Matrix<Scalar, N> congruence(const CalibratedTransition<Scalar>& a,
                                           const Matrix<Scalar, N>& p) noexcept {
    const Matrix<Scalar, 3>& c = a.by_calibration;
    Matrix<Scalar, N> result;
    fill_lower(result, [&](int i, int j) { return p(i, j); });
    shear_pose(a.shear, result);
    // What calibration brings: P_cp += P_cc C', and P_pp += C P_cp + (C P_cp)' with half of that
    // added.
    const auto p_cc = [&](int i, int j) { return i >= j ? p(3 + i, 3 + j) : p(3 + j, 3 + i); };
    const auto half = entries<Matrix<Scalar, 3>>(
        [&](int i, int j) { return Scalar(0.5) * row_by_row(p_cc, i, c, j); });
    const auto cross =
        entries<Matrix<Scalar, 3>>([&](int i, int j) { return result(3 + i, j) + half(i, j); });
    add_lower(result.template topLeftCorner<3, 3>(), [&](int i, int j) {
        return row_by_column(c, i, cross, j) + row_by_column(c, j, cross, i);
    });
    each<3>([&](int j) { each<3>([&](int i) { result(3 + i, j) = cross(i, j) + half(i, j); }); });
    each<N - kCalibratedStates>([&](int i) {
        const int row = kCalibratedStates + i;
        const auto by = [&](int, int k) { return p(row, kPoseStates + k); };
        each<3>([&](int j) { result(row, j) += row_by_row(by, 0, c, j); });
    });
    return result;
}

/// P += B G B'
template <typename Scalar, int N, int Rows, int Inputs>
void add_input_noise(const Matrix<Scalar, Rows, Inputs>& b, const Matrix<Scalar, Inputs>& gamma,
                     Matrix<Scalar, N>& p) noexcept {
    const auto bg = entries<Matrix<Scalar, Rows, Inputs>>(
        [&](int i, int j) { return row_by_column(b, i, gamma, j); });
    add_lower(p.template topLeftCorner<Rows, Rows>(),
              [&](int i, int j) { return row_by_row(bg, j, b, i); });
}

/// Writes the lower triangle into the upper one.
template <typename Scalar, int N>
void mirror_lower(Matrix<Scalar, N>& p) noexcept {
    fill_symmetric(p, [&](int i, int j) { return p(i, j); });
}

}  // namespace pilotage
