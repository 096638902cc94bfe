#pragma once
/// \file
/// A P A', the product that moves a covariance, once as the equation stands and once for each transition
/// whose structure is worth using. Every planar motion has the same A: the identity but for the heading
/// column, which holds the displacement turned by 90 degrees (eq. 21 of Kiriy and Buehler 2002).

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
template <typename Scalar>
struct CalibratedTransition {
    HeadingShear<Scalar> shear;
    Matrix<Scalar, 3> by_calibration;  ///< C, the pose by (gyro bias, distance scale, rotation scale)

    [[nodiscard]] Matrix<Scalar, 6> dense() const noexcept {
        Matrix<Scalar, 6> a = Matrix<Scalar, 6>::Identity();
        a.template topLeftCorner<3, 3>() = shear.dense();
        a.template topRightCorner<3, 3>() = by_calibration;
        return a;
    }
};

template <typename Scalar, int N>
[[nodiscard]] Matrix<Scalar, N> congruence(const Matrix<Scalar, N>& a,
                                           const Matrix<Scalar, N>& p) noexcept {
    return a * p * a.transpose();
}

/// The rows and columns of `p` that belong to the pose, sheared in place; the lower triangle is read and
/// written, the upper one is left behind.
template <typename Scalar, int N>
void shear_lower(const HeadingShear<Scalar>& a, Matrix<Scalar, N>& p) noexcept {
    const Scalar hh = p(kHeading, kHeading);
    const Scalar hx = p(kHeading, kX) - a.dy * hh;
    const Scalar hy = p(kHeading, kY) + a.dx * hh;
    p(kX, kX) -= a.dy * (p(kHeading, kX) + hx);
    p(kY, kX) += a.dx * p(kHeading, kX) - a.dy * hy;
    p(kY, kY) += a.dx * (p(kHeading, kY) + hy);
    p(kHeading, kX) = hx;
    p(kHeading, kY) = hy;
}

template <typename Scalar>
[[nodiscard]] Matrix<Scalar, 3> congruence(const HeadingShear<Scalar>& a,
                                           Matrix<Scalar, 3> p) noexcept {
    shear_lower(a, p);
    return p;
}

template <typename Scalar>
[[nodiscard]] Matrix<Scalar, 6> congruence(const CalibratedTransition<Scalar>& a,
                                           Matrix<Scalar, 6> p) noexcept {
    const Matrix<Scalar, 3>& c = a.by_calibration;
    const Matrix<Scalar, 3> calibration = p.template bottomRightCorner<3, 3>();
    Matrix<Scalar, 3> cross = p.template bottomLeftCorner<3, 3>();  // calibration by pose
    // Shear the pose: P_pp <- A P_pp A', P_cp <- P_cp A'.
    shear_lower(a.shear, p);
    for (int i = 0; i < 3; ++i) {
        cross(i, kX) -= a.shear.dy * cross(i, kHeading);
        cross(i, kY) += a.shear.dx * cross(i, kHeading);
    }
    // Then add what calibration brings: P_cp += P_cc C', P_pp += C P_cp + (C P_cp)' with half of P_cc C'.
    const Matrix<Scalar, 3> brought = calibration.lazyProduct(c.transpose());
    const Matrix<Scalar, 3> mean_cross = cross + Scalar(0.5) * brought;
    for (int j = 0; j < 3; ++j)
        for (int i = j; i < 3; ++i)
            p(i, j) += c.row(i).dot(mean_cross.col(j)) + c.row(j).dot(mean_cross.col(i));
    p.template bottomLeftCorner<3, 3>() = cross + brought;
    return p;
}

/// P += B G B', on the lower triangle.
template <typename Scalar, int N, int Rows, int Inputs>
void add_input_noise(const Matrix<Scalar, Rows, Inputs>& b, const Matrix<Scalar, Inputs>& gamma,
                     Matrix<Scalar, N>& p) noexcept {
    const Matrix<Scalar, Rows, Inputs> bg = b.lazyProduct(gamma);
    for (int j = 0; j < Rows; ++j)
        for (int i = j; i < Rows; ++i)
            for (int k = 0; k < Inputs; ++k) p(i, j) += bg(i, k) * b(j, k);
}

/// Writes the lower triangle into the upper one.
template <typename Scalar, int N>
void mirror_lower(Matrix<Scalar, N>& p) noexcept {
    for (int j = 1; j < N; ++j)
        for (int i = 0; i < j; ++i) p(i, j) = p(j, i);
}

}  // namespace pilotage
