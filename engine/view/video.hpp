// Numbered pictures made into a video by ffmpeg.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace sluice {

enum class VideoKind { mp4, webm };

/// Of files, without the dot.
std::string_view extension_of(VideoKind kind);
/// The kind of files of this extension; none without one.
std::optional<VideoKind> video_kind_of(std::string_view extension);

/// Where ffmpeg is; none if it is not installed.
std::optional<std::filesystem::path> find_ffmpeg();

/// From DIRECTORY/frame_0000.png, frame_0001.png …: the file movie.mp4 or movie.webm there, which is returned. Throws
/// OutputError with what ffmpeg said last.
std::filesystem::path write_video(const std::filesystem::path& ffmpeg, const std::filesystem::path& directory,
                                  VideoKind kind, int frames_per_second);

}  // namespace sluice
