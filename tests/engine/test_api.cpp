// What other programs see of the engine: columns that never dangle, and the same bits whoever looks on.
#include <cmath>
#include <optional>

#include "engine/api/include/sluice/sluice.hpp"
#include "engine/scene/scene.hpp"
#include "tests/catch.hpp"

using namespace sluice::api;
using Catch::Matchers::Contains;

namespace {

Scene small_gate(const std::vector<std::string>& changes = {}) {
    return Scene::from_file(SLUICE_TEST_SCENES "/small_gate.toml", changes);
}

template <class T = double>
std::vector<T> copy_of(const Column& column) {
    return {column.values<T>().begin(), column.values<T>().end()};
}

}  // namespace

TEST_CASE("a column that is held keeps its values and its place", "[api]") {
    std::optional<Simulation> simulation(small_gate());
    const Column x = simulation->field(Medium::fluid, "position").columns[0];
    const Column id = simulation->field(Medium::fluid, "id").columns[0];
    const std::vector<double> places = copy_of(x);
    const std::vector<std::uint64_t> order = copy_of<std::uint64_t>(id);
    CHECK(simulation->field(Medium::fluid, "position").columns[0].data() == x.data());

    simulation->advance(300);
    CHECK(copy_of(simulation->field(Medium::fluid, "position").columns[0]) != places);
    // Else there was no sort, and the test shows nothing.
    REQUIRE(copy_of<std::uint64_t>(simulation->field(Medium::fluid, "id").columns[0]) != order);
    simulation.reset();
    CHECK(copy_of(x) == places);
    CHECK(copy_of<std::uint64_t>(id) == order);
}

TEST_CASE("columns that are held do not change the computation", "[api]") {
    for (const char* preset : {"paper", "modern"}) {
        Simulation plain(small_gate({std::string("method.preset=") + preset}));
        Simulation watched(small_gate({std::string("method.preset=") + preset}));
        plain.advance(60);
        std::vector<Field> held;
        for (int k = 0; k < 60; ++k) {
            for (const Medium medium : {Medium::fluid, Medium::solid, Medium::wall})
                for (const std::string& name : watched.fields(medium)) held.push_back(watched.field(medium, name));
            watched.advance(1);
        }
        CHECK(plain.time() == watched.time());
        for (const Medium medium : {Medium::fluid, Medium::solid})
            for (std::size_t k = 0; k < 2; ++k)
                CHECK(copy_of(plain.field(medium, "position").columns[k]) ==
                      copy_of(watched.field(medium, "position").columns[k]));
    }
}

TEST_CASE("a simulation stepped from outside is the run's", "[api]") {
    const Scene scene = small_gate();
    Simulation simulation(scene, 1);
    CHECK(simulation.scene().bodies() == std::vector<std::string>{"tank", "gate"});
    CHECK(simulation.probe_names().size() == simulation.probe_values().size());
    simulation.advance_to(0.001);
    CHECK(std::abs(simulation.time() - 0.001) <= simulation.time_step() / 2);
    const Frame frame = simulation.frame();
    CHECK(frame.points.size() == 3 * frame.id.size());
    CHECK(frame.id.size() == simulation.particles(Medium::fluid) + simulation.particles(Medium::solid) +
                                 simulation.particles(Medium::wall));

    std::uint64_t asked = 0;
    const std::uint64_t before = simulation.steps();
    simulation.advance(100, [&] { return ++asked < 7; });
    CHECK(simulation.steps() == before + 7);
}

TEST_CASE("what is asked for wrongly is answered with what there is", "[api]") {
    const Simulation simulation(small_gate());
    CHECK_THROWS_WITH(simulation.field(Medium::solid, "clampd"),
                      Contains("solid: found the field \"clampd\"") && Contains("did you mean \"clamped\""));
    CHECK_THROWS_AS(simulation.field(Medium::fluid, "id").columns[0].values<double>(), std::logic_error);
    CHECK_THROWS_AS(Scene::from_text("title = 1"), sluice::SceneError);
    CHECK(Scene::from_text(small_gate().text()).text() == small_gate().text());
}
