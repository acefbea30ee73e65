#include "scene/path_frames.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <system_error>

#include "core/files.h"
#include "units/text.h"

namespace airlight {

namespace {

constexpr std::string_view columns = "frame,exposure\n";

// A picture that falls on the path's end is one of it, though its time be rounded.
constexpr double part_of_picture = 1e-9;

std::string key_of(std::string_view made_of) {
    const XXH128_hash_t hash = XXH3_128bits(made_of.data(), made_of.size());
    return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

std::string first_line(std::string_view key) { return fmt::format("# the frames of airlight render --path, made of {}\n", key); }

std::filesystem::path list_of(const std::filesystem::path& folder) { return folder / "frames.csv"; }

std::filesystem::path picture_of(const std::filesystem::path& folder, std::size_t number) {
    return folder / fmt::format("{:05}.png", number);
}

// The exposures of the rows "number,exposure", whose numbers count from 0.
Result<std::vector<double>> read_rows(std::string_view rows, const std::filesystem::path& list) {
    std::vector<double> exposures;
    while (!rows.empty()) {
        const std::string_view row = rows.substr(0, rows.find('\n'));
        const std::string number = fmt::format("{},", exposures.size());
        const Result<double> exposure = parse_number(row.starts_with(number) ? row.substr(number.size()) : "");
        if (!exposure || *exposure <= 0.0 || row.size() == rows.size())
            return Error{list.string(), fmt::format("\"{}\" is no row of frame {} and its exposure", row, exposures.size()),
                         "Give another folder, or remove this file and its pictures."};
        exposures.push_back(*exposure);
        rows.remove_prefix(row.size() + 1);
    }
    return exposures;
}

}  // namespace

std::vector<double> picture_times(const CameraPath& path, double rate) {
    const auto last = static_cast<std::size_t>((path.end_s() - path.begin_s()) * rate + part_of_picture);
    std::vector<double> times;
    for (std::size_t number = 0; number <= last; ++number) times.push_back(path.begin_s() + static_cast<double>(number) / rate);
    return times;
}

Result<FrameFolder> FrameFolder::open(const std::filesystem::path& folder, std::string_view made_of) {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed) return Error{folder.string(), fmt::format("the folder cannot be made: {}", failed.message()), ""};
    const std::filesystem::path list = list_of(folder);
    if (const Result<Done> possible = can_write(list); !possible) return possible.error();
    const std::string key = key_of(made_of), head = first_line(key) + std::string(columns);
    if (!std::filesystem::exists(list, failed)) return FrameFolder(folder, key, {});
    const Result<std::string> text = read_file(list, std::size_t{1} << 28);
    if (!text) return text.error();
    if (!text->starts_with(head))
        return Error{folder.string(), "it has frames of another scene, path, size or option",
                     fmt::format("Give another folder, or remove {} and its pictures.", list.string())};
    Result<std::vector<double>> exposures = read_rows(std::string_view(*text).substr(head.size()), list);
    if (!exposures) return exposures.error();
    std::size_t there = 0;
    while (there < exposures->size() && std::filesystem::exists(picture_of(folder, there), failed)) ++there;
    exposures->resize(there);
    return FrameFolder(folder, key, *std::move(exposures));
}

std::filesystem::path FrameFolder::picture(std::size_t number) const { return picture_of(folder_, number); }

Result<Done> FrameFolder::add(double exposure) {
    exposures_.push_back(exposure);
    std::string text = first_line(key_) + std::string(columns);
    for (std::size_t i = 0; i < exposures_.size(); ++i) text += fmt::format("{},{}\n", i, exposures_[i]);
    return write_file(list_of(folder_), text);
}

Result<Done> FrameFolder::discard() {
    std::error_code failed;
    // The list first: a folder that loses its pictures halfway has none.
    std::filesystem::remove(list_of(folder_), failed);
    for (std::size_t number = 0; number < exposures_.size() && !failed; ++number) std::filesystem::remove(picture(number), failed);
    exposures_.clear();
    if (!failed && std::filesystem::is_empty(folder_, failed) && !failed) std::filesystem::remove(folder_, failed);
    if (failed) return Error{folder_.string(), fmt::format("cannot be removed: {}", failed.message()), ""};
    return Done{};
}

}  // namespace airlight
