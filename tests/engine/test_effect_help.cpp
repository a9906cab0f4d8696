// What `sluice help effects` prints: every effect, and of each all that the table has.
#include "engine/scene/rules/effect_help.hpp"

#include "engine/scene/rules/effect_fields.hpp"
#include "kernels/columns/columns.hpp"
#include "tests/catch.hpp"

namespace sluice::test_effect_help {
namespace {

bool has(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("The list and the document have every effect with its rule") {
    const std::string list = effect_list(), document = effects_document();
    for (const EffectInfo& effect : effect_table) {
        CAPTURE(std::string(effect.key));
        for (const std::string_view part : {effect.key, effect.name, effect.automatic}) {
            REQUIRE(has(list, part));
            REQUIRE(has(document, part));
        }
        REQUIRE(has(document, effect.formula));
        REQUIRE(has(document, effect.equation));
    }
}

TEST_CASE("An effect's page has every entry of its row, and each of its fields") {
    for (const EffectInfo& effect : effect_table) {
        CAPTURE(std::string(effect.key));
        const std::string page = effect_page(effect);
        for (const std::string_view part : {effect.key, effect.name, effect.automatic, effect.formula, effect.equation})
            REQUIRE(has(page, part));
        for (const ColumnBytes& c : column_bytes_of<2>(effect)) REQUIRE(has(page, c.column));
    }
}

TEST_CASE("A page tells bytes per particle in two and three dimensions") {
    const auto page = [](Effect e) { return effect_page(info_of(e)); };
    // A vector of doubles.
    REQUIRE(has(page(Effect::velocity_filter), "memory    fluid 16/24 bytes"));
    REQUIRE(has(page(Effect::velocity_filter), "fluid: velocity_correction 16/24"));
    // A scalar has the same in both.
    REQUIRE(has(page(Effect::excess_density), "fluid: excess_density 8\n"));
    REQUIRE(has(page(Effect::gravity), "memory    none\n"));
}

TEST_CASE("Each column of an effect takes as many bytes as its arrays do") {
    const Columns<3> columns;
    const auto bytes_of_arrays = [&](std::string_view name) {
        std::size_t bytes = 0;
        for_each_array(columns, [&](const ColumnInfo& info, const auto& array) {
            if (info.name == name) bytes += sizeof(array[0]);
        });
        return bytes;
    };
    for (const EffectInfo& effect : effect_table) {
        CAPTURE(std::string(effect.key));
        for (const ColumnBytes& c : column_bytes_of<3>(effect)) {
            CAPTURE(std::string(c.column));
            REQUIRE(c.bytes == bytes_of_arrays(c.column));
        }
    }
}

}  // namespace sluice::test_effect_help
