#include "engine/study/run_store.hpp"

#include <fmt/format.h>

#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/base/text_hash.hpp"
#include "engine/files/atomic_file.hpp"

namespace sluice {
namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// The last line that says something, without the blanks around it.
std::string last_line(const std::string& text) {
    const std::size_t end = text.find_last_not_of(" \t\r\n");
    if (end == std::string::npos) return "";
    const std::size_t line = text.find_last_of("\r\n", end);
    const std::size_t start = text.find_first_not_of(" \t\r\n", line == std::string::npos ? 0 : line);
    return text.substr(start, end + 1 - start);
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

// Exit codes of `sluice run` (command/exit_code.hpp) that say something about the scene; all others about the machine.
constexpr int numerical_failure = 1, bad_input = 2;

}  // namespace

std::string failure_reason(const ChildEnd& end, const std::filesystem::path& folder) {
    const std::string log = text_of(folder / log_name);
    if (end.signal != 0) {
        const std::string words = last_line(log);
        return fmt::format("ended by signal {} ({}){}{}", end.signal, ::strsignal(end.signal),
                           words.empty() ? "" : "; last words: ", words);
    }
    const std::string mark = "sluice: error: ";
    const std::size_t at = log.rfind(mark);
    if (at != std::string::npos) return first_line(log.substr(at + mark.size()));
    return fmt::format("exit code {}", end.exit_code);
}

std::optional<RunResult> result_of_end(const ChildEnd& end, const std::filesystem::path& folder) {
    const bool stands =
        end.signal == 0 && (end.exit_code == 0 || end.exit_code == numerical_failure || end.exit_code == bad_input);
    if (!stands) return std::nullopt;
    const bool failed = end.exit_code != 0;
    return RunResult{failed, failed ? failure_reason(end, folder) : "", end.cpu, end.wall, ""};
}

std::optional<RunResult> load_result(const std::filesystem::path& folder) {
    const Json json = Json::parse(text_of(folder / "result.json"), nullptr, false);
    if (!json.is_object()) return std::nullopt;
    RunResult result;
    result.failed = json.value("failed", true);
    result.reason = json.value("reason", "");
    result.cpu = json.value("cpu_seconds", 0.0);
    result.wall = json.value("wall_seconds", 0.0);
    result.build = json.value("build", "");
    return result;
}

void store_result(const std::filesystem::path& folder, const RunResult& result) {
    const Json json = {{"failed", result.failed},
                       {"reason", result.reason},
                       {"cpu_seconds", result.cpu},
                       {"wall_seconds", result.wall},
                       {"build", result.build}};
    write_atomically(folder / "result.json", json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::string build_of(const std::filesystem::path& program) { return text_hash(text_of(program)); }

}  // namespace sluice
