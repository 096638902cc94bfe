#pragma once
/// \file
/// The unscented transformation: a Gaussian through a function, from the function's values at a few
/// points. Equation numbers are those of Tamas et al. 2008, alpha and beta are van der Merwe's.
///
/// The points are the mean and, off it by +- sqrt(c) times each column of a square root of P, two
/// for each of n dimensions, with c = alpha^2 (n + kappa). Let d+ and d- be the function's values
/// at a pair, less its value y0 at the mean; halves of their difference and sum are the slope and
/// the bend along that column,
///     g = (d+ - d-) / (2 sqrt(c)),        m = (d+ + d-) / 2.
/// Then the sums of eqs. 16 and 17, with the weights put in, are
///     mean = y0 + shift,                  shift = sum m / c
///     P_yy = sum g g' + Omega,            Omega = sum m m' / c + (beta - alpha^2) shift shift'
///     P_xy = root G',                     G the columns g.
/// This keeps what is linear apart from what is not, adds only small differences (which the
/// function's own subtraction has made, so angles may be anywhere), and needs no weight of the
/// centre, whose sign is the usual trouble: Omega is positive semi-definite for every
/// alpha > 0, beta >= 0, kappa >= 0.

#include <cmath>
#include <limits>

#include "pilotage/congruence.hpp"
#include "pilotage/filter/ldlt.hpp"
#include "pilotage/state.hpp"

namespace pilotage {

/// Which points. As it stands this is the set of 2n points with equal weights 1 / 2n at the columns
/// of the Cholesky factor times sqrt(n) (the centre's weight is zero), which is what the cubature
/// rule of third degree prescribes. For n = 3 it has the fourth moments of a Gaussian along each
/// column, beyond that it errs towards a larger covariance. kappa alone gives eq. 14.
struct Unscented {
    double alpha = 1;  ///< spread, above 0
    double beta = 0;   ///< 0 or more
    double kappa = 0;  ///< 0 or more
};

/// The lower triangular root with root root' = P. What has no variance has a row and a column of
/// zeros: no points, and it does not count in n, as if it were not there. Out of line: one copy
/// serves all models.
template <typename Scalar, int N>
[[nodiscard, gnu::noinline, gnu::flatten]] Matrix<Scalar, N> root_of(
    const Matrix<Scalar, N>& p) noexcept {
    // The factors leave out what is not a number; it must not pass for certain.
    if (!p.allFinite())
        return Matrix<Scalar, N>::Constant(std::numeric_limits<Scalar>::quiet_NaN());
    constexpr Scalar rounding = Eigen::NumTraits<Scalar>::epsilon() * N;
    return Ldlt<Scalar, N>(p, rounding).root();
}

/// What a function makes of the points.
template <typename Scalar, int M, int N>
struct UnscentedImage {
    Vector<Scalar, M> shift;     ///< of the mean, from the value at the mean
    Matrix<Scalar, M, N> slope;  ///< G, by the columns of the root
    Matrix<Scalar, M> rest;      ///< Omega, the covariance of what no linear function explains

    [[nodiscard]] Matrix<Scalar, M> covariance() const noexcept {
        return symmetric<Matrix<Scalar, M>>(
            [&](int i, int j) { return row_by_row(slope, i, slope, j) + rest(i, j); });
    }

    /// H with H root = G: the linear function that fits best, P_yx P^-1. It does not depend on what
    /// has no variance.
    [[nodiscard]] Matrix<Scalar, M, N> jacobian(const Matrix<Scalar, N>& root) const noexcept {
        Matrix<Scalar, M, N> h = slope;
        for (int j = N - 1; j >= 0; --j) {
            const Scalar inverse = root(j, j) == 0 ? Scalar(0) : 1 / root(j, j);
            each<M>([&](int i) {
                for (int k = j + 1; k < N; ++k) h(i, j) -= h(i, k) * root(k, j);
                h(i, j) *= inverse;
            });
        }
        return h;
    }
};

/// \param apart apart(dx) = f(x + dx) - f(x), by the subtraction that fits the values of f
template <int M, typename Scalar, int N, typename Apart>
[[nodiscard]] UnscentedImage<Scalar, M, N> unscented_image(const Matrix<Scalar, N>& root,
                                                           const Unscented& set,
                                                           const Apart& apart) {
    using std::sqrt;
    const auto n = static_cast<double>((root.array() != 0).rowwise().any().count());
    const auto c = Scalar(set.alpha * set.alpha * (n + set.kappa));
    const Scalar reach = sqrt(c), per_reach = 1 / (2 * reach), weight = n > 0 ? 1 / c : Scalar(0);
    UnscentedImage<Scalar, M, N> image;
    image.shift.setZero();
    image.slope.setZero();
    image.rest.setZero();
    for (int i = 0; i < N; ++i) {
        if (root(i, i) == 0) continue;
        Vector<Scalar, M> ends[2];
        for (int end = 0; end < 2; ++end) {
            const Scalar far = end == 0 ? reach : -reach;
            ends[end] =
                apart(entries<Vector<Scalar, N>>([&](int j, int) { return root(j, i) * far; }));
        }
        Vector<Scalar, M> bend;
        each<M>([&](int j) {
            bend[j] = (ends[0][j] + ends[1][j]) / 2;
            image.slope(j, i) = (ends[0][j] - ends[1][j]) * per_reach;
            image.shift[j] += weight * bend[j];
        });
        add_lower(image.rest, [&](int j, int k) { return weight * bend[j] * bend[k]; });
    }
    const auto centre = Scalar(set.beta - set.alpha * set.alpha);
    add_lower(image.rest, [&](int j, int k) { return centre * image.shift[j] * image.shift[k]; });
    mirror_lower(image.rest);
    return image;
}

template <typename Scalar, int M, int N>
struct Transformed {
    Vector<Scalar, M> mean;
    Matrix<Scalar, M> covariance;
    Matrix<Scalar, N, M> cross;  ///< of what went in with what came out
};

/// f(x) for x of the given mean and covariance: eqs. 14 to 17.
/// \param f from a vector of N to one of M entries \param minus the difference of two of its values
template <typename Scalar, int N, typename F, typename Minus>
[[nodiscard]] auto unscented_transform(const Vector<Scalar, N>& mean,
                                       const Matrix<Scalar, N>& covariance, const F& f,
                                       const Minus& minus, const Unscented& set = {}) {
    const auto centre = f(mean);
    constexpr int M = decltype(centre)::RowsAtCompileTime;
    const auto root = root_of(covariance);
    const auto image = unscented_image<M>(root, set, [&](const Vector<Scalar, N>& dx) {
        return minus(f(Vector<Scalar, N>(mean + dx)), centre);
    });
    return Transformed<Scalar, M, N>{centre + image.shift, image.covariance(),
                                     root * image.slope.transpose()};
}

/// The same where no value is an angle.
template <typename Scalar, int N, typename F>
[[nodiscard]] auto unscented_transform(const Vector<Scalar, N>& mean,
                                       const Matrix<Scalar, N>& covariance, const F& f,
                                       const Unscented& set = {}) {
    return unscented_transform(
        mean, covariance, f, [](const auto& a, const auto& b) { return (a - b).eval(); }, set);
}

}  // namespace pilotage
