// How the program ends, and the one way in which it reports an error.
#pragma once

#include <functional>
#include <string_view>

namespace sluice {

enum class ExitCode {
    done = 0,
    numerical_failure = 1,
    bad_input = 2,
    output_failure = 3,  ///< a file could not be written, or memory ran out
    interrupted = 130,   ///< 128 + SIGINT, as shells have it
};

/// `sluice: error: …` on stderr.
void print_error(std::string_view message);
/// `sluice: warning: …` and `sluice: …` on stderr.
void print_warning(std::string_view message);
void print_note(std::string_view message);

/// Writes to stdout. Throws OutputError if that fails: a report to a full disk must not pass as success.
void print(std::string_view text);

/// Runs `deed`; an exception becomes a message and an exit code.
ExitCode guarded(const std::function<ExitCode()>& deed);

}  // namespace sluice
