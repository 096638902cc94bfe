#include "support/matchers.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace pilotage::test {

::testing::AssertionResult close_in_double(const Eigen::MatrixXd& actual,
                                           const Eigen::MatrixXd& expected, double tolerance) {
    const double scale = std::max(1.0, expected.cwiseAbs().maxCoeff());
    const double difference = (actual - expected).cwiseAbs().maxCoeff();
    if (actual.allFinite() && difference <= tolerance * scale) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << "off by " << difference << ", actual\n"
                                         << actual.format(kDigits) << "\nexpected\n"
                                         << expected.format(kDigits);
}

::testing::AssertionResult same_pose_in_double(const Pose<double>& actual,
                                               const Pose<double>& expected, double tolerance) {
    const Pose<double> difference = minus<double, 3>(actual, expected);
    if (difference.allFinite() && difference.cwiseAbs().maxCoeff() <= tolerance)
        return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << "pose (x, y, heading)\n"
                                         << actual.transpose().format(kDigits) << "\nexpected\n"
                                         << expected.transpose().format(kDigits);
}

double smallest_eigenvalue_ratio(const Eigen::MatrixXd& symmetric) {
    const Eigen::VectorXd ascending =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly)
            .eigenvalues();
    return ascending[0] / ascending[ascending.size() - 1];
}

}  // namespace pilotage::test
