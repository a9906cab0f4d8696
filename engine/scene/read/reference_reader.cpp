#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "engine/scene/formula.hpp"
#include "engine/scene/probe_columns.hpp"
#include "engine/scene/read/number_table.hpp"
#include "engine/scene/read/reader_parts.hpp"
#include "engine/scene/table/suggestion.hpp"

namespace sluice {
namespace {

std::string read_column(const TomlValue& value) {
    std::vector<std::string> columns;
    for (const Probe& probe : value.scene().probes)
        for (std::string& column : probe_columns(probe, value.scene().dimension)) columns.push_back(std::move(column));
    if (columns.empty()) value.fail("found it in a scene without probes, expected a column of one");
    return columns[value.name(columns)];
}

std::size_t find_column(const NumberTable& table, const TomlValue& value) {
    const std::string name = value.text();
    const auto found = table.find(name);
    if (!found)
        value.fail(
            fmt::format("found \"{}\", expected {}{}", name, one_of(table.names), did_you_mean(name, table.names)));
    return *found;
}

/// The mean of the cells that the row has; NaN without any.
double mean_of_row(const NumberTable& table, const std::vector<std::size_t>& columns, std::size_t row) {
    double sum = 0;
    int count = 0;
    for (const std::size_t k : columns) {
        if (std::isnan(table.columns[k][row])) continue;
        sum += table.columns[k][row];
        ++count;
    }
    return sum / count;
}

/// A scene and its tables travel together, and a scene from elsewhere must not read what else there is.
std::filesystem::path path_beside_scene(const TomlValue& value) {
    const std::filesystem::path path = value.text(), normal = path.lexically_normal();
    if (path.empty() || path.is_absolute() || *normal.begin() == "..")
        value.reject("a path that starts at the scene's folder and stays in it");
    return std::filesystem::path(value.scene().file).parent_path() / path;
}

NumberTable read_file(const TomlValue& value) {
    const std::filesystem::path path = path_beside_scene(value);
    try {
        return read_number_table(path);
    } catch (const std::runtime_error& error) {
        value.fail(error.what());
    }
}

/// table = {file = "reference.csv", time = "t", values = ["first", "second"], factor = 0.001}
void read_table(const TomlValue& value, Reference& reference) {
    TomlTable keys(value);
    const TomlValue file = keys.get("file");
    reference.table_file = file.text();
    const NumberTable table = read_file(file);
    const std::size_t time = find_column(table, keys.get("time"));
    std::vector<std::size_t> columns;
    const TomlValue values = keys.get("values");
    for (const TomlValue& name : values.items()) columns.push_back(find_column(table, name));
    if (columns.empty()) values.fail("found no column, expected one or more, of which the mean is taken");
    double factor = 1;
    if (const auto v = keys.get("factor")) factor = v.number();
    keys.finish();
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const double t = table.columns[time][row], f = factor * mean_of_row(table, columns, row);
        if (std::isnan(t) || std::isnan(f)) continue;
        if (!reference.time.empty() && !(t > reference.time.back()))
            file.fail(fmt::format("found t = {} s after {} s, expected rising times", t, reference.time.back()));
        reference.time.push_back(t);
        reference.value.push_back(f);
    }
    if (reference.time.size() < 2) file.fail("found fewer than two rows with values, expected two or more");
}

void read_truth(TomlTable& table, Reference& reference) {
    const TomlValue formula = table.get("formula"), rows = table.get("table"), number = table.get("value");
    if (formula && rows) rows.fail("found it beside formula, expected one of formula, table and value");
    if (number && (formula || rows))
        number.fail(
            fmt::format("found it beside {}, expected one of formula, table and value", formula ? "formula" : "table"));
    if (formula) {
        reference.formula = read_formula(formula);
    }
    if (rows) read_table(rows, reference);
    if (!number) return;
    if (is_pointwise(reference.measure))
        number.fail(
            fmt::format("found one number for a measure of a whole curve, expected a formula or a table, or "
                        "another measure than {}",
                        word_of(reference.measure)));
    reference.number = number.number();
}

Reference read_reference(TomlTable& table, const std::string& name) {
    check_name(table, name);
    Reference reference;
    reference.name = name;
    reference.column = read_column(table.get("probe"));
    if (const auto v = table.get("measure")) reference.measure = v.choice<Measure>();
    read_truth(table, reference);
    if (const auto v = table.get("from")) reference.from = v.number();
    if (const auto v = table.get("to")) {
        reference.to = v.number();
        if (!(*reference.to > reference.from))
            v.fail(fmt::format("found {}, expected a time after from = {}", *reference.to, reference.from));
    }
    const TomlValue scale = table.get("scale");
    if (scale) reference.scale = scale.number();
    if (reference.number == 0.0 && !scale)
        table.fail("found a value of 0 without a scale, expected the scale that relative errors refer to");
    if (const auto v = table.get("uncertainty")) reference.uncertainty = v.number();
    if (const auto v = table.get("source")) reference.source = v.text();
    table.finish();
    return reference;
}

}  // namespace

void read_references(TomlTable& root) {
    const TomlValue value = root.get("reference");
    if (!value) return;
    TomlTable all(value);
    for (const std::string& name : all.keys()) {
        TomlTable table(all.get(name));
        root.scene().references.push_back(read_reference(table, name));
    }
}

}  // namespace sluice
