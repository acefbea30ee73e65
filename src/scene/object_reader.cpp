#include "scene/object_reader.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>

#include "scene/place_reader.h"

namespace airlight {

namespace {

constexpr std::string_view shape_names = "sphere box cylinder mesh";

std::optional<Shape> shape_named(std::string_view name) {
    if (name == "sphere") return Shape::sphere;
    if (name == "box") return Shape::box;
    if (name == "cylinder") return Shape::cylinder;
    if (name == "mesh") return Shape::mesh;
    return {};
}

// A length that must be there, in metres.
double read_size(TomlInput& input, std::string_view key) {
    double read_m = 1.0;
    if (const auto size = input.need(&TomlInput::length, key, fmt::format("Write {} = \"3 m\".", key)))
        keep_within(input, key, size->in(m), 1e-3, 1e8, "from 1 mm to 100000 km", read_m);
    return read_m;
}

void read_mesh_file(TomlInput& input, const std::filesystem::path& folder, ObjectScene& object) {
    if (const auto path = input.need(&TomlInput::text, "file", "Name a file of Wavefront's OBJ.")) object.mesh = folder / *path;
    double unit_m = 1.0;
    if (const auto unit = input.length("unit")) keep_within(input, "unit", unit->in(m), 1e-6, 1e6, "from 0.001 mm to 1000 km", unit_m);
    object.size_m = Vec3(unit_m);
}

void read_shape(TomlInput& input, const std::filesystem::path& folder, ObjectScene& object) {
    const auto word = input.need(&TomlInput::text, "shape", "Write shape = \"sphere\", \"box\", \"cylinder\" or \"mesh\".");
    if (!word) return;
    const std::optional<Shape> shape = shape_named(*word);
    if (!shape) return input.refuse_word("shape", shape_names);
    object.shape = *shape;
    switch (*shape) {
        case Shape::sphere:
            object.size_m = Vec3(2.0 * read_size(input, "radius"));
            break;
        case Shape::box:
            object.size_m = {read_size(input, "width"), read_size(input, "length"), read_size(input, "height")};
            break;
        case Shape::cylinder: {
            const double across = 2.0 * read_size(input, "radius");
            object.size_m = {across, across, read_size(input, "height")};
            break;
        }
        case Shape::mesh:
            read_mesh_file(input, folder, object);
            break;
    }
}

void read_reflectance(TomlInput& input, ObjectScene& object) {
    const auto read = input.numbers("reflectance");
    if (!read) return;
    const auto is_share = [](double x) { return x >= 0.0 && x <= 1.0; };
    if (read->size() != 3 || !is_share((*read)[0]) || !is_share((*read)[1]) || !is_share((*read)[2]))
        input.refuse("reflectance", "it must be three numbers from 0 to 1, of red, green and blue light", "");
    else object.reflectance = {(*read)[0], (*read)[1], (*read)[2]};
}

ObjectScene read_object(TomlInput& input, const std::filesystem::path& folder) {
    ObjectScene object;
    read_shape(input, folder, object);
    read_place(input, object.foot);
    read_altitude(input, -1e5, object.above_ground, object.foot.altitude_m);
    double tilt = 0.0;
    keep_within(input, "tilt", input.angle("tilt"), -180.0 * deg, 180.0 * deg, "from -180 deg to 180 deg", tilt);
    object.foot.pitch = -tilt;
    read_reflectance(input, object);
    input.refuse_unknown_keys();
    return object;
}

}  // namespace

std::vector<ObjectScene> read_objects(TomlInput& file, const std::filesystem::path& folder) {
    std::vector<ObjectScene> objects;
    for (TomlInput& input : file.tables("object")) objects.push_back(read_object(input, folder));
    return objects;
}

}  // namespace airlight
