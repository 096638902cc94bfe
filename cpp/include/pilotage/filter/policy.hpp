#pragma once
/// \file
/// How an innovation decides about its own update: taken as it is, gated, or weighted.

#include <algorithm>
#include <cmath>
#include <limits>

namespace pilotage {

/// The rule that an update follows.
enum class Fusion : unsigned char {
    plain,      ///< every finite innovation is fused with full weight
    gate,       ///< an innovation above the gate is rejected
    student_t,  ///< an unlikely innovation is fused with a smaller weight, none is rejected
};

/// Probability that a chi-square variable exceeds `x` (Abramowitz and Stegun 26.4.4 and 26.4.5).
/// \param dof degrees of freedom, 1 or more
[[nodiscard]] inline double chi_square_tail(double x, int dof) noexcept {
    const bool even = dof % 2 == 0;
    double total = even ? 0 : std::erfc(std::sqrt(x / 2));
    if (dof == 1) return total;
    double term = std::exp(-x / 2);
    if (!even) term *= std::sqrt(2 * x / 3.14159265358979323846);
    for (int d = even ? 2 : 3; d <= dof; d += 2) {
        total += term;
        term *= x / d;
    }
    return total;
}

/// The x that a chi-square variable of 1, 2 or 3 degrees of freedom exceeds with probability
/// `tail`.
[[nodiscard]] inline double chi_square_quantile(double tail, int dof) noexcept {
    double low = 0, high = 1;
    while (high < 1e4 && chi_square_tail(high, dof) > tail) high *= 2;
    for (int i = 0; i < 100; ++i) {
        const double middle = (low + high) / 2;
        (chi_square_tail(middle, dof) > tail ? low : high) = middle;
    }
    return (low + high) / 2;
}

/// A fusion rule with its numbers. NIS is compared with a limit on NIS, never on its square root.
struct Policy {
    static constexpr double kAny = std::numeric_limits<double>::infinity();

    Fusion fusion = Fusion::plain;
    double gate_nis[3] = {};  ///< limit on NIS by degrees of freedom 1, 2, 3
    /// Up to here, by the same, every rule fuses with full weight.
    double usual_nis[3] = {kAny, kAny, kAny};
    double student_t_dof = 4;  ///< nu: smaller is more sceptical

    /// \param false_reject probability that the gate rejects a good sighting
    [[nodiscard]] static Policy make(Fusion fusion, double false_reject,
                                     double student_t_dof) noexcept {
        Policy policy;
        policy.fusion = fusion;
        policy.student_t_dof = student_t_dof;
        for (int dof = 1; dof <= 3; ++dof) {
            const double gate = chi_square_quantile(false_reject, dof);
            policy.gate_nis[dof - 1] = gate;
            if (fusion != Fusion::plain) policy.usual_nis[dof - 1] = std::min(gate, double(dof));
        }
        return policy;
    }

    /// Student-t weight (nu + d) / (nu + NIS) of an innovation of d components, capped at 1 so that
    /// a small innovation does not make the covariance smaller than the stated noise allows.
    template <typename Scalar>
    [[nodiscard]] Scalar weight(Scalar nis, int components) const noexcept {
        if (fusion != Fusion::student_t) return Scalar(1);
        const auto nu = Scalar(student_t_dof);
        return std::min(Scalar(1), (nu + Scalar(components)) / (nu + nis));
    }

    /// Whether the summed NIS of independent innovations, of so many components together, is what
    /// the gate would reject of one.
    [[nodiscard]] bool beyond_gate(double nis, int components) const noexcept {
        if (components <= 3) return !(nis <= gate_nis[components - 1]);
        if (nis <= gate_nis[2]) return false;
        return !(chi_square_tail(nis, components) >= chi_square_tail(gate_nis[1], 2));
    }

    /// \param always whatever the rule
    template <typename Scalar>
    [[nodiscard]] bool gated(Scalar nis, int components, bool always = false) const noexcept {
        return (always || fusion == Fusion::gate) && !(nis <= Scalar(gate_nis[components - 1]));
    }
};

}  // namespace pilotage
