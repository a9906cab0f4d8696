// The parts of a scene, each read from its own table. Order matters: later parts refer to earlier ones.
#pragma once

#include <string>

#include "engine/scene/formula.hpp"
#include "engine/scene/read/toml_table.hpp"

namespace sluice {

void read_domain(TomlTable& root);
void read_method(TomlTable& root);
void read_effects(TomlTable& root);
void read_materials(TomlTable& root);
void read_bodies(TomlTable& root);
void read_walls(TomlTable& root);
void read_probes(TomlTable& root);
void read_references(TomlTable& root);

ShapePtr read_shape(const TomlValue& value);

/// A number or a formula, in the variables that the table of keys names.
Formula read_formula(const TomlValue& value);
/// Components as numbers or formulas, as many as the scene has dimensions.
std::array<Formula, 3> read_formulas(const TomlValue& value);

/// `spacing` or `spacing_ratio` of a body or wall; the scene's spacing without either.
double read_spacing(TomlTable& table);

/// Names become file names and columns.
void check_name(const TomlTable& table, const std::string& name);

}  // namespace sluice
