// Principal values and axes of small symmetric tensors. Eigen's solver is compiled here once: it takes the compiler seconds.
#pragma once

#include <Eigen/Core>

namespace sluice {

template <int N>
struct Principal {
    Eigen::Matrix<double, N, 1> values;  // ascending
    Eigen::Matrix<double, N, N> axes;    // unit vectors, a column for each value
};

/// Of a symmetric tensor, of which the lower triangle is read; N = 2, 3.
template <int N>
Principal<N> principal(const Eigen::Matrix<double, N, N>& symmetric);

/// The values alone, ascending; N = 2, 3, 4.
template <int N>
Eigen::Matrix<double, N, 1> principal_values(const Eigen::Matrix<double, N, N>& symmetric);

}  // namespace sluice
