#pragma once
/// \file
/// A measurement that is linear in the state: what is exact only for linear models is tested on it.

#include "pilotage/state.hpp"

namespace pilotage::test {

template <typename Scalar, int M, int N>
struct LinearMeasurement {
    static constexpr int kStates = N;

    Matrix<Scalar, M, N> h;
    bool defined = true;

    struct Prediction {
        Vector<Scalar, M> value;
        Matrix<Scalar, M, N> jacobian;
        bool defined;
    };

    [[nodiscard]] Prediction linearize(const Vector<Scalar, N>& x) const noexcept {
        return {h * x, h, defined};
    }

    [[nodiscard]] Vector<Scalar, M> minus(const Vector<Scalar, M>& z,
                                          const Vector<Scalar, M>& predicted) const noexcept {
        return z - predicted;
    }
};

}  // namespace pilotage::test
