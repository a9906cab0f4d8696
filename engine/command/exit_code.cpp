#include "engine/command/exit_code.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <new>
#include <string>
#include <system_error>

#include "engine/base/errors.hpp"
#include "engine/scene/scene.hpp"

namespace sluice {

void print_error(std::string_view message) { print_note(fmt::format("error: {}", message)); }
void print_warning(std::string_view message) { print_note(fmt::format("warning: {}", message)); }
void print_note(std::string_view message) { std::fputs(fmt::format("sluice: {}\n", message).c_str(), stderr); }

void print(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) return;
    throw OutputError("standard output: cannot write: " + std::generic_category().message(errno));
}

ExitCode guarded(const std::function<ExitCode()>& deed) {
    try {
        return deed();
    } catch (const SceneError& error) {
        print_error(error.what());
        return ExitCode::bad_input;
    } catch (const CheckpointError& error) {
        print_error(error.what());
        return ExitCode::bad_input;
    } catch (const RunReadError& error) {
        print_error(error.what());
        return ExitCode::bad_input;
    } catch (const NumericalError& error) {
        print_error(error.what());
        return ExitCode::numerical_failure;
    } catch (const OutputError& error) {
        print_error(error.what());
        return ExitCode::output_failure;
    } catch (const std::filesystem::filesystem_error& error) {
        print_error(error.what());
        return ExitCode::output_failure;
    } catch (const std::bad_alloc&) {
        print_error("out of memory; a larger [method] spacing needs less");
        return ExitCode::output_failure;
    }
}

}  // namespace sluice
