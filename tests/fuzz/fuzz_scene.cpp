// Any text at all as a scene: read, told back, its particles placed, and a step taken. Whatever it says must end in a
// scene that works or in a message that names file and line.
#include <cstddef>
#include <cstdint>
#include <string>

#include "engine/base/errors.hpp"
#include "engine/geometry/packing.hpp"
#include "engine/run/output/probes.hpp"
#include "engine/run/watch/watch.hpp"
#include "engine/simulation/simulation.hpp"
#include "tests/engine/lattice_sites.hpp"
#include "tests/fuzz/demand.hpp"

namespace sluice {
namespace {

/// Few enough for some hundred scenes in a second.
constexpr double most_sites = 200;

const std::string path = "/no-such-folder/scene.toml";

void demand_place(const std::string& message) {
    const std::size_t digit = path.size() + 1;
    demand(message.starts_with(path + ":") && message.size() > digit && message[digit] >= '0' && message[digit] <= '9',
           "a message that names file and line: " + message);
}

/// What is written beside the results is the same scene. References are left out of it.
void demand_same_again(const Scene& scene) {
    demand(parse_scene(scene.source, path).source == scene.source, "the scene's own text reads as another scene");
}

template <int Dim>
void simulate(const Scene& scene) {
    Simulation<Dim> simulation(scene);
    Watch<Dim> watch(simulation);
    const Probes<Dim> probes(simulation);
    simulation.step();
    watch.look(simulation);
    probes.sample(simulation);
}

void read(const std::string& text) {
    try {
        const Scene scene = parse_scene(text, path);
        demand_same_again(scene);
        if (!(lattice_sites(scene) <= most_sites)) return;
        if (scene.dimension == 2)
            simulate<2>(scene);
        else
            simulate<3>(scene);
    } catch (const SceneError& error) {
        demand_place(error.what());
    } catch (const NumericalError&) {
        // Told with particle and time; whether it could have been foreseen is what the random scenes ask.
    }
}

}  // namespace
}  // namespace sluice

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    sluice::read(std::string(reinterpret_cast<const char*>(data), size));
    return 0;
}
