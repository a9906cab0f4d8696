#include "engine/geometry/moving_least_squares.hpp"

#include <Eigen/Cholesky>

#include "kernels/principal.hpp"
#include "kernels/smoothing.hpp"

namespace sluice {
namespace {

/// One more than a linear basis has terms in 2D, two more in 3D: a mean over neighbours, not a fit through single
/// points.
template <int Dim>
constexpr std::size_t fewest_points = Dim == 2 ? 4 : 6;

/// Below this ratio of the extreme eigenvalues of M the points lie (nearly) on a line or plane. A square lattice seen
/// from half a spacing outside has about 1e-2, a line 0 to rounding.
constexpr double least_spread = 1e-6;

template <int Dim>
using Basis = Eigen::Matrix<double, Dim + 1, 1>;

/// (1, (x − at)/radius): centred and scaled, so that M's entries are alike.
template <int Dim>
Basis<Dim> basis(const Vec<Dim>& offset, double radius) {
    Basis<Dim> p;
    p[0] = 1;
    for (int k = 0; k < Dim; ++k) p[k + 1] = offset[k] / radius;
    return p;
}

}  // namespace

template <int Dim>
std::optional<std::vector<Share>> least_squares_shares(const std::vector<Vec<Dim>>& points, const Vec<Dim>& at,
                                                       double radius) {
    std::vector<Share> shares;
    Eigen::Matrix<double, Dim + 1, Dim + 1> moments = Eigen::Matrix<double, Dim + 1, Dim + 1>::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec<Dim> offset = points[i] - at;
        const double weight = CubicSpline<Dim>::shape(CubicSpline<Dim>::support * norm(offset) / radius);
        if (weight <= 0) continue;
        const Basis<Dim> p = basis<Dim>(offset, radius);
        moments += weight * p * p.transpose();
        shares.push_back({i, weight});
    }
    if (shares.size() < fewest_points<Dim>) return std::nullopt;
    const Basis<Dim> spread = principal_values<Dim + 1>(moments);
    if (spread.minCoeff() < least_spread * spread.maxCoeff()) return std::nullopt;
    const Basis<Dim> coefficient = moments.ldlt().solve(basis<Dim>({}, radius));
    for (Share& share : shares) share.weight *= basis<Dim>(points[share.point] - at, radius).dot(coefficient);
    return shares;
}

template std::optional<std::vector<Share>> least_squares_shares<2>(const std::vector<Vec<2>>&, const Vec<2>&, double);
template std::optional<std::vector<Share>> least_squares_shares<3>(const std::vector<Vec<3>>&, const Vec<3>&, double);

}  // namespace sluice
