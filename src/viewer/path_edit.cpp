#include "viewer/path_edit.h"

#include <cassert>
#include <system_error>
#include <utility>

#include "core/files.h"
#include "viewer/files.h"

namespace airlight::viewer {

namespace {

constexpr std::size_t longest_file = std::size_t{1} << 24;

// "" for a file that is not there.
Result<std::string> text_of(const std::filesystem::path& file) {
    std::error_code unreadable;
    if (!std::filesystem::exists(file, unreadable)) return std::string();
    return read_file(file, longest_file);
}

}  // namespace

Result<PathEdit> PathEdit::open(std::filesystem::path file, std::filesystem::path refuge) {
    PathEdit edit(std::move(file), std::move(refuge));
    if (const Result<Done> read = edit.follow(); !read) return read.error();
    edit.states_.erase(edit.states_.begin(), edit.states_.end() - 1);
    edit.now_ = 0;
    return edit;
}

Result<Done> PathEdit::follow() {
    Result<std::string> text = text_of(file_);
    if (!text) return text.error();
    if (*text == written_) return Done{};
    if (!text->empty()) {
        Result<CameraPath> there = parse_camera_path(*text, file_.string());
        if (!there) return there.error();
        if (there->keys != keys()) take(std::move(there->keys));
    }
    written_ = *std::move(text);
    return Done{};
}

Result<Done> PathEdit::add(CameraKey key, double seconds) {
    assert(seconds > 0.0);
    static_cast<void>(follow());  // save() tells of a file that is no path
    std::vector<CameraKey> longer = keys();
    key.time_s = longer.empty() ? 0.0 : longer.back().time_s + seconds;
    longer.push_back(key);
    // What the file's reader would refuse is refused here, and the path is what it will read.
    Result<CameraPath> read = parse_camera_path(camera_path_text({longer}), "the new key");
    if (!read) return read.error();
    take(std::move(read->keys));
    return save();
}

Result<Done> PathEdit::undo() {
    if (const Result<Done> followed = follow(); !followed) return followed.error();
    if (!can_undo()) return Done{};
    --now_;
    return save();
}

Result<Done> PathEdit::redo() {
    if (const Result<Done> followed = follow(); !followed) return followed.error();
    if (!can_redo()) return Done{};
    ++now_;
    return save();
}

// Another state after this one; those that were taken back are forgotten.
void PathEdit::take(std::vector<CameraKey> keys) {
    states_.resize(now_ + 1);
    states_.push_back(std::move(keys));
    ++now_;
}

Result<Done> PathEdit::save() {
    const Result<Done> written = write();
    unsaved_ = !written;
    if (unsaved_) keep();
    else if (!kept_in_.empty()) {
        std::error_code failed;
        std::filesystem::remove(std::exchange(kept_in_, {}), failed);
    }
    return written;
}

// A path without keys is no file: the one that is there goes.
Result<Done> PathEdit::write() {
    const Result<std::string> there = text_of(file_);
    if (!there) return there.error();
    if (!there->empty() && *there != written_)
        return Error{file_.string(), "another program has written it, and it is no path", "Mend or move it: it is not overwritten."};
    std::string text = keys().empty() ? std::string() : camera_path_text({keys()});
    if (text.empty()) {
        std::error_code error;
        std::filesystem::remove(file_, error);
        if (error) return Error{file_.string(), "cannot be removed: " + error.message(), ""};
    } else if (const Result<Done> written = write_file(file_, text); !written) return written.error();
    written_ = std::move(text);
    return Done{};
}

// The keys in a file of the refuge that no one else has, if that can be written.
void PathEdit::keep() {
    if (refuge_.empty()) return;
    std::error_code failed;
    std::filesystem::create_directories(refuge_, failed);
    const std::filesystem::path file = kept_in_.empty() ? free_name(refuge_, "path", ".toml") : kept_in_;
    kept_in_ = write_file(file, camera_path_text({keys()})) ? file : std::filesystem::path();
}

}  // namespace airlight::viewer
