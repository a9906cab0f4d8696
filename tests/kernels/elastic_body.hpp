// A body of elastic particles for the tests of the total Lagrangian passes: its columns, its list, one evaluation.
#pragma once

#include "kernels/passes/total_lagrangian_passes.hpp"
#include "tests/kernels/particles.hpp"

namespace sluice {

/// `reference` holds X, the velocities and what does not change; `position` is x.
template <int Dim>
struct ElasticBody {
    Particles<Dim> reference;
    Hyperelastic law;
    PairMethod<Dim> method;
    NeighborList list;
    VectorField<Dim> position, acceleration;
    SymTensorField<Dim> gradient_correction;
    ScalarField hourglass_stiffness, hourglass_energies;
    TupleField<Dim * Dim> deformation, corrected_stress;

    ElasticBody(const Particles<Dim>& particles, const NeighborList& neighbours, const Hyperelastic& material,
                double hourglass_control, PairMethod<Dim> m = {})
        : reference(particles), law(material), method(m), list(neighbours), position(particles.position) {
        const std::size_t n = particles.size();
        acceleration.resize(n);
        gradient_correction.resize(n);
        hourglass_stiffness.assign(n, 0);
        hourglass_energies.assign(n, 0);
        deformation.resize(n);
        corrected_stress.resize(n);
        const double stiffness = hourglass_control * 2 * law.mu;
        elastic_correction<Dim>(view(), list, {&stiffness, 1}, method, gradient_correction, hourglass_stiffness);
    }
    ElasticBody(const Particles<Dim>& particles, const Hyperelastic& material, double hourglass_control,
                PairMethod<Dim> m = {})
        : ElasticBody(particles, list_for(particles, m), material, hourglass_control, m) {}

    std::size_t size() const { return reference.size(); }

    ParticleView<Dim> view() const {
        ParticleView<Dim> v = reference.view();
        v.reference_position = v.position;
        v.position = columns_of(position);
        v.deformation = columns_of(deformation);
        v.corrected_stress = columns_of(corrected_stress);
        v.hourglass_stiffness = hourglass_stiffness.data();
        v.gradient_correction = columns_of(gradient_correction);
        return v;
    }

    /// x = A X + c
    void deform(const Tensor<Dim>& a, const Vec<Dim>& c = {}) {
        for (std::size_t i = 0; i < size(); ++i) {
            Vec<Dim> x = c;
            for (int k = 0; k < Dim * Dim; ++k) x[k / Dim] += a(k / Dim, k % Dim) * reference.position[i][k % Dim];
            position.set(i, x);
        }
    }

    /// F, T and the acceleration of the current positions.
    void evaluate(const ElasticViscosity& viscosity = {}) {
        elastic_deformation<Dim>(view(), list, {&law, 1}, method, deformation, corrected_stress);
        for (ScalarField& column : acceleration.c) std::fill(column.begin(), column.end(), 0.0);
        elastic_momentum<Dim>(view(), list, viscosity, method, acceleration);
    }

    Tensor<Dim> deformation_of(std::size_t i) const {
        Tensor<Dim> f;
        for (int k = 0; k < Dim * Dim; ++k) f(k / Dim, k % Dim) = deformation[i][k];
        return f;
    }

    double kinetic_energy() const {
        double sum = 0;
        for (std::size_t i = 0; i < size(); ++i) sum += 0.5 * reference.mass[i] * norm2(reference.velocity[i]);
        return sum;
    }
    /// Of the deformations of the last evaluation, hourglass control included.
    double elastic_energy() {
        hourglass_energy<Dim>(view(), list, method, hourglass_energies);
        double sum = 0;
        for (std::size_t i = 0; i < size(); ++i)
            sum += reference.volume[i] * law.energy_density<Dim>(deformation_of(i)) + hourglass_energies[i];
        return sum;
    }

  private:
    /// list_of takes a support of 2h for granted.
    static NeighborList list_for(const Particles<Dim>& particles, const PairMethod<Dim>& method) {
        ScalarField reach = particles.h;
        for (double& h : reach) h *= method.smoothing.support / 2;
        return list_between<Dim>(particles.position, reach, particles.position, reach);
    }
};

/// Velocity Verlet: kick, drift, forces, kick. The forces of the start must have been evaluated.
template <int Dim>
void verlet_step(ElasticBody<Dim>& body, double dt) {
    const auto move = [&](VectorField<Dim>& to, const VectorField<Dim>& rate, double time) {
        for (std::size_t i = 0; i < body.size(); ++i) to.set(i, to[i] + time * rate[i]);
    };
    move(body.reference.velocity, body.acceleration, 0.5 * dt);
    move(body.position, body.reference.velocity, dt);
    body.evaluate();
    move(body.reference.velocity, body.acceleration, 0.5 * dt);
}

}  // namespace sluice
