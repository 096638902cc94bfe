#pragma once
/// \file
/// The unscented Kalman filter: the Ekf with its models' values taken at sigma points in place of
/// their Jacobians at one.

#include "pilotage/filter/ekf.hpp"
#include "pilotage/filter/unscented_models.hpp"

namespace pilotage {

/// Time update of a state and covariance that an Ekf holds, by its model's values.
template <typename Scalar, int N, typename Space, typename Model, int Inputs>
void unscented_predict(Ekf<Scalar, N, Space>& filter, const Model& model,
                       const Vector<Scalar, Inputs>& u, const Matrix<Scalar, Inputs>& gamma,
                       const Vector<Scalar, N>& q, const Unscented& set = {}) noexcept {
    auto next = unscented_motion<Space>(model, filter.state(), filter.covariance(), u, gamma, set);
    next.covariance.diagonal() += q;
    filter = {next.mean, next.covariance};
}

/// The model at what an Ekf holds, by the states that it sees.
template <typename Scalar, int N, typename Space, typename Model>
[[nodiscard]] auto unscented_measurement(const Model& model, const Ekf<Scalar, N, Space>& filter,
                                         const Unscented& set = {}) noexcept {
    constexpr int seen = Model::kStates;
    return unscented_measurement(
        model, Vector<Scalar, seen>(filter.state().template head<seen>()),
        Matrix<Scalar, seen>(filter.covariance().template topLeftCorner<seen, seen>()), set);
}

/// Measurement update likewise, a transaction as the Ekf's. The report's S is P_zz + R.
template <typename Scalar, int N, typename Space, typename Model, int M>
UpdateReport<Scalar, M> unscented_update(Ekf<Scalar, N, Space>& filter, const Model& model,
                                         const Vector<Scalar, M>& z, const Matrix<Scalar, M>& r,
                                         const Policy& policy, const Unscented& set = {}) noexcept {
    using Report = UpdateReport<Scalar, M>;
    // Omega must not make good for an R that is none.
    if (!filter.covariance().allFinite() || !Ldlt<Scalar, M>(r).positive())
        return Report::refused(UpdateFault::numeric);
    const auto h = unscented_measurement(model, filter, set);
    if (!h.defined) return Report::refused(UpdateFault::undefined);
    return filter.correct(model.minus(z, h.value), h.jacobian, Matrix<Scalar, M>(r + h.noise),
                          policy);
}

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
        unscented_predict(filter_, model, u, gamma, q, set_);
    }

    /// Measurement update.
    template <typename Model, int M>
    UpdateReport<Scalar, M> update(const Model& model, const Vector<Scalar, M>& z,
                                   const Matrix<Scalar, M>& r, const Policy& policy) noexcept {
        return unscented_update(filter_, model, z, r, policy, set_);
    }

   private:
    Ekf<Scalar, N, Space> filter_;
    Unscented set_;
};

}  // namespace pilotage
