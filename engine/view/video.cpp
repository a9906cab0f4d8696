#include "engine/view/video.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>
#include <vector>

#include "engine/base/errors.hpp"
#include "engine/study/child_run.hpp"

namespace sluice {
namespace {

/// Qualities at which particles keep their edges; the pixel format is the one that every player knows.
std::vector<std::string> encoder_words(VideoKind kind) {
    switch (kind) {
        case VideoKind::mp4:
            return {"-c:v", "libx264", "-crf", "18", "-pix_fmt", "yuv420p", "-movflags", "+faststart"};
        case VideoKind::webm:
            return {"-c:v", "libvpx-vp9", "-crf", "28", "-b:v", "0", "-row-mt", "1", "-pix_fmt", "yuv420p"};
    }
    return {};
}

std::string last_line(const std::filesystem::path& file) {
    std::ifstream stream(file);
    std::string line, last;
    while (std::getline(stream, line))
        if (!line.empty()) last = line;
    return last;
}

}  // namespace

std::string_view extension_of(VideoKind kind) {
    switch (kind) {
        case VideoKind::mp4:
            return "mp4";
        case VideoKind::webm:
            return "webm";
    }
    return {};
}

std::optional<VideoKind> video_kind_of(std::string_view extension) {
    for (const VideoKind kind : {VideoKind::mp4, VideoKind::webm})
        if (extension_of(kind) == extension) return kind;
    return std::nullopt;
}

std::optional<std::filesystem::path> find_ffmpeg() {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        const std::filesystem::path file = std::filesystem::path(folder) / "ffmpeg";
        if (::access(file.c_str(), X_OK) == 0) return file;
    }
    return std::nullopt;
}

std::filesystem::path write_video(const std::filesystem::path& ffmpeg, const std::filesystem::path& directory,
                                  VideoKind kind, int frames_per_second) {
    const std::filesystem::path video = directory / fmt::format("movie.{}", extension_of(kind));
    const std::filesystem::path log = directory / "ffmpeg.log";
    std::vector<std::string> words{ffmpeg.string(),
                                   "-y",
                                   "-nostdin",
                                   "-loglevel",
                                   "error",
                                   "-framerate",
                                   fmt::format("{}", frames_per_second),
                                   "-i",
                                   (directory / "frame_%04d.png").string()};
    for (std::string& word : encoder_words(kind)) words.push_back(std::move(word));
    words.push_back(video.string());
    ChildRun child(words, log);
    std::optional<ChildEnd> end;
    while (!(end = child.poll())) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (end->exit_code != 0 || end->signal != 0)
        throw OutputError(fmt::format("{}: ffmpeg failed: {}", video.string(), last_line(log)));
    std::filesystem::remove(log);
    return video;
}

}  // namespace sluice
