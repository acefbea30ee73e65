// The pictures of a camera path: when they are taken, and a folder that knows which of them it has. docs/camera-path.md.
// Uses core; knows neither images nor a GPU.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "scene/camera_path.h"

namespace airlight {

// The moments of the pictures, in seconds: the first at the path's beginning, the last at its end or less than one picture before.
// `rate` is in pictures a second, above 0.
std::vector<double> picture_times(const CameraPath& path, double rate);

// A folder of pictures that are made one after the other. What it has is in its file frames.csv, which is replaced, whole, after each
// picture: whoever is stopped at any moment goes on behind the last one.
class FrameFolder {
public:
    // Makes the folder if it is not there. `made_of` is all that the pictures are a function of, in any form; its hash is kept. Fails if
    // the folder cannot be made or read, or has pictures that were made of something else.
    static Result<FrameFolder> open(const std::filesystem::path& folder, std::string_view made_of);

    // Of a picture, counted from 0: "00042.png".
    std::filesystem::path picture(std::size_t number) const;

    // One for each picture that is there, from the first on without a gap.
    const std::vector<double>& exposures() const { return exposures_; }

    // The next picture is in its place, and had this exposure. Fails if that cannot be written.
    Result<Done> add(double exposure);

    // Removes its pictures and its list, and the folder, if nothing else is in it. Fails if one of them stays.
    Result<Done> discard();

private:
    FrameFolder(std::filesystem::path folder, std::string key, std::vector<double> exposures)
        : folder_(std::move(folder)), key_(std::move(key)), exposures_(std::move(exposures)) {}

    std::filesystem::path folder_;
    std::string key_;
    std::vector<double> exposures_;
};

}  // namespace airlight
