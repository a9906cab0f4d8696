// Every way in which a pass can run, and everything that it can run on.
#pragma once

#include <string>

#include "kernels/pairs/block_loop.hpp"
#include "tests/catch.hpp"
#include "tests/kernels/particles.hpp"

namespace sluice {

/// run(precision) on every instruction set in both precisions, on one thread unless it says otherwise.
template <class Run>
void in_all_variants(Run&& run) {
    const ThreadScope threads(1);
    for (const Isa isa : available_isas()) {
        const IsaScope scope(isa);
        for (const Precision precision : {Precision::full, Precision::mixed}) {
            CAPTURE(std::string(name_of(isa)), precision == Precision::mixed);
            run(precision);
        }
    }
}

/// run(particles, list) on every scene in both layouts.
template <int Dim, class Run>
void in_all_scenes(unsigned seed, Run&& run) {
    for (const Scene scene : scenes)
        for (const Layout layout : layouts) {
            const auto p = make_scene<Dim>(scene, seed, layout);
            CAPTURE(static_cast<int>(scene), layout == Layout::sorted);
            run(p, list_of(p));
        }
}

}  // namespace sluice
