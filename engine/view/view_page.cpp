#include "engine/view/view_page.hpp"

#include <fmt/format.h>

#include <fstream>
#include <optional>
#include <sstream>

#include "engine/base/errors.hpp"
#include "engine/files/atomic_file.hpp"
#include "engine/view/run_view.hpp"

namespace sluice {
namespace {

/// zlib's default: level 9 takes 3 times as long for 1 % less.
constexpr int stored_level = 6;

std::string file_text(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// JSON and CSV inside an element: nothing in them may look like its end.
std::string data_element(std::string_view id, std::string_view text) {
    std::string safe;
    for (const char c : text) safe += c == '<' ? std::string("\\u003c") : std::string(1, c);
    return fmt::format("<script type=\"text/plain\" id=\"{}\">{}</script>\n", id, safe);
}

std::string html_text(std::string_view text) {
    std::string safe;
    for (const char c : text) safe += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
    return safe;
}

bool is_taken(std::size_t k, std::size_t count, std::size_t every) { return k % every == 0 || k + 1 == count; }

}  // namespace

std::string page_with(std::string_view title, std::string_view elements) {
    const std::string_view page = page_template();
    constexpr std::string_view mark = "<!--RUN-->";
    const std::size_t at = page.find(mark);
    return fmt::format("{}<title>{} – sluice</title>\n{}{}", page.substr(0, at), html_text(title), elements,
                       page.substr(at + mark.size()));
}

ViewResult write_view_page(const ViewOptions& options, const std::filesystem::path& file) {
    const std::vector<FrameFile> files = list_frames(options.directory);
    ViewResult result;
    std::optional<RunView> view;
    std::string elements;
    for (std::size_t k = 0; k < files.size(); ++k) {
        if (!is_taken(k, files.size(), options.every)) continue;
        std::optional<StoredFrame> frame;
        try {
            frame = read_frame(files[k]);
        } catch (const RunReadError& error) {
            result.left_out.emplace_back(error.what());
            continue;
        }
        if (!view) view.emplace(options.directory, frame->table, options.fields);
        elements += fmt::format("<script type=\"text/plain\" id=\"frame-{}\">", view->frames());
        view->add(*frame);
        elements += base64(view->pack(*frame, stored_level)) + "</script>\n";
    }
    if (!view) throw RunReadError(result.left_out.front());
    elements += data_element("summary", file_text(options.directory / "summary.json")) +
                data_element("probes", file_text(options.directory / "probes.csv"));
    const std::string page =
        page_with(view->folder().title, data_element("run", view->head(PageKind::stored)) + elements);
    write_atomically(file, page);
    result.frames = view->frames();
    result.bytes = page.size();
    result.status = view->folder().status;
    return result;
}

}  // namespace sluice
