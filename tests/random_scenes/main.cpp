// Tries made-up scenes.
//   random_scenes FIRST COUNT    scenes of so many seeds; exit code 1 if one fails
//   random_scenes SEED           one, and what came of it
//   random_scenes --print SEED   its text
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "tests/random_scenes/generator.hpp"
#include "tests/random_scenes/trial.hpp"

namespace random_scenes {
namespace {

constexpr const char* names[]{"ran", "refused", "broke down", "FAILED"};

/// A scene without nonsense has a stable step, and so no reason to break down.
Verdict judged(std::uint64_t seed) {
    Verdict verdict = try_scene(seed);
    if (verdict.outcome == Outcome::broke_down && !make_scene(seed).wild) verdict.outcome = Outcome::failed;
    return verdict;
}

int try_range(std::uint64_t first, std::uint64_t count, bool tell_all) {
    std::vector<int> outcomes(std::size(names));
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        const Verdict verdict = judged(seed);
        const auto outcome = static_cast<std::size_t>(verdict.outcome);
        ++outcomes[outcome];
        if (!tell_all && verdict.outcome != Outcome::failed) continue;
        std::printf("seed %llu %s: %s\n", static_cast<unsigned long long>(seed), names[outcome],
                    verdict.message.c_str());
        std::fflush(stdout);
    }
    for (std::size_t k = 0; k < outcomes.size(); ++k)
        std::printf("%d %s%s", outcomes[k], names[k], k < 3 ? ", " : "\n");
    const int failed = outcomes[static_cast<std::size_t>(Outcome::failed)];
    // Of those that are made up a good part can run: a reader that refuses all of them is no sound one.
    if (count >= 20 && outcomes[static_cast<std::size_t>(Outcome::ran)] < static_cast<int>(count / 5)) {
        std::printf("hardly any of them ran\n");
        return 1;
    }
    if (failed > 0) std::printf("replay with `random_scenes SEED`; `random_scenes --print SEED` shows the scene\n");
    return failed > 0 ? 1 : 0;
}

}  // namespace
}  // namespace random_scenes

int main(int count, char** arguments) {
    const auto number = [&](int k) { return std::strtoull(arguments[k], nullptr, 10); };
    if (count == 3 && std::string(arguments[1]) == "--print") {
        std::fputs(random_scenes::make_scene(number(2)).text.c_str(), stdout);
        return 0;
    }
    if (count == 2) return random_scenes::try_range(number(1), 1, true);
    if (count >= 3) return random_scenes::try_range(number(1), number(2), count > 3);
    std::fputs("usage: random_scenes FIRST COUNT | SEED | --print SEED\n", stderr);
    return 2;
}
