#pragma once
/// \file
/// What the models of the Ekf say about a whole Gaussian, by the unscented transformation: their
/// values alone count, not their Jacobians. A sigma point's heading may lie beyond pi.

#include "pilotage/filter/unscented.hpp"

namespace pilotage {

template <typename Scalar, int N>
struct Gaussian {
    Vector<Scalar, N> mean;
    Matrix<Scalar, N> covariance;
};

/// f(x, u) of an uncertain state and an uncertain input, eqs. 14, 20 and 21 of Tamas et al. 2008
/// with the state augmented by the input. Input noise of zero leaves the state's points alone.
/// \param gamma covariance of the input u
template <typename Space, typename Model, typename Scalar, int N, int Inputs>
[[nodiscard, gnu::flatten]] Gaussian<Scalar, N> unscented_motion(
    const Model& model, const Vector<Scalar, N>& x, const Matrix<Scalar, N>& p,
    const Vector<Scalar, Inputs>& u, const Matrix<Scalar, Inputs>& gamma,
    const Unscented& set) noexcept {
    const Vector<Scalar, N> next = model.linearize(x, u).next;
    Matrix<Scalar, N + Inputs> root = Matrix<Scalar, N + Inputs>::Zero();
    root.template topLeftCorner<N, N>() = root_of(p);
    root.template bottomRightCorner<Inputs, Inputs>() = root_of(gamma);
    const auto image = unscented_image<N>(root, set, [&](const Vector<Scalar, N + Inputs>& d) {
        const auto from = entries<Vector<Scalar, N>>([&](int i, int) { return x[i] + d[i]; });
        const auto by =
            entries<Vector<Scalar, Inputs>>([&](int i, int) { return u[i] + d[N + i]; });
        return Space::minus(Vector<Scalar, N>(model.linearize(from, by).next), next);
    });
    return {Space::plus(next, image.shift), image.covariance()};
}

/// h(x) as a linear function with noise of its own: statistical linearisation.
template <typename Scalar, int M, int States>
struct UnscentedMeasurement {
    Vector<Scalar, M> value;             ///< the mean of h(x)
    Matrix<Scalar, M, States> jacobian;  ///< P_zx P^-1, by the states that the model sees
    Matrix<Scalar, M> noise;             ///< Omega, what the linear function leaves: adds to R
    bool defined;                        ///< at every point
};

/// What `Ekf::correct` needs of a model to make the update of the unscented filter, eqs. 22 to 28
/// of Tamas et al. 2008: with H = P_zx P^-1 its H P H' + R + Omega is P_zz + R (eq. 24 lacks R),
/// and K and P follow.
/// \param x, p of the states that the model sees: those that it does not see follow these linearly
template <typename Model, typename Scalar, int States>
[[nodiscard, gnu::flatten]] auto unscented_measurement(const Model& model,
                                                       const Vector<Scalar, States>& x,
                                                       const Matrix<Scalar, States>& p,
                                                       const Unscented& set) noexcept {
    const auto centre = model.linearize(x);
    constexpr int M = decltype(centre.value)::RowsAtCompileTime;
    bool defined = centre.defined;
    const auto root = root_of(p);
    const auto image = unscented_image<M>(root, set, [&](const Vector<Scalar, States>& d) {
        const auto h = model.linearize(
            entries<Vector<Scalar, States>>([&](int i, int) { return x[i] + d[i]; }));
        defined = defined && h.defined;
        return model.minus(h.value, centre.value);
    });
    return UnscentedMeasurement<Scalar, M, States>{centre.value + image.shift, image.jacobian(root),
                                                   image.rest, defined};
}

}  // namespace pilotage
