#include "objects/mesh.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "core/files.h"
#include "units/vector.h"

namespace airlight {

namespace {

constexpr double farthest = 1e9;

// The three numbers at an index of a file's list; none if it has no such index.
std::optional<Vec3> vector_at(const std::vector<tinyobj::real_t>& numbers, int index) {
    if (index < 0 || static_cast<std::size_t>(index) >= numbers.size() / 3) return {};
    const auto at = 3 * static_cast<std::size_t>(index);
    return Vec3(numbers[at], numbers[at + 1], numbers[at + 2]);
}

bool is_near(Vec3 p) { return std::abs(p.x) <= farthest && std::abs(p.y) <= farthest && std::abs(p.z) <= farthest; }

std::array<float, 3> three(Vec3 v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }

// Adds a triangle, unless it has no area.
Result<Done> add_triangle(Mesh& mesh, const tinyobj::attrib_t& lists, std::span<const tinyobj::index_t, 3> indices) {
    std::array<Vec3, 3> places;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::optional<Vec3> place = vector_at(lists.vertices, indices[i].vertex_index);
        if (!place) return Error{"", "a face names a corner that is not there.", "Export the mesh anew."};
        if (!is_near(*place)) return Error{"", "a corner is no number below 10^9.", "Export the mesh anew."};
        places[i] = *place;
    }
    const Vec3 across = glm::cross(places[1] - places[0], places[2] - places[0]);
    if (!(glm::length(across) > 0.0)) return Done{};
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 said = vector_at(lists.normals, indices[i].normal_index).value_or(Vec3(0.0));
        const double length = glm::length(said);
        const Vec3 normal = length > 0.0 && is_near(said) ? said / length : glm::normalize(across);
        mesh.corners.push_back({three(places[i]), three(normal)});
        mesh.reach = std::max(mesh.reach, glm::length(places[i]));
    }
    return Done{};
}

}  // namespace

Result<Mesh> parse_mesh(const std::string& obj, std::string_view file) {
    tinyobj::ObjReader reader;
    if (!reader.ParseFromString(obj, ""))
        return Error{std::string(file), fmt::format("it is no mesh: {}", reader.Error().substr(0, reader.Error().find('\n'))),
                     "Meshes are Wavefront's OBJ."};
    Mesh mesh{{}, 0.0};
    for (const tinyobj::shape_t& shape : reader.GetShapes()) {
        const std::vector<tinyobj::index_t>& indices = shape.mesh.indices;
        for (std::size_t first = 0; first + 3 <= indices.size(); first += 3)
            if (const Result<Done> added = add_triangle(mesh, reader.GetAttrib(), std::span<const tinyobj::index_t, 3>(&indices[first], 3));
                !added)
                return at(file, added.error());
    }
    if (mesh.corners.empty()) return Error{std::string(file), "it has no triangles.", "Meshes are Wavefront's OBJ, with faces."};
    return mesh;
}

Result<Mesh> read_mesh(const std::filesystem::path& path) {
    const Result<std::string> text = read_file(path);
    if (!text) return text.error();
    return parse_mesh(*text, path.string());
}

}  // namespace airlight
