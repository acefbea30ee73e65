// Any bytes are a mesh or a refusal; a mesh is whole triangles, with normals of length one and no corner beyond its reach.

#include <cmath>

#include "fuzz.h"
#include "objects/mesh.h"

using namespace airlight;
using fuzz::demand;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Result<Mesh> mesh = parse_mesh(std::string(fuzz::text_of(data, size)), "fuzz.obj");
    if (!mesh) {
        fuzz::demand_message(mesh.error());
        return 0;
    }
    demand(!mesh->corners.empty() && mesh->corners.size() % 3 == 0, "a mesh is whole triangles");
    for (const MeshCorner& corner : mesh->corners) {
        demand(std::hypot(corner.place[0], corner.place[1], corner.place[2]) <= mesh->reach * (1.0 + 1e-6), "a corner is within reach");
        demand(std::abs(std::hypot(corner.normal[0], corner.normal[1], corner.normal[2]) - 1.0f) < 1e-5f, "a normal has length one");
    }
    return 0;
}
