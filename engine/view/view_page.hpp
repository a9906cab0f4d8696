// One page that holds a run: opened from a disk, it needs nothing else.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sluice {

struct ViewOptions {
    std::filesystem::path directory;  ///< of the run
    std::vector<std::string> fields;  ///< to take along; none = all
    std::size_t every = 1;            ///< of so many frames one is taken, and the last
};

struct ViewResult {
    std::size_t frames = 0, bytes = 0;
    std::string status;                 ///< of the run, as in summary.json
    std::vector<std::string> left_out;  ///< frames that could not be read, and why
};

/// Throws RunReadError, OutputError.
ViewResult write_view_page(const ViewOptions& options, const std::filesystem::path& file);

/// The page without a run, as it is built from engine/view/page; where `<!--RUN-->` stands, a run's elements go.
std::string_view page_template();

/// The page with `elements` in it and a title.
std::string page_with(std::string_view title, std::string_view elements);

}  // namespace sluice
