#pragma once
/// \file
/// The extended Kalman filter as a textbook prints it: dense, in double, with a plain inverse. It
/// shares nothing with pilotage::Ekf but the models' Jacobians, which have an oracle of their own.

#include <Eigen/Core>

namespace pilotage::test {

struct TextbookEkf {
    using Vector = Eigen::VectorXd;
    using Matrix = Eigen::MatrixXd;

    Vector x;
    Matrix p;

    template <typename Filter>
    [[nodiscard]] static TextbookEkf of(const Filter& filter) {
        return {filter.state().template cast<double>(),
                filter.covariance().template cast<double>()};
    }

    /// B and H may be given without the zeros of the states that they do not touch.
    void predict(const Vector& next, const Matrix& a, const Matrix& b, const Matrix& gamma,
                 const Vector& q);
    /// \return NIS, the innovation squared in units of its covariance
    double correct(const Vector& innovation, const Matrix& h, const Matrix& r);
};

/// A fixed-size vector or matrix of any scalar as TextbookEkf takes it.
template <typename Derived>
[[nodiscard]] Eigen::MatrixXd wide(const Eigen::MatrixBase<Derived>& fixed) {
    return fixed.template cast<double>();
}

}  // namespace pilotage::test
