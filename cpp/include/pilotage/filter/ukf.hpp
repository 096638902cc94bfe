#pragma once
/// \file
/// The unscented Kalman filter: the Ekf with its models' values taken at sigma points in place of
/// their Jacobians at one.

#include "pilotage/filter/ekf.hpp"
#include "pilotage/filter/unscented_models.hpp"

namespace pilotage {

/// Takes the models that the Ekf takes; runnable example: tests/cpp/filter/test_ukf.cpp.
template <typename Scalar, int N, typename Space = HeadingSpace>
class Ukf {
   public:
    using State = Vector<Scalar, N>;
    using Covariance = Matrix<Scalar, N>;

    Ukf() noexcept = default;
    Ukf(const State& x, const Covariance& p, const Unscented& set = {}) noexcept
        : filter_(x, p), set_(set) {}

    [[nodiscard]] const State& state() const noexcept { return filter_.state(); }
    [[nodiscard]] const Covariance& covariance() const noexcept { return filter_.covariance(); }

    /// Time update.
    /// \param gamma covariance of the input u; \param q variances added to the states
    template <typename Model, int Inputs>
    void predict(const Model& model, const Vector<Scalar, Inputs>& u,
                 const Matrix<Scalar, Inputs>& gamma, const State& q) noexcept {
        auto next = unscented_motion<Space>(model, state(), covariance(), u, gamma, set_);
        next.covariance.diagonal() += q;
        filter_ = {next.mean, next.covariance};
    }

    /// Measurement update, a transaction as the Ekf's. The report's S is P_zz + R.
    template <typename Model, int M>
    UpdateReport<Scalar, M> update(const Model& model, const Vector<Scalar, M>& z,
                                   const Matrix<Scalar, M>& r, const Policy& policy) noexcept {
        using Report = UpdateReport<Scalar, M>;
        // Omega must not make good for an R that is none.
        if (!covariance().allFinite() || !Ldlt<Scalar, M>(r).positive())
            return Report::refused(UpdateFault::numeric);
        constexpr int seen = Model::kStates;
        const auto h = unscented_measurement(
            model, Vector<Scalar, seen>(state().template head<seen>()),
            Matrix<Scalar, seen>(covariance().template topLeftCorner<seen, seen>()), set_);
        if (!h.defined) return Report::refused(UpdateFault::undefined);
        return filter_.correct(model.minus(z, h.value), h.jacobian, Matrix<Scalar, M>(r + h.noise),
                               policy);
    }

   private:
    Ekf<Scalar, N, Space> filter_;
    Unscented set_;
};

}  // namespace pilotage
