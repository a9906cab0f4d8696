#include "engine/command/thread_settings.hpp"

#include <omp.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace sluice {
namespace {

bool user_has_set_some() {
    return std::getenv("GOMP_SPINCOUNT") || std::getenv("OMP_WAIT_POLICY") || std::getenv("OMP_PROC_BIND") ||
           std::getenv("GOMP_CPU_AFFINITY") || std::getenv("OMP_PLACES");
}

/// The words that this program was started with.
std::vector<std::string> command_line() {
    std::ifstream file("/proc/self/cmdline");
    std::vector<std::string> words;
    for (std::string word; std::getline(file, word, '\0');) words.push_back(word);
    return words;
}

}  // namespace

void use_thread_settings([[maybe_unused]] int threads) {
#if defined(__linux__) && defined(__GNUC__) && !defined(__clang__)
    const int processors = omp_get_num_procs();
    if (threads == 0) threads = omp_get_max_threads();
    if (threads == 1 || user_has_set_some()) return;
    std::vector<std::string> words = command_line();
    if (words.empty()) return;
    const bool bind = threads == processors;
    setenv("GOMP_SPINCOUNT", bind ? "10000" : "1000", 0);  // a tenth or a hundredth of a millisecond
    if (bind) setenv("OMP_PROC_BIND", "true", 0);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execv("/proc/self/exe", arguments.data());
#endif
}

}  // namespace sluice
