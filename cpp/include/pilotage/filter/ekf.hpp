#pragma once
/// \file
/// The extended Kalman filter, knowing no robot and no sensor: models come in as values at
/// `predict` and `update`. Equation numbers are those of Kiriy and Buehler 2002.
///
/// A motion model has `linearize(x, u)` returning {next, a, b}: f(x, u), its Jacobian by the state
/// (dense, or a structure that `congruence` knows) and its Jacobian by the input. A measurement
/// model has `kStates`, the number of leading states that it sees, `linearize(x)` returning {value,
/// h, defined}, and `minus(z, value)`.

#include <limits>

#include "pilotage/congruence.hpp"
#include "pilotage/filter/ldlt.hpp"
#include "pilotage/filter/policy.hpp"
#include "pilotage/filter/update_report.hpp"
#include "pilotage/state.hpp"

namespace pilotage {

/// \tparam Space what plus is for the state: HeadingSpace of a robot, PlainSpace without angles
template <typename Scalar, int N, typename Space = HeadingSpace>
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
    [[gnu::flatten]] void predict(const Model& model, const Vector<Scalar, Inputs>& u,
                                  const Matrix<Scalar, Inputs>& gamma, const State& q) noexcept {
        const auto step = model.linearize(x_, u);
        propagate(step.next, step.a, step.b, gamma, q);
    }

    /// The time update with the linearisation given, so that it may be taken about another point.
    template <typename Transition, int Rows, int Inputs>
    [[gnu::flatten]] void propagate(const State& next, const Transition& a,
                                    const Matrix<Scalar, Rows, Inputs>& b,
                                    const Matrix<Scalar, Inputs>& gamma, const State& q) noexcept {
        fill(x_, [&](int i, int) { return next[i]; });
        Covariance p = congruence(a, p_);
        add_input_noise(b, gamma, p);
        fill_symmetric(p_, [&](int i, int j) { return i == j ? p(i, j) + q[i] : p(i, j); });
    }

    /// Measurement update, eqs. 10, 11 and 28 (Joseph form), linearised at the state as it stands.
    /// It is a transaction: state and covariance change only if the report says accepted.
    template <typename Model, int M>
    [[gnu::flatten]] UpdateReport<Scalar, M> update(const Model& model, const Vector<Scalar, M>& z,
                                                    const Matrix<Scalar, M>& r,
                                                    const Policy& policy) noexcept {
        const auto h = model.linearize(x_.template head<Model::kStates>());
        if (!h.defined) return UpdateReport<Scalar, M>::refused(UpdateFault::undefined);
        return correct(model.minus(z, h.value), h.jacobian, r, policy);
    }

    /// The measurement update with innovation and H given, so that they may be taken at another
    /// point.
    /// \param hold an innovation beyond the gate is only reported, whatever the rule of fusion: the
    /// caller wants to look at it
    template <int M, int Seen>
    [[gnu::flatten]] UpdateReport<Scalar, M> correct(const Vector<Scalar, M>& innovation,
                                                     const Matrix<Scalar, M, Seen>& h,
                                                     const Matrix<Scalar, M>& r,
                                                     const Policy& policy,
                                                     bool hold = false) noexcept {
        UpdateReport<Scalar, M> report;
        fill(report.innovation, [&](int i, int) { return innovation[i]; });
        const auto prior = [&](int i, int j) { return i >= j ? p_(i, j) : p_(j, i); };
        const auto ph =
            entries<Matrix<Scalar, N, M>>([&](int i, int j) { return row_by_row(prior, i, h, j); });
        const auto hph =
            symmetric<Matrix<Scalar, M>>([&](int i, int j) { return row_by_column(h, i, ph, j); });
        fill_symmetric(report.s, [&](int i, int j) { return hph(i, j) + r(i, j); });
        const Ldlt<Scalar, M> s(report.s);
        report.nis = s.squared_norm(innovation);
        const bool usual = report.nis <= Scalar(policy.usual_nis[M - 1]);
        if (!s.positive() || !(report.nis <= std::numeric_limits<Scalar>::max())) {
            report.fault = UpdateFault::numeric;
        } else if (!usual && policy.gated(report.nis, M, hold)) {
            report.fault = UpdateFault::gated;
        } else {
            report.weight = usual ? Scalar(1) : policy.weight(report.nis, M);
            const bool committed =
                report.weight < 1 ? commit_weighted(copy_of(innovation), copy_of(h), copy_of(r),
                                                    report.weight, copy_of(ph), copy_of(hph))
                                  : commit(innovation, h, r, ph, s);
            if (!committed) {
                report.fault = UpdateFault::numeric;
                report.weight = 0;
            }
        }
        return report;
    }

