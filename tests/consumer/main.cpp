// Follows the front of a dam break. Usage: consumer SCENE
#include <sluice/sluice.hpp>

#include <algorithm>
#include <cstdio>

using namespace sluice::api;

int main(int argc, char** argv) {
    if (argc != 2) return std::fputs("usage: consumer SCENE\n", stderr), 2;
    try {
        Simulation simulation(Scene::from_file(argv[1], {"method.spacing=0.02"}));
        const double energy = simulation.energy().total();
        for (int k = 1; k <= 5; ++k) {
            simulation.advance_to(0.02 * k);
            const Field position = simulation.field(Medium::fluid, "position");
            const auto x = position.columns[0].values();
            std::printf("t = %.3f s: front at x = %.3f m\n", simulation.time(), *std::max_element(x.begin(), x.end()));
        }
        std::printf("%zu particles, %llu steps, energy %.4g -> %.4g J/m\n", simulation.particles(Medium::fluid),
                    static_cast<unsigned long long>(simulation.steps()), energy, simulation.energy().total());
        for (const std::string& warning : simulation.warnings()) std::puts(warning.c_str());
        simulation.field(Medium::fluid, "presure");  // refused, with the name that was meant
    } catch (const std::exception& error) {
        std::printf("%s\n", error.what());
        return 0;
    }
    return 1;
}
