// How parts act on each other in a step: walls, interfaces between fluid and solids, contact.
#pragma once

#include "engine/particles/part_range.hpp"
#include "engine/step/energy_balance.hpp"
#include "engine/step/interface_balance.hpp"
#include "neighbor/vec.hpp"

namespace sluice {

class StateReader;
class StateWriter;

/// The stages are those of Part; in each, couplings come after the parts.
template <int Dim>
class Coupling {
  public:
    virtual ~Coupling() = default;
    Coupling() = default;
    Coupling(const Coupling&) = delete;
    Coupling& operator=(const Coupling&) = delete;

    virtual void start() {}
    virtual void rates() {}
    virtual void forces() {}

    /// Adds to the acceleration of the solid's particles in this range, within the solid's own steps.
    virtual void push_solid(const PartRange&) {}
    /// Reports that no solid particle has moved farther than this since the last call. [m]
    virtual void solid_has_moved(double) {}

    virtual Vec<Dim> fluid_force_on(std::size_t) const { return {}; }    ///< on a solid body [N; N/m in 2D]
    virtual Vec<Dim> contact_force_on(std::size_t) const { return {}; }  ///< on a solid body, of contact [N; N/m in 2D]
    virtual const InterfaceBalance* balance() const { return nullptr; }
    virtual void add_energy(EnergyBalance&) const {}
    virtual std::uint64_t builds() const { return 0; }  ///< of neighbour lists of its own
    virtual std::size_t bytes() const { return 0; }

    virtual void save(const StateWriter&) {}
    virtual void restore(const StateReader&) {}
};

}  // namespace sluice
