// A time step allocates nothing, but where neighbours are listed anew.
#include <atomic>
#include <cstdlib>
#include <new>

#include "tests/catch.hpp"
#include "tests/engine/physics_scenes.hpp"

namespace {

std::atomic<long> allocations{0};

void* counted(std::size_t n, std::size_t alignment) {
    ++allocations;
    void* p = std::aligned_alloc(alignment, (n + alignment - 1) / alignment * alignment);
    if (!p) throw std::bad_alloc();
    return p;
}

}  // namespace

// All of this program's allocations are counted.
void* operator new(std::size_t n) { return counted(n, alignof(std::max_align_t)); }
void* operator new(std::size_t n, std::align_val_t a) { return counted(n, static_cast<std::size_t>(a)); }
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }

namespace sluice::test_allocation {
namespace {

template <int Dim>
void check_no_allocation(Simulation<Dim>& simulation) {
    advance(simulation, 2);  // scratch grows to its size
    int without_search = 0;
    for (int s = 0; s < 30; ++s) {
        const std::uint64_t builds = simulation.work().neighbour_builds;
        const long before = allocations;
        simulation.step();
        const long made = allocations - before;
        if (simulation.work().neighbour_builds != builds) continue;
        ++without_search;
        REQUIRE(made == 0);
    }
    REQUIRE(without_search > 10);
}

/// The gate with a fixed wall behind its water, which stands last.
std::string gate_before_wall() {
    return preamble(0.0025) + water_at_gate("-0.1") + mirror_floor + R"toml(
[walls.back]
kind = "fixed"
shape = { box = { min = [-0.12, 0.0], max = [-0.1, 0.06] } }
)toml";
}

}  // namespace

TEST_CASE("A step without a search allocates nothing") {
    const std::string precision = GENERATE("double", "mixed"), rate = GENERATE("single-rate", "multi-rate");
    Simulation<2> simulation(scene_text::load(
        with_gravity + gate_before_wall(),
        {"method.precision=" + precision, "method.time_stepping=" + rate, "method.solid.velocity_filter=0.99"}));
    check_no_allocation(simulation);
}

TEST_CASE("A step without a search allocates nothing in 3D") {
    Simulation<3> simulation(scene_text::load("dimension = 3\ngravity = [0.0, -9.81, 0.0]\n" + preamble(0.005) + R"toml(
[bodies.water]
material = "water"
shape = { box = { min = [-0.05, 0.0, 0.0], max = [0.0, 0.06, 0.04] } }
hydrostatic_surface = 0.06
[bodies.gate]
material = "rubber"
shape = { box = { min = [0.0, 0.0, 0.0], max = [0.01, 0.06, 0.04] } }
clamp = { box = { min = [0.0, 0.05, 0.0], max = [0.01, 0.06, 0.04] } }
[walls.floor]
kind = "mirror"
point = [0.0, 0.0, 0.0]
normal = [0.0, 1.0, 0.0]
)toml"));
    check_no_allocation(simulation);
}

TEST_CASE("Nor does a step in which bodies and walls touch") {
    Simulation<2> simulation(scene_text::load(preamble(0.0025) + R"toml(
[bodies.lower]
material = "rubber"
shape = { box = { min = [-0.02, 0.0], max = [0.02, 0.02] } }
[bodies.upper]
material = "rubber"
shape = { box = { min = [-0.015, 0.021], max = [0.02, 0.04] } }
velocity = [0.1, -0.2]
[walls.floor]
kind = "fixed"
shape = { box = { min = [-0.03, -0.01], max = [0.03, 0.0] } }
[walls.side]
kind = "mirror"
point = [0.021, 0.0]
normal = [-1.0, 0.0]
)toml",
                                              {"method.preset=modern", "materials.rubber.model=neo-hookean"}));
    while (simulation.energy().contact == 0 && simulation.time() < 0.1) simulation.step();
    REQUIRE(simulation.energy().contact > 0);
    check_no_allocation(simulation);
}

TEST_CASE("Nor does a step with either solid model and coupling, or with what the modern preset has") {
    const std::string preset = GENERATE("paper", "modern"), coupling = GENERATE("interface-force", "moving-boundary"),
                      model = GENERATE("hypoelastic", "st-venant-kirchhoff");
    CAPTURE(preset, coupling, model);
    Simulation<2> simulation(scene_text::load(with_gravity + "acceleration = [\"0.1*sin(t)\", \"0\"]\n" +
                                                  gate_before_wall() +
                                                  "motion = { displacement = [\"0.01*t\", \"0\"] }\n",
                                              {"method.preset=" + preset, "method.coupling=" + coupling,
                                               "materials.rubber.model=" + model, "materials.water.viscosity=0.001"}));
    check_no_allocation(simulation);
}

}  // namespace sluice::test_allocation
