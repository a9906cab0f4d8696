#include "engine/view/render.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <exception>

#include "engine/base/errors.hpp"
#include "engine/files/atomic_file.hpp"
#include "engine/view/color_map.hpp"
#include "engine/view/field.hpp"

namespace sluice {
namespace {

struct Pictures {
    std::vector<FrameFile> files;
    FieldRanges ranges;
    std::optional<RunFolder> run;
};

/// What there is to draw, and between which values: a look at every frame.
Pictures survey(const RenderOptions& options, RenderResult& result) {
    Pictures pictures;
    const std::vector<FrameFile> files = list_frames(options.directory);
    for (std::size_t k = 0; k < files.size(); k += options.every) {
        try {
            const StoredFrame frame = read_frame(files[k]);
            if (!pictures.run) {
                pictures.run = read_run_folder(options.directory, frame.table);
                for (const ColorOptions& colors : {options.fluid, options.solid})
                    if (!colors.field.empty() && colors.field != "none")
                        chosen_fields(frame.table, pictures.run->dimension, {colors.field});
            }
            pictures.ranges.add(frame.table, pictures.run->dimension);
            pictures.files.push_back(files[k]);
        } catch (const RunReadError& error) {
            if (pictures.files.empty() && pictures.run) throw;  // not the frame's fault
            result.left_out.emplace_back(error.what());
        }
    }
    if (!pictures.run) throw RunReadError(result.left_out.front());
    return pictures;
}

bool has_medium(const RunFolder& run, FrameMedium medium) {
    return std::any_of(run.groups.begin(), run.groups.end(), [&](const auto& g) { return g.medium == medium; });
}

MediumColors colors_of(const Pictures& pictures, const ColorOptions& options, FrameMedium medium) {
    std::string field = options.field;
    if (field.empty()) field = medium == FrameMedium::solid ? "von_mises" : "speed";
    if (field == "none" || !has_medium(*pictures.run, medium)) return {};
    MediumColors colors = suited_colors(pictures.ranges, field == "velocity" ? "speed" : field, medium);
    if (!options.map.empty()) colors.map = color_map(options.map).name;
    if (options.range) std::tie(colors.low, colors.high) = *options.range;
    return colors;
}

void remove_old_pictures(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> old;
    for (const auto& file : std::filesystem::directory_iterator(folder)) {
        const std::string name = file.path().filename().string();
        if (name.starts_with("frame_") && name.ends_with(".png")) old.push_back(file.path());
    }
    for (const auto& file : old) std::filesystem::remove(file);
}

}  // namespace

RenderResult render_run(const RenderOptions& options) {
    RenderResult result;
    const Pictures pictures = survey(options, result);
    PictureStyle style = options.style;
    style.colors[0] = colors_of(pictures, options.fluid, FrameMedium::fluid);
    style.colors[1] = colors_of(pictures, options.solid, FrameMedium::solid);
    make_folder(options.output);
    remove_old_pictures(options.output);
    // The HDF5 library reads for one thread at a time; drawing and compressing take the time.
    std::exception_ptr problem;
#pragma omp parallel for schedule(dynamic)
    for (std::size_t k = 0; k < pictures.files.size(); ++k) {
        try {
            StoredFrame frame;
#pragma omp critical(sluice_read_frame)
            frame = read_frame(pictures.files[k]);
            write_atomically(options.output / fmt::format("frame_{:04}.png", k),
                             frame_picture(frame, *pictures.run, pictures.ranges.bounds(), style));
        } catch (...) {
#pragma omp critical(sluice_render_problem)
            problem = std::current_exception();
        }
    }
    if (problem) std::rethrow_exception(problem);
    result.frames = pictures.files.size();
    return result;
}

}  // namespace sluice
