#include "viewer/path_edit.h"

#include <cassert>
#include <system_error>
#include <utility>

#include "core/files.h"

namespace airlight::viewer {

Result<PathEdit> PathEdit::open(std::filesystem::path file) {
    PathEdit edit(std::move(file));
    std::error_code unreadable;
    if (!std::filesystem::exists(edit.file_, unreadable)) return edit;
    Result<CameraPath> there = read_camera_path(edit.file_);
    if (!there) return there.error();
    edit.states_.front() = std::move(there->keys);
    return edit;
}

Result<Done> PathEdit::add(CameraKey key, double seconds) {
    assert(seconds > 0.0);
    std::vector<CameraKey> longer = keys();
    key.time_s = longer.empty() ? 0.0 : longer.back().time_s + seconds;
    longer.push_back(key);
    // What the file's reader would refuse is refused here.
    if (const Result<CameraPath> read = parse_camera_path(camera_path_text({longer}), "the new key"); !read) return read.error();
    states_.resize(now_ + 1);
    states_.push_back(std::move(longer));
    ++now_;
    return save();
}

Result<Done> PathEdit::undo() {
    if (!can_undo()) return Done{};
    --now_;
    return save();
}

Result<Done> PathEdit::redo() {
    if (!can_redo()) return Done{};
    ++now_;
    return save();
}

// A path without keys is no file: the one that is there goes.
Result<Done> PathEdit::save() {
    unsaved_ = true;
    if (keys().empty()) {
        std::error_code error;
        std::filesystem::remove(file_, error);
        if (error) return Error{file_.string(), "cannot be removed: " + error.message(), ""};
    } else if (const Result<Done> written = write_file(file_, camera_path_text({keys()})); !written) {
        return written.error();
    }
    unsaved_ = false;
    return Done{};
}

}  // namespace airlight::viewer
