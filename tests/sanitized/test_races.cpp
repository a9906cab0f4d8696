// Every kind of scene with enough particles for all loops to be shared out, on three threads: nothing to compare, but
// the thread sanitizer looks on.
#include <omp.h>

#include "engine/run/checkpoint/checkpoint_file.hpp"
#include "engine/run/output/frame_table.hpp"
#include "engine/run/output/probes.hpp"
#include "engine/run/profile/step_profile.hpp"
#include "engine/run/watch/watch.hpp"
#include "engine/simulation/simulation.hpp"
#include "tests/catch.hpp"
#include "tests/engine/checkpoint_scenes.hpp"

namespace sluice::test_races {
namespace {

/// Above neighbor/parallel.hpp's light_threshold.
constexpr std::size_t enough = 2100;

/// Steps, and all that looks at a state.
template <int Dim>
void take_steps(const Scene& scene) {
    constexpr int steps = 4;
    Simulation<Dim> simulation(scene);
    REQUIRE(simulation.fluid().owned + simulation.solid().owned > enough);
    Watch<Dim> watch(simulation);
    const Probes<Dim> probes(simulation);
    StepProfile profile(3, {steps, 0, scene.output.end});
    for (int step = 0; step < steps; ++step) {
        const StepProfile::Step watched(step % 2 == 0 ? &profile : nullptr, simulation.work().steps, simulation.time());
        simulation.step();
    }
    REQUIRE(profile.entries().size() > 1);
    watch.look(simulation);
    probes.sample(simulation);
    const CheckpointImage image([&](const StateWriter& writer) { simulation.save(writer); });
    simulation.restore(image.reader());
    simulation.step();
    REQUIRE(simulation.work().steps == steps + 1);
}

}  // namespace

TEST_CASE("Steps on several threads") {
    omp_set_num_threads(3);
    const std::string gate = test_scene("small_gate.toml"), tank = test_scene("still_water_3d.toml");
    const std::string fine = "method.spacing=0.0006", shaken = "bodies.tank.velocity=['0.5*sin(100*y)', '-0.8']";
    const std::string paper = "method.preset=paper", modern = "method.preset=modern";
    SECTION("paper") { take_steps<2>(load_scene(gate, {fine, shaken, paper})); }
    SECTION("modern") { take_steps<2>(load_scene(gate, {fine, shaken, modern})); }
    SECTION("modern, hypoelastic, interface force") {
        take_steps<2>(load_scene(gate, {fine, shaken, modern, "materials.rubber.model=hypoelastic",
                                        "method.coupling=interface-force", "method.fluid.density_diffusion=antuono"}));
    }
    SECTION("periodic box, moving wall, friction") {
        take_steps<2>(scene_text::load(checkpoint_scenes::channel, {"method.spacing=0.0005"}));
    }
    SECTION("3D") {
        take_steps<3>(load_scene(tank, {modern, "method.spacing=0.005", "bodies.tank.velocity=['0.5', '0', '0']"}));
    }
    SECTION("contact") {
        using namespace contact_scenes;
        take_steps<2>(scene_text::load(rubber(0.0003) + body("left", disc(-0.0081, 0, 0.008), "[\"3\", \"0\"]") +
                                       body("right", disc(0.0081, 0, 0.008), "[\"-3\", \"0\"]")));
    }
}

}  // namespace sluice::test_races
