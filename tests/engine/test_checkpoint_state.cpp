// A simulation that goes on from a checkpoint takes the same steps, to the bit.
#include <omp.h>

#include <cstring>

#include "engine/particles/particle_set.hpp"
#include "engine/run/checkpoint/checkpoint_file.hpp"
#include "engine/simulation/simulation.hpp"
#include "tests/catch.hpp"
#include "tests/engine/checkpoint_scenes.hpp"
#include "tests/engine/temporary_folder.hpp"

namespace sluice::test_checkpoint_state {
namespace {

/// All columns of a set, byte by byte.
template <int Dim>
std::string bytes_of(const ParticleSet<Dim>& set) {
    std::string bytes;
    for_each_array(set, [&](const ColumnInfo&, const auto& column) {
        bytes.append(reinterpret_cast<const char*>(column.data()), column.size() * sizeof(column[0]));
    });
    return bytes;
}

/// What can be seen of a simulation; -0 and NaN are told apart, too.
template <int Dim>
std::string bytes_of(const Simulation<Dim>& s) {
    std::string bytes = bytes_of(s.fluid()) + bytes_of(s.solid()) + bytes_of(s.wall()) + bytes_of(s.interface()) +
                        bytes_of(s.boundary());
    const WorkCount work = s.work();
    const EnergyBalance energy = s.energy();
    const double numbers[] = {s.time(), s.time_step(), energy.total(), s.max_speed(), s.interface_balance().residual};
    const std::uint64_t counts[] = {work.steps, work.particle_steps, work.pairs, work.neighbour_builds};
    bytes.append(reinterpret_cast<const char*>(numbers), sizeof numbers);
    bytes.append(reinterpret_cast<const char*>(counts), sizeof counts);
    return bytes;
}

template <int Dim>
void save(const Simulation<Dim>& simulation, const std::filesystem::path& file) {
    write_checkpoint(file, [&](const StateWriter& writer) { simulation.save(writer); });
}

/// Saved after each of these steps, a simulation goes on in a new one; 12 steps later both must be the same.
template <int Dim>
void check_going_on(const Scene& scene) {
    constexpr int further = 12;
    const TemporaryFolder folder;
    Simulation<Dim> whole(scene);
    std::vector<std::string> states{bytes_of(whole)};
    std::vector<std::uint64_t> builds{whole.work().neighbour_builds};
    const std::vector<int> saved_at{0, 1, 6, 17, 28};
    for (int step = 0; step < saved_at.back() + further; ++step) {
        if (std::find(saved_at.begin(), saved_at.end(), step) != saved_at.end())
            save(whole, folder.path() / std::to_string(step));
        whole.step();
        states.push_back(bytes_of(whole));
        builds.push_back(whole.work().neighbour_builds);
    }
    REQUIRE(builds.back() > builds.front() + 1);  // else lists were not put to the test
    for (const int start : saved_at) {
        CAPTURE(start);
        Simulation<Dim> second(scene);
        second.restore(open_checkpoint(folder.path() / std::to_string(start)));
        REQUIRE(bytes_of(second) == states[static_cast<std::size_t>(start)]);
        for (int step = start; step < start + further; ++step) {
            second.step();
            CAPTURE(step);
            // Not REQUIRE of the texts, which would print them.
            const bool same = bytes_of(second) == states[static_cast<std::size_t>(step) + 1];
            REQUIRE(same);
        }
    }
}

}  // namespace

TEST_CASE("A simulation goes on from a checkpoint to the same bits") {
    for (const checkpoint_scenes::Case& c : checkpoint_scenes::cases()) {
        CAPTURE(c.name);
        if (c.scene.dimension == 2)
            check_going_on<2>(c.scene);
        else
            check_going_on<3>(c.scene);
    }
}

TEST_CASE("A simulation goes on to the same bits with another number of threads") {
    // Refined so that fluid, solid and interface are all large enough to be shared out among threads.
    const std::string preset = GENERATE("paper", "modern");
    CAPTURE(preset);
    const Scene scene =
        load_scene(test_scene("small_gate.toml"), {"method.spacing=0.00035", "method.preset=" + preset});
    const TemporaryFolder folder;
    const int threads_before = omp_get_max_threads();
    omp_set_num_threads(1);
    Simulation<2> one(scene);
    for (int step = 0; step < 3; ++step) one.step();
    save(one, folder.path() / "three");
    for (int step = 0; step < 3; ++step) one.step();
    omp_set_num_threads(2);
    Simulation<2> two(scene);
    two.restore(open_checkpoint(folder.path() / "three"));
    for (int step = 0; step < 3; ++step) two.step();
    const bool same = bytes_of(one) == bytes_of(two);
    omp_set_num_threads(threads_before);
    REQUIRE(same);
}

TEST_CASE("Saving changes nothing") {
    const Scene scene = load_scene(test_scene("small_gate.toml"));
    const TemporaryFolder folder;
    Simulation<2> plain(scene), saved(scene);
    for (int step = 0; step < 10; ++step) {
        plain.step();
        saved.step();
        save(saved, folder.path() / "state");
    }
    const bool same = bytes_of(plain) == bytes_of(saved);
    REQUIRE(same);
}

TEST_CASE("The state of another scene is refused") {
    const TemporaryFolder folder;
    const auto file = folder.path() / "state";
    save(Simulation<2>(load_scene(test_scene("small_gate.toml"))), file);
    // Another number of particles, other columns, another dimension.
    for (const char* change : {"method.spacing=0.002", "materials.rubber.model=neo-hookean", "method.preset=modern"}) {
        CAPTURE(change);
        Simulation<2> other(load_scene(test_scene("small_gate.toml"), {change}));
        REQUIRE_THROWS_AS(other.restore(open_checkpoint(file)), CheckpointError);
    }
    Simulation<3> other(load_scene(test_scene("still_water_3d.toml")));
    REQUIRE_THROWS_AS(other.restore(open_checkpoint(file)), CheckpointError);
}

}  // namespace sluice::test_checkpoint_state
