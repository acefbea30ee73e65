// A camera path that is being made, key by key: each step is on the disk before the next, and can be taken back.
// Uses scene.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/camera_path.h"

namespace airlight::viewer {

class PathEdit {
public:
    // Goes on from what the file holds, if it is there. Fails if it is there and is no path: it is not overwritten then. What cannot be
    // written there is kept in the folder `refuge`, if it has a name, until it can be.
    static Result<PathEdit> open(std::filesystem::path file, std::filesystem::path refuge = {});

    const std::filesystem::path& file() const { return file_; }
    const std::vector<CameraKey>& keys() const { return states_[now_]; }
    bool can_undo() const { return now_ > 0; }
    bool can_redo() const { return now_ + 1 < states_.size(); }
    // Whether the file lacks the last edit, because it could not be written; the edit is kept, and save() tries again.
    bool unsaved() const { return unsaved_; }
    // Where an edit is that the file lacks; empty if there is none, or it is on no disk.
    const std::filesystem::path& kept_in() const { return kept_in_; }

    // A key `seconds` > 0 after the last one (the first: at 0); the time of `key` does not matter. Fails if the file cannot be written,
    // or, and then nothing has changed, if the key is on the other side of the planet from the last.
    Result<Done> add(CameraKey key, double seconds);
    Result<Done> undo();
    Result<Done> redo();
    // Fails, too, if another program has written the file so that it is no path: it is left alone.
    Result<Done> save();

    // Takes what another program has written into the file since: one more edit, which undo() takes back. Fails if it is no path.
    Result<Done> follow();

private:
    PathEdit(std::filesystem::path file, std::filesystem::path refuge) : file_(std::move(file)), refuge_(std::move(refuge)) {}
    void take(std::vector<CameraKey> keys);
    Result<Done> write();
    void keep();

    std::filesystem::path file_, refuge_, kept_in_;
    std::string written_;  // what the file held when it was last read or written
    std::vector<std::vector<CameraKey>> states_ = {{}};
    std::size_t now_ = 0;
    bool unsaved_ = false;
};

}  // namespace airlight::viewer
