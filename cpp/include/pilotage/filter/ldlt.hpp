#pragma once
/// \file
/// A = L D L' of a small symmetric matrix: solves with S, tells whether a covariance is one and
/// gives its square root.

#include <cmath>

#include "pilotage/state.hpp"

namespace pilotage {

template <typename Scalar, int M>
class Ldlt {
   public:
    /// Reads the lower triangle. A pivot below `tolerance` times its diagonal entry counts as zero,
    /// and its row is left out: exactly known (frozen) states have zero variance and no covariance.
    explicit Ldlt(const Matrix<Scalar, M>& a, Scalar tolerance = 0) noexcept
        : Ldlt(a, tolerance, entries<Vector<Scalar, M>>([&](int i, int) { return a(i, i); })) {}

    /// The tolerance relative to something else than the diagonal, where `a` is a difference of
    /// larger terms.
    Ldlt(const Matrix<Scalar, M>& a, Scalar tolerance, const Vector<Scalar, M>& scale) noexcept {
        Matrix<Scalar, M> rest;  // of `a`, after the columns so far
        fill_lower(rest, [&](int i, int j) { return a(i, j); });
        each<M>([&](int k) {
            const Scalar pivot = rest(k, k);
            const Scalar slack = tolerance == 0 ? Scalar(0) : tolerance * scale[k];
            const bool positive = pivot > slack;
            inverse_[k] = positive ? 1 / pivot : Scalar(0);
            if (!positive) {
                positive_ = false;
                // A pivot may be a rounding below zero, a variance may not.
                semidefinite_ =
                    semidefinite_ && pivot >= -slack && a(k, k) >= 0 && std::isfinite(slack);
                // What has no variance has no covariance either.
                each<M>([&](int j) {
                    if (j > k && !(rest(j, k) * rest(j, k) <= slack * scale[j]))
                        semidefinite_ = false;
                });
            }
            each<M>([&](int j) {
                if (j <= k) return;
                lower_(j, k) = known_zero(rest(j, k)) ? Scalar(0) : rest(j, k) * inverse_[k];
                each<M>([&](int i) {
                    if (i >= j && !known_zero(rest(j, k))) rest(i, j) -= lower_(j, k) * rest(i, k);
                });
            });
        });
    }

    /// Every pivot is above the tolerance; false for NaN.
    [[nodiscard]] bool positive() const noexcept { return positive_; }

    /// No diagonal entry is negative, no pivot below minus the tolerance; false for NaN.
    [[nodiscard]] bool semidefinite() const noexcept { return semidefinite_; }

    /// Of A, where that is positive definite.
    [[nodiscard]] Scalar determinant() const noexcept {
        Scalar product = 1;
        each<M>([&](int i) { product *= inverse_[i]; });
        return 1 / product;
    }

    /// x with A x = b.
    [[nodiscard]] Vector<Scalar, M> solve(const Vector<Scalar, M>& b) const noexcept {
        Vector<Scalar, M> x;
        each<M>([&](int i) {
            x[i] = b[i];
            each<M>([&](int k) {
                if (k < i) x[i] -= lower_(i, k) * x[k];
            });
        });
        each<M>([&](int i) { x[i] *= inverse_[i]; });
        each<M>([&](int upwards) {
            const int i = M - 1 - upwards;
            each<M>([&](int k) {
                if (k > i) x[i] -= lower_(k, i) * x[k];
            });
        });
        return x;
    }

    /// b' A^-1 b
    [[nodiscard]] Scalar squared_norm(const Vector<Scalar, M>& b) const noexcept {
        Vector<Scalar, M> x;
        each<M>([&](int i) {
            x[i] = b[i];
            each<M>([&](int k) {
                if (k < i) x[i] -= lower_(i, k) * x[k];
            });
        });
        Scalar total = 0;
        each<M>([&](int i) { total += x[i] * x[i] * inverse_[i]; });
        return total;
    }

    /// A^-1
    [[nodiscard]] Matrix<Scalar, M> inverse() const noexcept {
        Matrix<Scalar, M> result;
        each<M>([&](int j) {
            const auto unit = entries<Vector<Scalar, M>>(
                [&](int i, int) { return i == j ? Scalar(1) : Scalar(0); });
            result.col(j) = solve(unit);
        });
        return result;
    }

    /// The lower triangular R with R R' = A. A pivot that counts as zero leaves its column zero.
    [[nodiscard]] Matrix<Scalar, M> root() const noexcept {
        using std::sqrt;
        Matrix<Scalar, M> r = Matrix<Scalar, M>::Zero();
        for (int j = 0; j < M; ++j) {
            if (!(inverse_[j] > 0)) continue;
            r(j, j) = sqrt(1 / inverse_[j]);
            for (int i = j + 1; i < M; ++i) r(i, j) = lower_(i, j) * r(j, j);
        }
        return r;
    }

   private:
    Matrix<Scalar, M> lower_;  // strictly below the diagonal, the rest is unused
    Vector<Scalar, M> inverse_;
    bool positive_ = true, semidefinite_ = true;
};

}  // namespace pilotage
