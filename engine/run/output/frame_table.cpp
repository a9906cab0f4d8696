#include "engine/run/output/frame_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <string_view>
#include <utility>

namespace sluice {
namespace {

/// Components of a stress in the file, also the out-of-plane one of plane strain.
template <int Dim>
constexpr auto stress_names() {
    if constexpr (Dim == 2)
        return std::array<std::string_view, 4>{"stress_xx", "stress_yy", "stress_zz", "stress_xy"};
    else
        return std::array<std::string_view, 6>{"stress_xx", "stress_yy", "stress_zz",
                                               "stress_xy", "stress_xz", "stress_yz"};
}

template <int Dim>
constexpr auto strain_names() {
    if constexpr (Dim == 2)
        return std::array<std::string_view, 3>{"green_strain_xx", "green_strain_yy", "green_strain_xy"};
    else
        return std::array<std::string_view, 6>{"green_strain_xx", "green_strain_yy", "green_strain_zz",
                                               "green_strain_xy", "green_strain_xz", "green_strain_yz"};
}

/// Deviatoric components in the order of the file.
template <int Dim>
auto file_components(const Vec<sym_components<Dim>>& s) {
    if constexpr (Dim == 2)
        return std::array<double, 4>{s[0], s[1], -s[0] - s[1], s[2]};  // plane strain: S has no trace
    else
        return s.c;
}

/// sqrt(3/2 S:S) [Pa]
template <std::size_t N>
double von_mises(const std::array<double, N>& s) {
    double product = 0;
    for (std::size_t k = 0; k < N; ++k) product += (k < 3 ? 1.0 : 2.0) * s[k] * s[k];
    return std::sqrt(1.5 * product);
}

/// Owned particles by rising id.
std::vector<Index> order_by_id(const Array<std::uint64_t>& id, std::size_t owned) {
    std::vector<Index> order(owned);
    std::iota(order.begin(), order.end(), Index{0});
    std::sort(order.begin(), order.end(), [&](Index a, Index b) { return id[a] < id[b]; });
    return order;
}

/// Fixed ghosts have no density of their own; readers leave NaN out of their colour range, a zero would spoil it.
constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

float narrow(double value) { return static_cast<float>(value); }

template <int Dim>
class TableWriter {
  public:
    /// What is written of a solid's stress.
    enum class Stress { none, stress, stress_and_strain };

    TableWriter(std::size_t particles, Stress stress) : stress_(stress) {
        table_.particles = particles;
        add_scalar("pressure");
        add_scalar("density");
        if (stress_ == Stress::none) return;
        for (const std::string_view name : stress_names<Dim>()) add_scalar(name);
        add_scalar("von_mises");
        if (stress_ == Stress::stress_and_strain)
            for (const std::string_view name : strain_names<Dim>()) add_scalar(name);
    }

    void add_fluid(const ParticleSet<Dim>& fluid) {
        for (const Index i : order_by_id(fluid.id, fluid.owned)) {
            add_identity(FrameMedium::fluid, fluid.body[i], fluid.id[i]);
            add_motion(fluid.position[i], fluid.velocity[i]);
            add_state(fluid.pressure[i], fluid.density[i], {});
        }
    }

    void add_solid(const ParticleSet<Dim>& solid, const MaterialList& materials, const PartRange& hyperelastic) {
        for (const Index i : order_by_id(solid.id, solid.owned)) {
            add_identity(FrameMedium::solid, solid.body[i], solid.id[i]);
            add_motion(solid.position[i], solid.velocity[i]);
            if (hyperelastic.holds(i))
                add_deformed(solid, materials.of_body(solid.body[i]).law, i);
            else
                add_state(solid.pressure[i], solid.density[i], solid.deviatoric_stress[i]);
        }
    }

    void add_wall(const ParticleSet<Dim>& wall) {
        for (const Index i : order_by_id(wall.id, wall.owned)) {
            add_identity(FrameMedium::wall, wall.body[i], wall.id[i]);
            add_motion(wall.position[i], {});
            add_state(wall.pressure[i], no_value, {});
        }
    }

