// The table of effects: every row can be on and off, and its columns are those that there are.
#include "engine/effect_table.hpp"

#include <set>
#include <sstream>

#include "engine/particles/particle_set.hpp"
#include "tests/catch.hpp"
#include "tests/engine/effect_scenes.hpp"

namespace sluice {
namespace {

/// Every column that a set may have, as "set.column".
std::set<std::string> all_columns() {
    std::set<std::string> columns;
    for (const SetId set : all_sets)
        for (const ColumnInfo& info : column_table)
            columns.insert(std::string(name_of(set)) + "." + std::string(info.name));
    return columns;
}

std::set<std::string> words_of(std::string_view text) {
    std::istringstream stream{std::string(text)};
    std::set<std::string> words;
    for (std::string word; stream >> word;) words.insert(word);
    return words;
}

}  // namespace

TEST_CASE("The table's rows stand in the order of the enumeration, and each has every entry") {
    std::set<std::string_view> keys, names;
    std::size_t row = 0;
    REQUIRE(effect_table().size() == effect_count);
    for (const EffectRow& effect : effect_table()) {
        CAPTURE(std::string(effect.info.key));
        REQUIRE(static_cast<std::size_t>(effect.info.effect) == row++);
        REQUIRE_FALSE(effect.info.name.empty());
        REQUIRE_FALSE(effect.info.equation.empty());
        REQUIRE(effect.info.automatic.starts_with("on if "));
        REQUIRE_FALSE(effect.info.formula.empty());
        REQUIRE(effect.info.formula.find('\n') == std::string_view::npos);
        REQUIRE(effect.rule != nullptr);
        keys.insert(effect.info.key);
        names.insert(effect.info.name);
    }
    REQUIRE(keys.size() == effect_count);
    REQUIRE(names.size() == effect_count);
}

TEST_CASE("The table names no column that there is not, and every column is needed by some effect") {
    std::set<std::string> named, needed;
    for (const EffectRow& row : effect_table()) named.merge(words_of(row.info.fields));
    const std::set<std::string> existing = all_columns();
    for (const std::string& column : named) {
        CAPTURE(column);
        CHECK(existing.contains(column));
        needed.insert(column.substr(column.find('.') + 1));
    }
    for (const ColumnInfo& info : column_table) {
        CAPTURE(std::string(info.name));
        CHECK(needed.contains(std::string(info.name)));
    }
}

TEST_CASE("Every effect is on in a scene that calls for it and off in one that does not; both scenes run") {
    const std::vector<effect_scenes::Case> cases = effect_scenes::cases();
    std::set<Effect> seen;
    for (const auto& c : cases) {
        seen.insert(c.effect);
        for (const bool wanted : {true, false}) {
            Simulation<2> simulation((wanted ? c.on : c.off).load());
            const EffectChoice& choice = simulation.effects().all()[static_cast<std::size_t>(c.effect)];
            CAPTURE(std::string(choice.info.key), wanted, choice.why);
            REQUIRE(choice.on == wanted);
            REQUIRE(simulation.effects().has(c.effect) == wanted);
            REQUIRE_FALSE(choice.why.empty());
            advance(simulation, 2);
            REQUIRE(std::isfinite(simulation.energy().total()));
        }
    }
    REQUIRE(seen.size() == effect_count);
}

TEST_CASE("The table's rules hold in three dimensions") {
    const std::string box = R"toml(
[bodies.block]
material = "rubber"
shape = { box = { min = [0.0, 0.0, 0.0], max = [0.01, 0.01, 0.01] } }
[bodies.water]
material = "water"
shape = { box = { min = [0.01, 0.0, 0.0], max = [0.02, 0.01, 0.01] } }
)toml";
    const Scene scene =
        scene_text::load("dimension = 3\n" + preamble(0.002) + box, {"method.preset=modern", "method.spacing=0.0025"});
    Simulation<3> simulation(scene);
    for (const Effect e : {Effect::moving_boundary, Effect::total_lagrangian, Effect::particle_shifting})
        REQUIRE(simulation.effects().has(e));
    REQUIRE(simulation.boundary().owned > 0);
    simulation.step();
    REQUIRE(std::isfinite(simulation.energy().total()));
}

}  // namespace sluice
