#include "tests/random_scenes/trial.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstring>
#include <regex>
#include <utility>

#include "engine/base/errors.hpp"
#include "engine/geometry/packing.hpp"
#include "engine/particles/particle_set.hpp"
#include "engine/run/checkpoint/checkpoint_file.hpp"
#include "engine/run/output/probes.hpp"
#include "engine/run/run.hpp"
#include "engine/run/watch/watch.hpp"
#include "engine/scene/check/checks.hpp"
#include "engine/simulation/simulation.hpp"
#include "tests/engine/lattice_sites.hpp"
#include "tests/engine/temporary_folder.hpp"
#include "tests/random_scenes/generator.hpp"

namespace random_scenes {
namespace {

using namespace sluice;

constexpr int steps = 100;
constexpr double most_sites = 20000;
/// Long enough for any scene in any build; a hang is longer.
constexpr unsigned patience = 120;
/// A scene whose steps are long for a reason need not take all of them. [s]
constexpr double enough = 5;
/// As for a user with a small machine. Sanitizers reserve more.
constexpr rlim_t memory = rlim_t{2} << 30;

const std::string file = "made_up.toml";

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif
#else
constexpr bool sanitized = false;
#endif

struct Broken : std::runtime_error {
    using std::runtime_error::runtime_error;
};

void demand(bool holds, const std::string& what) {
    if (!holds) throw Broken(what);
}

template <int Dim>
void append_bytes(const ParticleSet<Dim>& set, std::string& bytes) {
    for_each_array(set, [&](const ColumnInfo&, const auto& column) {
        bytes.append(reinterpret_cast<const char*>(column.data()), column.size() * sizeof(column[0]));
    });
}

template <int Dim>
std::string bytes_of(const Simulation<Dim>& simulation) {
    std::string bytes;
    append_bytes(simulation.fluid(), bytes);
    append_bytes(simulation.solid(), bytes);
    append_bytes(simulation.boundary(), bytes);
    return bytes;
}

/// Where the watch found nothing, all is finite.
template <int Dim>
void demand_finite(const ParticleSet<Dim>& phase) {
    for (std::size_t i = 0; i < phase.owned; ++i)
        demand(std::isfinite(norm2(phase.position[i])) && std::isfinite(norm2(phase.velocity[i])) &&
                   std::isfinite(phase.density[i]) && std::isfinite(phase.pressure[i]),
               fmt::format("particle {} is not finite, and the watch did not see it", phase.id[i]));
}

template <int Dim>
void advance(Simulation<Dim>& simulation, int by) {
    const auto start = std::chrono::steady_clock::now();
    for (int step = 0; step < by; ++step) {
        simulation.step();
        if (std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > enough) return;
    }
}

template <int Dim>
void simulate(const Scene& scene) {
    Simulation<Dim> simulation(scene);
    Watch<Dim> watch(simulation);
    const Probes<Dim> probes(simulation);
    for (int part = 0; part < 2; ++part) {
        advance(simulation, steps / 2);
        watch.look(simulation);
        demand_finite<Dim>(simulation.fluid());
        demand_finite<Dim>(simulation.solid());
        demand(probes.sample(simulation).size() == probes.columns().size(), "a probe without a value");
    }
    for (const std::string& news : watch.take_news()) demand(news.size() > 20, "a warning that says nothing: " + news);
}

/// Stopped and gone on with, it is the same run.
template <int Dim>
void resume(const Scene& scene) {
    constexpr int few = 15;
    Simulation<Dim> whole(scene), second(scene);
    for (int step = 0; step < few; ++step) whole.step();
    const CheckpointImage image([&](const StateWriter& writer) { whole.save(writer); });
    second.restore(image.reader());
    for (int step = 0; step < few; ++step) whole.step(), second.step();
    demand(bytes_of(whole) == bytes_of(second), "a resumed run is another one");
}

template <int Dim>
void run_to_folder(const Scene& scene) {
    const double dt = Simulation<Dim>(scene).time_step();
    const TemporaryFolder folder;
    RunOptions options;
    options.directory = folder.path() / "run";
    options.threads = 2;
    options.until = 30 * dt;
    const RunStatus status = run(scene, options);
    demand(!text_of(options.directory / "summary.json").empty(), "a run without a summary");
    if (status.state == RunState::failed) throw NumericalError(status.message);
}

template <int Dim>
void exercise(const Scene& scene, std::uint64_t seed) {
    if (seed % 4 == 0) return run_to_folder<Dim>(scene);
    if (seed % 4 == 1) resume<Dim>(scene);
    simulate<Dim>(scene);
}

/// "file:line: key: message", or "file:line:column: message" for what is no TOML.
void demand_guidance(const std::string& message) {
    static const std::regex place(file + R"(:\d+(: [^: ]+: |:\d+: )[^]{10,})");
    demand(std::regex_match(message, place), "a refusal without file, line and key: " + message);
}

Verdict tried_here(std::uint64_t seed) {
    try {
        const Scene scene = parse_scene(make_scene(seed).text, file);
        demand(parse_scene(scene.source, file).source == scene.source, "its own text reads as another scene");
        if (!(lattice_sites(scene) <= most_sites)) {
            check_geometry(scene, pack_bodies(scene), pack_walls(scene));
            return {Outcome::ran, "too large to run here"};
        }
        if (scene.dimension == 2)
            exercise<2>(scene, seed);
        else
            exercise<3>(scene, seed);
        return {Outcome::ran, ""};
    } catch (const SceneError& error) {
        demand_guidance(error.what());
        return {Outcome::refused, error.what()};
    } catch (const NumericalError& error) {
        demand(std::string(error.what()).find(';') != std::string::npos,
               "a breakdown without a remedy: " + std::string(error.what()));
        return {Outcome::broke_down, error.what()};
    }
}

[[noreturn]] void try_and_tell(std::uint64_t seed, int to) {
    if (!sanitized) {
        const rlimit limit{memory, memory};
        ::setrlimit(RLIMIT_AS, &limit);
    }
    ::alarm(patience);
    Verdict verdict;
    try {
        verdict = tried_here(seed);
    } catch (const std::exception& error) {
        verdict.message = error.what();
    }
    const std::string text = std::to_string(static_cast<int>(verdict.outcome)) + verdict.message;
    // What does not fit into the pipe is not worth reading.
    const ssize_t written = ::write(to, text.data(), std::min<std::size_t>(text.size(), 4000));
    std::_Exit(written < 0);
}

std::string how_it_ended(int status) {
    if (WIFSIGNALED(status))
        return WTERMSIG(status) == SIGALRM ? "hung" : fmt::format("crashed: {}", ::strsignal(WTERMSIG(status)));
    return fmt::format("ended with exit code {}", WEXITSTATUS(status));
}

}  // namespace

Verdict try_scene(std::uint64_t seed) {
    int ends[2];
    if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("no process");
    if (child == 0) try_and_tell(seed, ends[1]);
    ::close(ends[1]);
    std::string text;
    std::array<char, 4096> piece;
    for (ssize_t n = 0; (n = ::read(ends[0], piece.data(), piece.size())) > 0;)
        text.append(piece.data(), static_cast<std::size_t>(n));
    ::close(ends[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    if (text.empty() || status != 0) return {Outcome::failed, how_it_ended(status)};
    return {static_cast<Outcome>(text[0] - '0'), text.substr(1)};
}

}  // namespace random_scenes