    FrameTable take() { return std::move(table_); }

  private:
    void add_scalar(std::string_view name) {
        table_.scalars.push_back({std::string(name), {}});
        table_.scalars.back().value.reserve(table_.particles);
    }

    void add_identity(FrameMedium medium, std::uint16_t body, std::uint64_t id) {
        table_.medium.push_back(static_cast<std::uint8_t>(medium));
        table_.body.push_back(body);
        table_.id.push_back(id);
    }

    void add_motion(const Vec<Dim>& x, const Vec<Dim>& v) {
        for (int k = 0; k < 3; ++k) {
            table_.points.push_back(k < Dim ? narrow(x[k]) : 0.0F);
            table_.velocity.push_back(k < Dim ? narrow(v[k]) : 0.0F);
        }
    }

    /// Cauchy stress and Green strain (FᵀF − I)/2.
    void add_deformed(const ParticleSet<Dim>& solid, const Hyperelastic& law, Index i) {
        const Tensor<Dim> f = tensor_of<Dim>(solid.deformation[i]);
        const Tensor<3> stress = cauchy_stress<Dim>(law, f);
        const double pressure = -stress.trace() / 3;
        const Tensor<Dim> deviator = stress.template topLeftCorner<Dim, Dim>() + pressure * Tensor<Dim>::Identity();
        add_state(pressure, solid.density[i], tensor_to_sym<Dim>(deviator),
                  tensor_to_sym<Dim>(0.5 * (f.transpose() * f - Tensor<Dim>::Identity())));
    }

    /// σ = −p I + S
    void add_state(double pressure, double density, const Vec<sym_components<Dim>>& deviatoric,
                   const Vec<sym_components<Dim>>& strain = {}) {
        auto scalar = table_.scalars.begin();
        (scalar++)->value.push_back(narrow(pressure));
        (scalar++)->value.push_back(narrow(density));
        if (stress_ == Stress::none) return;
        const auto s = file_components<Dim>(deviatoric);
        for (std::size_t k = 0; k < s.size(); ++k) (scalar++)->value.push_back(narrow(k < 3 ? s[k] - pressure : s[k]));
        (scalar++)->value.push_back(narrow(von_mises(s)));
        if (stress_ == Stress::stress_and_strain)
            for (const double e : strain.c) (scalar++)->value.push_back(narrow(e));
    }

    FrameTable table_;
    Stress stress_;
};

}  // namespace

std::size_t bytes_of(const FrameTable& table) {
    std::size_t bytes = table.medium.size() + 2 * table.body.size() + 8 * table.id.size();
    bytes += sizeof(float) * (table.points.size() + table.velocity.size());
    for (const FrameScalar& scalar : table.scalars) bytes += sizeof(float) * scalar.value.size();
    return bytes;
}

template <int Dim>
FrameTable frame_table(const ParticleSet<Dim>& fluid, const ParticleSet<Dim>& solid, const ParticleSet<Dim>& wall,
                       const MaterialList& solid_materials, const PartRange& hyperelastic) {
    using Stress = typename TableWriter<Dim>::Stress;
    const Stress stress = solid.owned == 0       ? Stress::none
                          : hyperelastic.empty() ? Stress::stress
                                                 : Stress::stress_and_strain;
    TableWriter<Dim> writer(fluid.owned + solid.owned + wall.owned, stress);
    writer.add_fluid(fluid);
    writer.add_solid(solid, solid_materials, hyperelastic);
    writer.add_wall(wall);
    return writer.take();
}

template FrameTable frame_table<2>(const ParticleSet<2>&, const ParticleSet<2>&, const ParticleSet<2>&,
                                   const MaterialList&, const PartRange&);
template FrameTable frame_table<3>(const ParticleSet<3>&, const ParticleSet<3>&, const ParticleSet<3>&,
                                   const MaterialList&, const PartRange&);

}  // namespace sluice
