#pragma once
/// \file
/// Seeded draws: every run of a test sees the same numbers.

#include <random>

#include "pilotage/state.hpp"

namespace pilotage::test {

class Draw {
   public:
    explicit Draw(unsigned seed) : generator_(seed) {}

    template <typename Scalar = double>
    [[nodiscard]] Scalar uniform(double low, double high) {
        return static_cast<Scalar>(std::uniform_real_distribution<double>(low, high)(generator_));
    }

    /// A size between two orders of magnitude, each order as likely.
    template <typename Scalar = double>
    [[nodiscard]] Scalar log_uniform(double low, double high) {
        return static_cast<Scalar>(std::exp(uniform(std::log(low), std::log(high))));
    }

    /// Standard normal entries.
    template <typename Scalar, int Rows, int Cols = 1>
    [[nodiscard]] Matrix<Scalar, Rows, Cols> normal() {
        Matrix<Scalar, Rows, Cols> result;
        for (int i = 0; i < Rows * Cols; ++i)
            result.data()[i] = static_cast<Scalar>(normal_(generator_));
        return result;
    }

    /// A full covariance with variances of order `scale`, far from singular.
    template <typename Scalar, int N>
    [[nodiscard]] Matrix<Scalar, N> covariance(double scale = 1) {
        return (covariance(N) * scale).template cast<Scalar>();
    }

    /// Within 50 m of the origin, any heading.
    template <typename Scalar>
    [[nodiscard]] Pose<Scalar> pose() {
        return {uniform<Scalar>(-50, 50), uniform<Scalar>(-50, 50),
                uniform<Scalar>(-3.14159, 3.14159)};
    }

   private:
    [[nodiscard]] Eigen::MatrixXd covariance(int size);

    std::mt19937_64 generator_;
    std::normal_distribution<double> normal_;
};

}  // namespace pilotage::test
