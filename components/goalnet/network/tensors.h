// The matrices of the network: row-major as in the model file, single precision.
#pragma once

#include <Eigen/Core>

namespace goalnet::inference::network {

using Matrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Vector = Eigen::VectorXf;

}  // namespace goalnet::inference::network
