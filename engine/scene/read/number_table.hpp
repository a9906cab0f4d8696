// Tables of numbers in files: CSV with a heading.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace sluice {

struct NumberTable {
    std::vector<std::string> names;
    std::vector<std::vector<double>> columns;  ///< as long as each other; NaN where the file has nothing

    std::size_t rows() const { return columns.empty() ? 0 : columns[0].size(); }
    std::optional<std::size_t> find(const std::string& name) const;
};

/// Reads comma-separated columns; lines that start with # are comments. Throws std::runtime_error: "PATH:LINE: found …,
/// expected …".
NumberTable read_number_table(const std::filesystem::path& path);
/// The same from any lines; `name` is for messages.
NumberTable read_number_table(std::istream& lines, const std::string& name);

}  // namespace sluice
