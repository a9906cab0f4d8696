// A page that follows a run while it goes on, given out to this machine alone.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "engine/view/run_view.hpp"

namespace sluice {

/// A run's frames as they are known so far. Calls may come from several threads.
class LiveRun {
  public:
    /// Throws RunReadError for a folder without a frame that can be read, and for unknown fields.
    LiveRun(std::filesystem::path directory, std::vector<std::string> fields);

    /// Looks for new frames, for half a second at the most, and says what is known, as RunView::head does.
    std::string head();
    /// Packed; none if there is no such frame. Throws RunReadError.
    std::optional<std::string> frame(std::size_t index);
    std::string title();
    const std::filesystem::path& directory() const { return directory_; }

  private:
    /// Whether more frames wait.
    bool scan();
    void restart();

    std::filesystem::path directory_;
    std::vector<std::string> fields_;
    std::mutex mutex_;  ///< also of the HDF5 library, which knows no threads
    std::optional<RunView> view_;
    std::vector<FrameFile> scanned_;   ///< of the run's list
    std::vector<FrameFile> readable_;  ///< those of them that could be read: what the page counts
};

/// Serves until the program is ended. `port` 0: any that is free. `started` is told the address. Throws OutputError if
/// the port cannot be used.
void serve_run(LiveRun& run, int port, const std::function<void(const std::string&)>& started);

}  // namespace sluice
