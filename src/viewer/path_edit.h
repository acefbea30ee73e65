// A camera path that is being made, key by key: each step is on the disk before the next, and can be taken back.
// Uses scene.
#pragma once

#include <filesystem>
#include <vector>

#include "scene/camera_path.h"

namespace airlight::viewer {

class PathEdit {
public:
    // Goes on from what the file holds, if it is there. Fails if it is there and is no path: it is not overwritten then.
    static Result<PathEdit> open(std::filesystem::path file);

    const std::filesystem::path& file() const { return file_; }
    const std::vector<CameraKey>& keys() const { return states_[now_]; }
    bool can_undo() const { return now_ > 0; }
    bool can_redo() const { return now_ + 1 < states_.size(); }
    // Whether the file lacks the last edit, because it could not be written; the edit is kept, and save() tries again.
    bool unsaved() const { return unsaved_; }

    // A key `seconds` > 0 after the last one (the first: at 0); the time of `key` does not matter. Fails if the file cannot be written,
    // or, and then nothing has changed, if the key is on the other side of the planet from the last.
    Result<Done> add(CameraKey key, double seconds);
    Result<Done> undo();
    Result<Done> redo();
    Result<Done> save();

private:
    explicit PathEdit(std::filesystem::path file) : file_(std::move(file)) {}

    std::filesystem::path file_;
    std::vector<std::vector<CameraKey>> states_ = {{}};
    std::size_t now_ = 0;
    bool unsaved_ = false;
};

}  // namespace airlight::viewer
