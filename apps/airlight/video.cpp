#include "video.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <utility>
#include <vector>

#include "core/files.h"

namespace airlight::cli {

namespace {

Error no_ffmpeg() {
    return {"ffmpeg", "it makes videos, and is not installed",
            "Install it (Debian: apt install ffmpeg), or write the pictures into a folder: -o frames/."};
}

// "flight.mp4" while it grows: ffmpeg takes the kind of file from the extension.
std::filesystem::path unfinished(const std::filesystem::path& file) {
    return file.parent_path() / (file.stem().string() + ".part" + file.extension().string());
}

// Colours as displays of high definition take them: BT.709, and sRGB's curve. `file:` keeps names with a colon or a dash names.
std::vector<std::string> words_of(const std::filesystem::path& file, int width, int height, double rate) {
    return {"ffmpeg",
            "-loglevel",
            "error",
            "-y",
            "-f",
            "rawvideo",
            "-pixel_format",
            "rgb24",
            "-video_size",
            fmt::format("{}x{}", width, height),
            "-framerate",
            fmt::format("{}", rate),
            "-i",
            "pipe:0",
            "-vf",
            "scale=out_color_matrix=bt709",
            "-pix_fmt",
            "yuv420p",
            "-colorspace",
            "bt709",
            "-color_primaries",
            "bt709",
            "-color_trc",
            "iec61966-2-1",
            "file:" + file.string()};
}

// Starts a program of PATH whose standard input is `input`, with no signal blocked; 0 where it cannot be started.
::pid_t spawn(std::vector<std::string> words, int input) {
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    posix_spawnattr_t attributes;
    ::posix_spawnattr_init(&attributes);
    sigset_t none;
    sigemptyset(&none);
    ::posix_spawnattr_setsigmask(&attributes, &none);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
    ::pid_t process = 0;
    if (::posix_spawnp(&process, arguments[0], &actions, &attributes, arguments.data(), environ) != 0) process = 0;
    ::posix_spawnattr_destroy(&attributes);
    ::posix_spawn_file_actions_destroy(&actions);
    return process;
}

}  // namespace

bool is_video(const std::filesystem::path& path) {
    std::istringstream extensions{std::string(video_extensions)};
    for (std::string extension; extensions >> extension;)
        if (path.extension() == extension) return true;
    return false;
}

Result<Done> can_make_videos() {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (::access((std::filesystem::path(folder) / "ffmpeg").c_str(), X_OK) == 0) return Done{};
    return no_ffmpeg();
}

Result<Video> Video::open(std::filesystem::path file, int width, int height, double rate) {
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return Error{"ffmpeg", std::strerror(errno), ""};
    const ::pid_t process = spawn(words_of(unfinished(file), width, height, rate), ends[1]);
    ::close(ends[1]);
    if (process != 0) return Video(std::move(file), process, ends[0]);
    ::close(ends[0]);
    return no_ffmpeg();
}

Video::Video(Video&& other) noexcept
    : file_(std::move(other.file_)), process_(std::exchange(other.process_, 0)), socket_(std::exchange(other.socket_, -1)) {}

Video::~Video() {
    if (process_ == 0) return;
    ::kill(process_, SIGTERM);
    wait();
    std::error_code absent;
    std::filesystem::remove(unfinished(file_), absent);
}

Result<Done> Video::add(const PngLevels& picture) {
    std::vector<std::uint8_t> bytes(picture.levels.size());
    std::ranges::transform(picture.levels, bytes.begin(), [](std::uint16_t level) { return static_cast<std::uint8_t>(level); });
    for (std::size_t sent = 0; sent < bytes.size();) {
        // A pipe would end this program by a signal where ffmpeg has ended.
        const ssize_t more = ::send(socket_, &bytes[sent], bytes.size() - sent, MSG_NOSIGNAL);
        if (more < 0 && errno == EINTR) continue;
        if (more < 0) return given_up(wait());
        sent += static_cast<std::size_t>(more);
    }
    return Done{};
}

// Its exit code.
int Video::wait() {
    ::close(std::exchange(socket_, -1));
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

Error Video::given_up(int code) {
    std::error_code absent;
    std::filesystem::remove(unfinished(file_), absent);
    return {file_.string(), fmt::format("ffmpeg made no video: it ended with exit code {}", code),
            "What it complains of stands above. The pictures are kept: the same command tries again."};
}

Result<Done> Video::close() {
    if (const int code = wait(); code != 0) return given_up(code);
    return publish_file(unfinished(file_), file_);
}

}  // namespace airlight::cli
