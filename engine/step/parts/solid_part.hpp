// Solids take steps of their own within a step, all of them the same number.
#pragma once

#include <memory>
#include <vector>

#include "engine/step/context.hpp"
#include "engine/step/part.hpp"

namespace sluice {

/// The solids of one model: a range of the solid set.
template <int Dim>
class SolidPart : public Part<Dim> {
  public:
    /// Called before and after the solids' own steps within a step.
    virtual void begin_step() = 0;
    virtual void end_step() = 0;
    /// Takes step number `substep` of its own, up to the positions at its end. Returns a bound of how far particles
    /// move. [m]
    virtual double move(int substep) = 0;
    /// Finishes that step once all solids have moved: computes the forces at the new positions.
    virtual void finish_move() {}
};

/// All solids. Forces between solids of different models are computed when both are at the same instant.
template <int Dim>
class Solids final : public Part<Dim> {
  public:
    Solids(StepContext<Dim>& context, std::vector<std::unique_ptr<SolidPart<Dim>>> parts)
        : c_(context), parts_(std::move(parts)) {}

    void start() override {
        for (const auto& part : parts_) part->start();
    }
    void limit_step(std::vector<CourantLimit>& limits) const override {
        for (const auto& part : parts_) part->limit_step(limits);
    }
    void first_half() override {
        for (const auto& part : parts_) part->begin_step();
        for (int substep = 0; substep < c_.plan.substeps; ++substep) {
            double moved = 0;
            for (const auto& part : parts_) moved = larger(moved, part->move(substep));
            for (const auto& part : parts_) part->finish_move();
            c_.motion.solid += moved;
        }
        for (const auto& part : parts_) part->end_step();
        c_.solid_steps += static_cast<std::uint64_t>(c_.plan.substeps);
    }
    void last_kick() override {
        for (const auto& part : parts_) part->last_kick();
    }
    void add_energy(EnergyBalance& e) const override {
        for (const auto& part : parts_) part->add_energy(e);
    }
    Vec<Dim> momentum() const override {
        Vec<Dim> sum;
        for (const auto& part : parts_) sum += part->momentum();
        return sum;
    }
    void save(const StateWriter& writer) override {
        for (const auto& part : parts_) part->save(writer);
    }
    void restore(const StateReader& reader) override {
        for (const auto& part : parts_) part->restore(reader);
    }

  private:
    StepContext<Dim>& c_;
    std::vector<std::unique_ptr<SolidPart<Dim>>> parts_;
};

}  // namespace sluice
