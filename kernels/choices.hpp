// Choices among formulas, as a scene states them; without the formulas, which few who pass a choice on need.
#pragma once

#include <array>

namespace sluice {

/// W (kernels/smoothing.hpp).
enum class SmoothingFunction { cubic_spline, wendland_c2, wendland_c4, quintic_spline };

/// Artificial, or one of the laminar ones of kernels/terms/laminar_viscosity.hpp.
enum class Viscosity { none, artificial, morris, monaghan_gingold };

/// Which differences of density are no noise and stay (kernels/terms/density_diffusion.hpp).
enum class DensityDiffusion { none, molteni_colagrossi, fourtakas, antuono };

/// Stress of a deformation (kernels/materials/hyperelastic.hpp).
enum class ElasticLaw {
#define SLUICE_ELASTIC_LAW(law, ...) law,
#include "kernels/elastic_laws.def"
#undef SLUICE_ELASTIC_LAW
};
inline constexpr std::array all_elastic_laws{
#define SLUICE_ELASTIC_LAW(law, ...) ElasticLaw::law,
#include "kernels/elastic_laws.def"
#undef SLUICE_ELASTIC_LAW
};

/// In what the arithmetic of pairs is done. State is double in both; in mixed precision the sums over a row, a few
/// dozen pairs, are single too.
enum class Precision { full, mixed };

}  // namespace sluice
