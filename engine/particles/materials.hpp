// The materials of a medium: any number, one for each of its bodies.
#pragma once

#include <cstdint>
#include <vector>

#include "kernels/materials/equation_of_state.hpp"
#include "kernels/materials/hyperelastic.hpp"
#include "neighbor/fields.hpp"

namespace sluice {

/// The constants of a material that loops need.
struct MaterialConstants {
    std::size_t number = 0;    ///< index into Scene::materials
    EquationOfState eos;       ///< density and sound speed; the pressure of fluids and hypoelastic solids
    double shear_modulus = 0;  ///< μ [Pa]
    Hyperelastic law;          ///< of a hyperelastic solid
    double viscosity = 0;      ///< ν of a fluid, kinematic [m²/s]
};

class MaterialList {
  public:
    /// Sets the material of one of the scene's bodies.
    void add(std::size_t body, const MaterialConstants& material) {
        std::size_t k = 0;
        while (k < all_.size() && all_[k].number != material.number) ++k;
        if (k == all_.size()) all_.push_back(material);
        if (of_body_.size() <= body) of_body_.resize(body + 1);
        of_body_[body] = k;
    }

    bool empty() const { return all_.empty(); }
    /// Whether all bodies have one material, whose constants are then constants of the loops.
    bool uniform() const { return all_.size() == 1; }
    const MaterialConstants& front() const { return all_.front(); }
    const MaterialConstants& of_body(std::size_t body) const { return all_[of_body_[body]]; }
    /// value(material): a single value if there is one material, else one for each of the scene's bodies.
    template <class Value>
    auto by_body(std::size_t bodies, Value&& value) const {
        std::vector<decltype(value(front()))> values;
        if (uniform()) return values.push_back(value(front())), values;
        for (std::size_t b = 0; b < bodies; ++b) values.push_back(value(b < of_body_.size() ? of_body(b) : front()));
        return values;
    }
    auto begin() const { return all_.begin(); }
    auto end() const { return all_.end(); }

  private:
    std::vector<MaterialConstants> all_;  ///< in the order in which bodies first use them
    std::vector<std::size_t> of_body_;
};

/// Calls work(of), where of(i) returns the constants of particle i. Chooses between one material and many once, not for
/// each particle.
template <class Work>
decltype(auto) with_materials(const MaterialList& materials, const Array<std::uint16_t>& body, Work&& work) {
    if (materials.uniform()) {
        const MaterialConstants one = materials.front();
        return work([one](std::size_t) -> const MaterialConstants& { return one; });
    }
    return work([&](std::size_t i) -> const MaterialConstants& { return materials.of_body(body[i]); });
}

}  // namespace sluice