    /// The same for independent components, given their variances.
    template <int M, int Seen>
    [[gnu::flatten]] UpdateReport<Scalar, M> correct_independent(
        const Vector<Scalar, M>& innovation, const Matrix<Scalar, M, Seen>& h,
        const Vector<Scalar, M>& variances, const Policy& policy, bool hold = false) noexcept {
        return correct(innovation, h, diagonal(variances), policy, hold);
    }

   private:
    /// With R / weight in place of R. Out of line, to keep the usual way short.
    template <int M, int Seen>
    [[nodiscard, gnu::noinline, gnu::flatten]] bool commit_weighted(
        const Vector<Scalar, M>& innovation, const Matrix<Scalar, M, Seen>& h,
        const Matrix<Scalar, M>& r, Scalar weight, const Matrix<Scalar, N, M>& ph,
        const Matrix<Scalar, M>& hph) noexcept {
        using Noise = Matrix<Scalar, M>;
        const auto noise = symmetric<Noise>([&](int i, int j) { return r(i, j) / weight; });
        const auto s = symmetric<Noise>([&](int i, int j) { return hph(i, j) + noise(i, j); });
        return commit(innovation, h, noise, ph, Ldlt<Scalar, M>(s));
    }

    /// Joseph form in the order that costs least: with M1 = (I - K H) P the covariance
    /// (I - K H) P (I - K H)' + K R K' is M1 + (K R - M1 H') K'.
    /// \param s factors of S = H P H' + R
    template <int M, int Seen>
    [[nodiscard]] bool commit(const Vector<Scalar, M>& innovation, const Matrix<Scalar, M, Seen>& h,
                              const Matrix<Scalar, M>& r, const Matrix<Scalar, N, M>& ph,
                              const Ldlt<Scalar, M>& s) noexcept {
        Matrix<Scalar, N, M> k;
        each<N>([&](int i) {
            const auto row =
                s.solve(entries<Vector<Scalar, M>>([&](int j, int) { return ph(i, j); }));
            each<M>([&](int j) { k(i, j) = row[j]; });
        });
        const auto m1 =
            symmetric<Covariance>([&](int i, int j) { return p_(i, j) - row_by_row(k, i, ph, j); });
        const auto rest = entries<Matrix<Scalar, N, M>>(
            [&](int i, int j) { return row_by_column(k, i, r, j) - row_by_row(m1, i, h, j); });
        const auto p = symmetric<Covariance>(
            [&](int i, int j) { return m1(i, j) + row_by_row(k, i, rest, j); });
        const auto variances = entries<State>([&](int i, int) { return p_(i, i); });
        if (!Ldlt<Scalar, N>(p, kPivotTolerance, variances).semidefinite() ||
            !Ldlt<Scalar, M>(r).positive())
            return false;
        // Finite without a check: (K innovation)_i^2 <= P_ii NIS.
        const State x = Space::plus(
            x_, entries<State>([&](int i, int) { return row_by_column(k, i, innovation, 0); }));
        fill(x_, [&](int i, int) { return x[i]; });
        fill(p_, [&](int i, int j) { return p(i, j); });
        return true;
    }

    /// Rounding leaves a pivot of a singular covariance this far from zero, relative to the
    /// variance before the update.
    static constexpr Scalar kPivotTolerance = Eigen::NumTraits<Scalar>::epsilon() * 1000;

    State x_;
    Covariance p_;
};

}  // namespace pilotage
