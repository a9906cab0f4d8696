// A run's folder made by hand: particles on a lattice that moves, in few frames.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include "engine/files/atomic_file.hpp"
#include "engine/run/output/frames.hpp"

namespace sluice {

/// side² particles in 2D, side³ in 3D; the last column of each row is a wall, without a density.
inline FrameTable lattice_table(int dimension, int side, double shift) {
    FrameTable table;
    table.scalars = {{"pressure", {}}, {"density", {}}};
    const int layers = dimension == 3 ? side : 1;
    std::uint32_t fluid = 0, walls = 0;
    for (const bool wall : {false, true})  // as runs write them: medium by medium
        for (int k = 0; k < layers; ++k)
            for (int j = 0; j < side; ++j)
                for (int i = 0; i < side; ++i) {
                    if ((i == side - 1) != wall) continue;
                    const double x[3] = {0.1 * i + shift, 0.1 * j - 0.3, 0.1 * k};
                    for (int axis = 0; axis < 3; ++axis) {
                        table.points.push_back(static_cast<float>(axis < dimension ? x[axis] : 0.0));
                        table.velocity.push_back(axis < dimension ? static_cast<float>(std::sin(3 * x[axis])) : 0.0F);
                    }
                    table.scalars[0].value.push_back(static_cast<float>(1000 * std::cos(7 * x[0])));
                    table.scalars[1].value.push_back(wall ? std::numeric_limits<float>::quiet_NaN()
                                                          : static_cast<float>(1000 + x[1]));
                    table.medium.push_back(static_cast<std::uint8_t>(wall ? FrameMedium::wall : FrameMedium::fluid));
                    table.body.push_back(0);
                    table.id.push_back(wall ? walls++ : fluid++);
                    ++table.particles;
                }
    return table;
}

/// Frames at t = 0, 0.1 s …, with the list of them, and nothing else.
inline void write_lattice_run(const std::filesystem::path& directory, int dimension, int frames) {
    make_folder(directory / "frames");
    std::string list;
    for (int k = 0; k < frames; ++k) {
        const std::string name = fmt::format("frame_{:04}.hdf", k);
        write_frame(directory / "frames" / name, lattice_table(dimension, 4, 0.02 * k),
                    {0.1 * k, static_cast<std::uint64_t>(10 * k), "lattice"});
        list += fmt::format(R"({}{{"name":"{}","time":{}}})", k ? "," : "", name, 0.1 * k);
    }
    write_atomically(directory / "frames" / "frames.hdf.series",
                     R"({"file-series-version":"1.0","files":[)" + list + "]}");
}

}  // namespace sluice
