#include "engine/study/child_run.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <system_error>

#include "engine/base/errors.hpp"

namespace sluice {
namespace {

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

double seconds(const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); }

/// Between fork and exec only what is safe after a fork of a program with threads.
[[noreturn]] void become(char* const* words, int log) {
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);  // a killed study leaves no run behind
    ::dup2(log, STDOUT_FILENO);
    ::dup2(log, STDERR_FILENO);
    ::execv(words[0], words);
    ::_exit(127);  // as shells say that a program cannot be started
}

}  // namespace

ChildRun::ChildRun(const std::vector<std::string>& words, const std::filesystem::path& log) : start_(now()) {
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0)
        throw OutputError(fmt::format("{}: cannot create: {}", log.string(), std::generic_category().message(errno)));
    process_ = ::fork();
    if (process_ == 0) become(arguments.data(), file);
    const int error = errno;
    ::close(file);
    if (process_ < 0)
        throw OutputError(fmt::format("{}: cannot be started: {}", words[0], std::generic_category().message(error)));
}

ChildRun::~ChildRun() {
    if (process_ > 0) stop();
}

std::optional<ChildEnd> ChildRun::wait(int options) {
    int status = 0;
    rusage usage{};
    pid_t found = -1;
    do {
        found = ::wait4(process_, &status, options, &usage);
    } while (found < 0 && errno == EINTR);
    if (found == 0) return std::nullopt;
    process_ = -1;
    ChildEnd end;
    end.wall = now() - start_;
    end.cpu = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    if (WIFSIGNALED(status))
        end.signal = WTERMSIG(status);
    else
        end.exit_code = WEXITSTATUS(status);
    return end;
}

std::optional<ChildEnd> ChildRun::poll() { return wait(WNOHANG); }

ChildEnd ChildRun::stop() {
    ::kill(process_, SIGTERM);
    return *wait(0);
}

std::filesystem::path own_program() { return std::filesystem::read_symlink("/proc/self/exe"); }

}  // namespace sluice
