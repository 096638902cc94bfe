#pragma once
/// \file
/// How an innovation decides about its own update: taken as it is, gated, or weighted.

#include <algorithm>
#include <cmath>

namespace pilotage {

/// The rule that an update follows.
enum class Fusion : unsigned char {
    plain,      ///< every finite innovation is fused with full weight
    gate,       ///< an innovation above the gate is rejected
    student_t,  ///< an unlikely innovation is fused with a smaller weight, none is rejected
};

/// Probability that a chi-square variable of 1, 2 or 3 degrees of freedom exceeds `x`.
[[nodiscard]] inline double chi_square_tail(double x, int dof) noexcept {
    if (dof == 2) return std::exp(-x / 2);
    const double one = std::erfc(std::sqrt(x / 2));
    return dof == 1 ? one : one + std::sqrt(2 * x / 3.14159265358979323846) * std::exp(-x / 2);
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
    Fusion fusion = Fusion::plain;
    double gate_nis[3] = {};   ///< limit on NIS by degrees of freedom 1, 2, 3
    double student_t_dof = 4;  ///< nu: smaller is more sceptical

    /// \param false_reject probability that the gate rejects a good sighting
    [[nodiscard]] static Policy make(Fusion fusion, double false_reject,
                                     double student_t_dof) noexcept {
        Policy policy{fusion, {}, student_t_dof};
        for (int dof = 1; dof <= 3; ++dof)
            policy.gate_nis[dof - 1] = chi_square_quantile(false_reject, dof);
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

    template <typename Scalar>
    [[nodiscard]] bool gated(Scalar nis, int components) const noexcept {
        return fusion == Fusion::gate && !(nis <= Scalar(gate_nis[components - 1]));
    }
};

}  // namespace pilotage
