#include "engine/scene/read/number_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string_view>

namespace sluice {
namespace {

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blank = " \t\r";
    const std::size_t first = text.find_first_not_of(blank);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::vector<std::string_view> cells_of(std::string_view line) {
    std::vector<std::string_view> cells;
    for (std::size_t start = 0; start <= line.size();) {
        const std::size_t end = std::min(line.find(',', start), line.size());
        cells.push_back(trimmed(line.substr(start, end - start)));
        start = end + 1;
    }
    return cells;
}

/// None if the cell is no number; NaN if it is empty.
std::optional<double> number_in(std::string_view cell) {
    if (cell.empty()) return std::numeric_limits<double>::quiet_NaN();
    double value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc{} || end != cell.data() + cell.size()) return std::nullopt;
    return value;
}

void add_row(NumberTable& table, const std::vector<std::string_view>& cells, const std::string& place) {
    if (cells.size() != table.names.size())
        throw std::runtime_error(
            fmt::format("{}: found {} values, expected {}", place, cells.size(), table.names.size()));
    for (std::size_t k = 0; k < cells.size(); ++k) {
        const std::optional<double> value = number_in(cells[k]);
        if (!value) throw std::runtime_error(fmt::format("{}: found \"{}\", expected a number", place, cells[k]));
        table.columns[k].push_back(*value);
    }
}

}  // namespace

std::optional<std::size_t> NumberTable::find(const std::string& name) const {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return static_cast<std::size_t>(found - names.begin());
}

NumberTable read_number_table(const std::filesystem::path& path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error(fmt::format("{}: cannot be read: {}", path.string(), std::strerror(errno)));
    return read_number_table(file, path.string());
}

NumberTable read_number_table(std::istream& lines, const std::string& name) {
    NumberTable table;
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        if (trimmed(line).empty() || trimmed(line).front() == '#') continue;
        const std::vector<std::string_view> cells = cells_of(line);
        if (!table.names.empty()) {
            add_row(table, cells, fmt::format("{}:{}", name, number));
            continue;
        }
        table.names.assign(cells.begin(), cells.end());
        table.columns.resize(cells.size());
    }
    if (table.names.empty())
        throw std::runtime_error(fmt::format("{}: found no line, expected a heading and rows", name));
    return table;
}

}  // namespace sluice
