#include "support/textbook_ekf.hpp"

#include <Eigen/LU>

#include "pilotage/state.hpp"

namespace pilotage::test {

void TextbookEkf::predict(const Vector& next, const Matrix& a, const Matrix& b, const Matrix& gamma,
                          const Vector& q) {
    Matrix full_b = Matrix::Zero(x.size(), b.cols());
    full_b.topRows(b.rows()) = b;
    x = next;
    p = a * p * a.transpose() + full_b * gamma * full_b.transpose();
    p.diagonal() += q;
}

double TextbookEkf::correct(const Vector& innovation, const Matrix& h, const Matrix& r) {
    Matrix full_h = Matrix::Zero(h.rows(), x.size());
    full_h.leftCols(h.cols()) = h;
    const Matrix s = full_h * p * full_h.transpose() + r;
    const Matrix s_inverse = s.inverse();
    const Matrix k = p * full_h.transpose() * s_inverse;
    x += k * innovation;
    x[kHeading] = wrap(x[kHeading]);
    p = (Matrix::Identity(x.size(), x.size()) - k * full_h) * p;
    return innovation.dot(s_inverse * innovation);
}

}  // namespace pilotage::test
