#pragma once
/// \file
/// The extended Kalman filter, knowing no robot and no sensor: models come in as values at `predict` and
/// `update`. Equation numbers are those of Kiriy and Buehler 2002.
///
/// A motion model has `linearize(x, u)` returning {next, a, b}: f(x, u), its Jacobian by the state (dense,
/// or a structure that `congruence` knows) and its Jacobian by the input. A measurement model has
/// `kStates`, the number of leading states that it sees, `linearize(x)` returning {value, h, defined}, and
/// `minus(z, value)`.

#include <cmath>

#include "pilotage/congruence.hpp"
#include "pilotage/filter/ldlt.hpp"
#include "pilotage/filter/policy.hpp"
#include "pilotage/filter/update_report.hpp"
#include "pilotage/state.hpp"

namespace pilotage {

template <typename Scalar, int N>
class Ekf {
   public:
    using State = Vector<Scalar, N>;
    using Covariance = Matrix<Scalar, N>;

    Ekf() noexcept : Ekf(State::Zero(), Covariance::Zero()) {}
    Ekf(const State& x, const Covariance& p) noexcept : x_(x), p_(p) {}

    [[nodiscard]] const State& state() const noexcept { return x_; }
    [[nodiscard]] const Covariance& covariance() const noexcept { return p_; }

    /// Time update, eqs. 8 and 9, linearised at the state before it (eqs. 13 and 14 print a later
    /// point).
    /// \param gamma covariance of the input u; \param q variances added to the states
    template <typename Model, int Inputs>
    void predict(const Model& model, const Vector<Scalar, Inputs>& u,
                 const Matrix<Scalar, Inputs>& gamma, const State& q) noexcept {
        const auto step = model.linearize(x_, u);
        propagate(step.next, step.a, step.b, gamma, q);
    }

    /// The time update with the linearisation given, so that it may be taken about another point.
    template <typename Transition, int Rows, int Inputs>
    void propagate(const State& next, const Transition& a, const Matrix<Scalar, Rows, Inputs>& b,
                   const Matrix<Scalar, Inputs>& gamma, const State& q) noexcept {
        x_ = next;
        p_ = congruence(a, p_);
        add_input_noise(b, gamma, p_);
        p_.diagonal() += q;
        mirror_lower(p_);
    }

    /// Measurement update, eqs. 10, 11 and 28 (Joseph form), linearised at the state as it stands.
    /// It is a transaction: state and covariance change only if the report says accepted.
    template <typename Model, int M>
    UpdateReport<Scalar, M> update(const Model& model, const Vector<Scalar, M>& z,
                                   const Matrix<Scalar, M>& r, const Policy& policy) noexcept {
        const auto h = model.linearize(x_.template head<Model::kStates>());
        if (!h.defined) {
            UpdateReport<Scalar, M> report;
            report.fault = UpdateFault::undefined;
            return report;
        }
        return correct(model.minus(z, h.value), h.jacobian, r, policy);
    }

    /// The measurement update with innovation and H given, so that they may be taken at another point.
    template <int M, int Seen>
    UpdateReport<Scalar, M> correct(const Vector<Scalar, M>& innovation,
                                    const Matrix<Scalar, M, Seen>& h, const Matrix<Scalar, M>& r,
                                    const Policy& policy) noexcept {
        UpdateReport<Scalar, M> report;
        report.innovation = innovation;
        const Matrix<Scalar, N, M> ph =
            p_.template leftCols<Seen>().lazyProduct(h.transpose());  // P H'
        const Matrix<Scalar, M> hph = h.lazyProduct(ph.template topRows<Seen>());
        report.s = hph + r;
        const Ldlt<Scalar, M> s(report.s);
        report.nis = innovation.dot(s.solve(innovation));
        if (!(r.diagonal().array() > 0).all() || !s.positive() || !std::isfinite(report.nis))
            return refuse(report, UpdateFault::numeric);
        if (policy.gated(report.nis, M)) return refuse(report, UpdateFault::gated);
        report.weight = policy.weight(report.nis, M);
        const bool committed = report.weight < 1
                                   ? commit(innovation, h, Matrix<Scalar, M>(r / report.weight), ph,
                                            Ldlt<Scalar, M>(hph + r / report.weight))
                                   : commit(innovation, h, r, ph, s);
        return committed ? report : refuse(report, UpdateFault::numeric);
    }

   private:
    /// Joseph form in the order that costs least: with M1 = (I - K H) P the covariance
    /// (I - K H) P (I - K H)' + K R K' is M1 + (K R - M1 H') K'.
    template <int M, int Seen>
    [[nodiscard]] bool commit(const Vector<Scalar, M>& innovation, const Matrix<Scalar, M, Seen>& h,
                              const Matrix<Scalar, M>& r, const Matrix<Scalar, N, M>& ph,
                              const Ldlt<Scalar, M>& s) noexcept {
        Matrix<Scalar, N, M> k;
        for (int i = 0; i < N; ++i) k.row(i) = s.solve(ph.row(i).transpose());
        const Covariance m1 = p_ - k.lazyProduct(ph.transpose());
        const Matrix<Scalar, N, M> rest =
            k.lazyProduct(r) - m1.template leftCols<Seen>().lazyProduct(h.transpose());
        Covariance p;
        for (int j = 0; j < N; ++j)
            for (int i = j; i < N; ++i) p(i, j) = m1(i, j) + rest.row(i).dot(k.row(j));
        const State x = plus<Scalar, N>(x_, k.lazyProduct(innovation));
        if (!x.allFinite() || !Ldlt<Scalar, N>(p, kPivotTolerance, p_.diagonal()).semidefinite()) return false;
        mirror_lower(p);
        x_ = x;
        p_ = p;
        return true;
    }

    template <int M>
    [[nodiscard]] static UpdateReport<Scalar, M> refuse(UpdateReport<Scalar, M> report,
                                                        UpdateFault fault) noexcept {
        report.fault = fault;
        report.weight = 0;
        return report;
    }

    /// Rounding leaves a pivot of a singular covariance this far from zero, relative to the variance
    /// before the update.
    static constexpr Scalar kPivotTolerance = Eigen::NumTraits<Scalar>::epsilon() * 1000;

    State x_;
    Covariance p_;
};

}  // namespace pilotage
