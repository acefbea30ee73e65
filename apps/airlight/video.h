// A video file of pictures, which ffmpeg makes where it is installed.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "image/png.h"

namespace airlight::cli {

inline constexpr std::string_view video_extensions = ".mp4 .mkv .mov .webm";
bool is_video(const std::filesystem::path& path);

// Fails, with what to do, if ffmpeg is not installed.
Result<Done> can_make_videos();

class Video {
public:
    // Starts ffmpeg for pictures of this size, even in width and height, at `rate` pictures a second. What it complains of goes to standard
    // error. Until close() the file has another name.
    static Result<Video> open(std::filesystem::path file, int width, int height, double rate);
    Video(Video&& other) noexcept;
    Video& operator=(Video&&) = delete;
    ~Video();  // one that was not closed is given up

    // The next picture: red, green and blue, 8 bits. Fails if ffmpeg has ended.
    Result<Done> add(const PngLevels& picture);
    // Waits until the video is whole and has its name. Fails if ffmpeg does.
    Result<Done> close();

private:
    Video(std::filesystem::path file, ::pid_t process, int socket) : file_(std::move(file)), process_(process), socket_(socket) {}
    int wait();
    Error given_up(int code);

    std::filesystem::path file_;
    ::pid_t process_;  // 0: it has ended
    int socket_;       // -1: no picture comes any more
};

}  // namespace airlight::cli
