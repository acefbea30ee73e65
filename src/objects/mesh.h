// A body's surface as triangles, from a file of Wavefront's OBJ. docs/decisions/0019-objects.md.
// Uses core and units; includes tinyobjloader in its source only.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace airlight {

struct MeshCorner {
    std::array<float, 3> place;   // in the file's unit
    std::array<float, 3> normal;  // of length one
};

// Three corners a triangle, at least one triangle. No corner is farther from the file's origin than `reach`, in the file's unit.
struct Mesh {
    std::vector<MeshCorner> corners;
    double reach;
};

// The faces of an OBJ text, cut into triangles; materials are left out. A corner without a normal has that of its triangle, by the right
// hand. Triangles without an area are left out. Fails, naming `file`, if the text is no OBJ, names a corner that is not there, holds what is
// no number below 10^9, or has no triangles.
Result<Mesh> parse_mesh(const std::string& obj, std::string_view file);
// Fails also if there is no such file or it is larger than 1 GiB.
Result<Mesh> read_mesh(const std::filesystem::path& path);

}  // namespace airlight
