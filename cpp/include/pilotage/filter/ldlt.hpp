#pragma once
/// \file
/// A = L D L' of a small symmetric matrix: solves with S, and tells whether a covariance is one.

#include "pilotage/state.hpp"

namespace pilotage {

template <typename Scalar, int M>
class Ldlt {
   public:
    /// Reads the lower triangle. A pivot below `tolerance` times its diagonal entry counts as zero, and its
    /// row is left out: exactly known (frozen) states have zero variance and no covariance.
    explicit Ldlt(const Matrix<Scalar, M>& a, Scalar tolerance = 0) noexcept
        : Ldlt(a, tolerance, a.diagonal()) {}

    /// The tolerance relative to something else than the diagonal, where `a` is a difference of larger terms.
    Ldlt(const Matrix<Scalar, M>& a, Scalar tolerance, const Vector<Scalar, M>& scale) noexcept {
        for (int j = 0; j < M; ++j) {
            Scalar pivot = a(j, j);
            for (int k = 0; k < j; ++k) pivot -= lower_(j, k) * lower_(j, k) * pivot_[k];
            const Scalar slack = tolerance * scale[j];
            positive_ = positive_ && pivot > slack;
            semidefinite_ = semidefinite_ && a(j, j) >= 0 && pivot >= -slack;
            pivot_[j] = pivot > slack ? pivot : 0;
            inverse_[j] = pivot > slack ? 1 / pivot : 0;
            for (int i = j + 1; i < M; ++i) {
                Scalar sum = a(i, j);
                for (int k = 0; k < j; ++k) sum -= lower_(i, k) * lower_(j, k) * pivot_[k];
                lower_(i, j) = sum * inverse_[j];
            }
        }
    }

    /// Every pivot is above the tolerance; false for NaN.
    [[nodiscard]] bool positive() const noexcept { return positive_; }

    /// No pivot is below minus the tolerance; false for NaN.
    [[nodiscard]] bool semidefinite() const noexcept { return semidefinite_; }

    /// x with A x = b.
    template <typename Derived>
    [[nodiscard]] Vector<Scalar, M> solve(const Eigen::MatrixBase<Derived>& b) const noexcept {
        Vector<Scalar, M> x = b;
        for (int i = 1; i < M; ++i)
            for (int k = 0; k < i; ++k) x[i] -= lower_(i, k) * x[k];
        for (int i = 0; i < M; ++i) x[i] *= inverse_[i];
        for (int i = M - 2; i >= 0; --i)
            for (int k = i + 1; k < M; ++k) x[i] -= lower_(k, i) * x[k];
        return x;
    }

   private:
    Matrix<Scalar, M> lower_;  // strictly below the diagonal, the rest is unused
    Vector<Scalar, M> pivot_, inverse_;
    bool positive_ = true, semidefinite_ = true;
};

}  // namespace pilotage
