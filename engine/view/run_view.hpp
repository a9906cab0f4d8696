// What a page is told of a run before it asks for frames.
#pragma once

#include <string>
#include <vector>

#include "engine/view/field_ranges.hpp"
#include "engine/view/frame_packing.hpp"
#include "engine/view/run_folder.hpp"

namespace sluice {

/// catching_up: live, and more frames are there than could be looked at yet.
enum class PageKind { stored, live, catching_up };

class RunView {
  public:
    /// `first`: the run's first frame that can be read; `fields` as in chosen_fields. Throws RunReadError.
    RunView(const std::filesystem::path& directory, const FrameTable& first, const std::vector<std::string>& fields);

    /// Takes a frame's times and ranges in.
    void add(const StoredFrame& frame);
    std::string pack(const StoredFrame& frame, int level) const;
    std::size_t frames() const { return frames_.size(); }
    const RunFolder& folder() const { return folder_; }

    /// As JSON: title, groups, fields with their ranges, colour maps, times of the frames.
    std::string head(PageKind kind) const;

  private:
    struct Frame {
        double time;
        std::uint64_t step;
        std::size_t particles;
    };
    RunFolder folder_;
    std::vector<std::string> fields_;
    FieldRanges ranges_;
    std::vector<Frame> frames_;
};

}  // namespace sluice
