#pragma once
/// \file
/// The Kalman filter of a linear system, with the matrices given at every step. Equation numbers
/// are those of Tamas et al. 2008 (whose prose swaps Q and R).

#include "pilotage/filter/ekf.hpp"

namespace pilotage {

/// A linearisation that holds everywhere: the Ekf's own steps in a space without angles.
/// Runnable example: tests/cpp/filter/test_linear_kalman.cpp.
template <typename Scalar, int N>
class LinearKalman {
   public:
    using State = Vector<Scalar, N>;
    using Covariance = Matrix<Scalar, N>;

    LinearKalman() noexcept = default;
    LinearKalman(const State& x, const Covariance& p) noexcept : filter_(x, p) {}

    [[nodiscard]] const State& state() const noexcept { return filter_.state(); }
    [[nodiscard]] const Covariance& covariance() const noexcept { return filter_.covariance(); }

    /// Time update, x = A x + B u and P = A P A' + Q (eqs. 7 and 8).
    /// \param bu what the input adds to the state, B u
    void predict(const Covariance& a, const State& bu, const Covariance& q) noexcept {
        // Process noise is an input to every state: B = I with covariance Q.
        filter_.propagate(State(a * state() + bu), a, Covariance(Covariance::Identity()), q,
                          State(State::Zero()));
    }

    /// Measurement update of z = H x + v (eqs. 9 to 11, as the Joseph form): a transaction, as the
    /// Ekf's.
    template <int M>
    UpdateReport<Scalar, M> update(const Vector<Scalar, M>& z, const Matrix<Scalar, M, N>& h,
                                   const Matrix<Scalar, M>& r, const Policy& policy) noexcept {
        return filter_.correct(Vector<Scalar, M>(z - h * state()), h, r, policy);
    }

   private:
    Ekf<Scalar, N, PlainSpace> filter_;
};

}  // namespace pilotage
