// What `sluice help effects` prints: every effect, and of each all that the table has.
#include "engine/effect_help.hpp"

#include "engine/effect_fields.hpp"
#include "engine/effect_table.hpp"
#include "tests/catch.hpp"

namespace sluice {
namespace {

bool has(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("The list and the document have every effect with its rule") {
    const std::string list = effect_list(), document = effects_document();
    for (const EffectRow& row : effect_table()) {
        CAPTURE(std::string(row.info.key));
        for (const std::string_view part : {row.info.key, row.info.name, row.info.automatic}) {
            REQUIRE(has(list, part));
            REQUIRE(has(document, part));
        }
        REQUIRE(has(document, row.info.formula));
        REQUIRE(has(document, row.info.equation));
    }
}

TEST_CASE("An effect's page has every entry of its row, and each of its fields") {
    for (const EffectRow& row : effect_table()) {
        CAPTURE(std::string(row.info.key));
        const std::string page = effect_page(row.info);
        for (const std::string_view part :
             {row.info.key, row.info.name, row.info.automatic, row.info.formula, row.info.equation})
            REQUIRE(has(page, part));
        for (const ColumnBytes& c : column_bytes_of<2>(row.info)) REQUIRE(has(page, c.column));
    }
}

TEST_CASE("A page tells bytes per particle in two and three dimensions") {
    const auto page = [](Effect e) { return effect_page(effect_table()[static_cast<std::size_t>(e)].info); };
    // A vector of doubles.
    REQUIRE(has(page(Effect::velocity_filter), "memory    fluid 16/24 bytes"));
    REQUIRE(has(page(Effect::velocity_filter), "fluid: velocity_correction 16/24"));
    // A scalar has the same in both.
    REQUIRE(has(page(Effect::excess_density), "fluid: excess_density 8\n"));
    REQUIRE(has(page(Effect::gravity), "memory    none\n"));
}

TEST_CASE("The columns of an effect add up to its bytes, phase by phase") {
    for (const EffectRow& row : effect_table()) {
        CAPTURE(std::string(row.info.key));
        for (const FieldBytes& phase : field_bytes<3>(row.info)) {
            std::size_t sum = 0;
            for (const ColumnBytes& c : column_bytes_of<3>(row.info)) sum += c.phase == phase.phase ? c.bytes : 0;
            REQUIRE(sum == phase.bytes);
        }
    }
}

}  // namespace sluice
