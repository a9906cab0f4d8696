#include "kernels/principal.hpp"

#include <Eigen/Eigenvalues>

namespace sluice {

template <int N>
Principal<N> principal(const Eigen::Matrix<double, N, N>& symmetric) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> solver(symmetric);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

template <int N>
Eigen::Matrix<double, N, 1> principal_values(const Eigen::Matrix<double, N, N>& symmetric) {
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
}

template Principal<2> principal<2>(const Eigen::Matrix2d&);
template Principal<3> principal<3>(const Eigen::Matrix3d&);
template Eigen::Vector2d principal_values<2>(const Eigen::Matrix2d&);
template Eigen::Vector3d principal_values<3>(const Eigen::Matrix3d&);
template Eigen::Vector4d principal_values<4>(const Eigen::Matrix4d&);

}  // namespace sluice
