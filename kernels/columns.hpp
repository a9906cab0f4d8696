// Columns of particles, as the loops over pairs read them.
#pragma once

#include <array>

#include "neighbor/fields.hpp"

namespace sluice {

/// Read-only columns of a set of particles. A pass fills in the columns that its terms read; the others stay null.
template <int Dim>
struct ParticleView {
    template <int N>
    using Columns = std::array<const double*, N>;

    Columns<Dim> position{};                           ///< [m]
    Columns<Dim> velocity{};                           ///< [m/s]
    const double* smoothing_length = nullptr;          ///< h [m]
    const double* mass = nullptr;                      ///< m [kg; kg/m in 2D]
    const double* volume = nullptr;                    ///< V [m³; m² in 2D], of fixed ghosts
    const double* density = nullptr;                   ///< ρ [kg/m³]
    const double* pressure = nullptr;                  ///< p [Pa]
    const double* pressure_over_rho2 = nullptr;        ///< p/ρ² [Pa m⁶/kg²]
    Columns<sym_components<Dim>> stress_over_rho2{};   ///< σ/ρ²
    Columns<sym_components<Dim>> artificial_stress{};  ///< R of eq. (14)
    Columns<Dim> area_normal{};                        ///< n ΔΓ of interface elements [m²; m in 2D]
    Columns<Dim> shared_force{};                       ///< f/ΣVW of interface elements [N/m^Dim]
    Columns<Dim> density_gradient{};                   ///< ⟨∇ρ⟩ [kg/m⁴]
    Columns<Dim> acceleration{};                       ///< of boundary particles [m/s²]

    // Of elastic particles whose `position` is that of the reference configuration
    // (kernels/total_lagrangian_passes.hpp)
    Columns<Dim> current_position{};                     ///< x [m]
    Columns<Dim * Dim> deformation{};                    ///< F, row by row
    Columns<Dim * Dim> corrected_stress{};               ///< P L − k F, row by row [Pa]
    const double* hourglass_stiffness = nullptr;         ///< k [Pa]
    const double* elastic_share = nullptr;               ///< of each particle's ψ; null = 1 for all
    Columns<sym_components<Dim>> gradient_correction{};  ///< L; read particle by particle, not by pairs
};

/// Columns of a tuple field as raw pointers.
template <int N>
std::array<const double*, N> columns_of(const TupleField<N>& field) {
    std::array<const double*, N> p;
    for (std::size_t k = 0; k < N; ++k) p[k] = field.c[k].data();
    return p;
}

/// One entry of a tuple of columns.
template <std::size_t N>
[[gnu::always_inline]] inline Vec<static_cast<int>(N)> at(const std::array<const double*, N>& columns, std::size_t i) {
    Vec<static_cast<int>(N)> v;
    for (std::size_t k = 0; k < N; ++k) v[static_cast<int>(k)] = columns[k][i];
    return v;
}

/// Columns that a term reads besides position and smoothing length. Each term names its own in `reads_i` and `reads_j`;
/// only those of the pack's terms are gathered.
namespace column {
inline constexpr unsigned velocity = 1, mass = 2, volume = 4, density = 8, pressure = 16, pressure_over_rho2 = 32,
                          stress_over_rho2 = 64, artificial_stress = 128, area_normal = 256, shared_force = 512,
                          current_position = 1U << 10, deformation = 1U << 11, corrected_stress = 1U << 12,
                          hourglass_stiffness = 1U << 13, density_gradient = 1U << 14, acceleration = 1U << 15,
                          all = (1U << 16) - 1;
}

/// Where the gathered columns stand: position, smoothing length, then those of `Reads` in the order of their bits.
template <int Dim, unsigned Reads>
struct Slots {
    static constexpr int width(unsigned c) {
        constexpr unsigned vectors = column::velocity | column::area_normal | column::shared_force |
                                     column::current_position | column::acceleration | column::density_gradient;
        if (c & vectors) return Dim;
        if (c & (column::deformation | column::corrected_stress)) return Dim * Dim;
        return c & (column::stress_over_rho2 | column::artificial_stress) ? sym_components<Dim> : 1;
    }
    static constexpr int smoothing_length = Dim;
    /// First slot of a column (one bit); for column::all + 1 the number of slots.
    static constexpr int of(unsigned c) {
        int slot = Dim + 1;
        for (unsigned b = 1; b < c; b <<= 1)
            if (Reads & b) slot += width(b);
        return slot;
    }
    static constexpr int count = of(column::all + 1);

    /// The columns, slot by slot.
    [[gnu::always_inline]] static std::array<const double*, count> of_view(const ParticleView<Dim>& view) {
        std::array<const double*, count> p{};
        const auto put = [&](int slot, const auto& columns) __attribute__((always_inline)) {
            for (std::size_t k = 0; k < columns.size(); ++k) p[static_cast<std::size_t>(slot) + k] = columns[k];
        };
        const auto put_one = [&](unsigned c, const double* one) __attribute__((always_inline)) {
            if (Reads & c) p[static_cast<std::size_t>(of(c))] = one;
        };
        put(0, view.position);
        p[Dim] = view.smoothing_length;
        if (Reads & column::velocity) put(of(column::velocity), view.velocity);
        put_one(column::mass, view.mass);
        put_one(column::volume, view.volume);
        put_one(column::density, view.density);
        put_one(column::pressure, view.pressure);
        put_one(column::pressure_over_rho2, view.pressure_over_rho2);
        if (Reads & column::stress_over_rho2) put(of(column::stress_over_rho2), view.stress_over_rho2);
        if (Reads & column::artificial_stress) put(of(column::artificial_stress), view.artificial_stress);
        if (Reads & column::area_normal) put(of(column::area_normal), view.area_normal);
        if (Reads & column::shared_force) put(of(column::shared_force), view.shared_force);
        if (Reads & column::acceleration) put(of(column::acceleration), view.acceleration);
        if (Reads & column::current_position) put(of(column::current_position), view.current_position);
        if (Reads & column::deformation) put(of(column::deformation), view.deformation);
        if (Reads & column::corrected_stress) put(of(column::corrected_stress), view.corrected_stress);
        put_one(column::hourglass_stiffness, view.hourglass_stiffness);
        if (Reads & column::density_gradient) put(of(column::density_gradient), view.density_gradient);
        return p;
    }
};

}  // namespace sluice
