#include "support/random.hpp"

namespace pilotage::test {

Eigen::MatrixXd Draw::covariance(int size) {
    Eigen::MatrixXd root(size, size);
    for (double& entry : root.reshaped()) entry = normal_(generator_);
    const Eigen::MatrixXd product = root * root.transpose() / size;
    return (product + product.transpose() + Eigen::MatrixXd::Identity(size, size)) / 2;
}

}  // namespace pilotage::test
