#include "scene/object_scene.h"

#include <map>
#include <memory>

#include "scene/scene.h"

namespace airlight {

namespace {

// Its mesh is still to be read.
Object placed(const ObjectScene& said, const HeightField& ground) {
    Viewpoint foot = said.foot;
    if (said.above_ground) foot.altitude_m += surface_m(foot, ground);
    const Camera stand = look(foot, ground.radius_m);
    if (said.shape == Shape::mesh) return {said.shape, stand.eye, stand.right, stand.forward, stand.up, said.size_m, said.reflectance};
    return {said.shape,      stand.eye + 0.5 * said.size_m.z * stand.up, stand.right, stand.forward, stand.up, 0.5 * said.size_m,
            said.reflectance};
}

}  // namespace

Result<std::vector<Object>> objects_of(const Scene& scene, const HeightField& ground) {
    std::map<std::filesystem::path, std::shared_ptr<const Mesh>> meshes;
    std::vector<Object> objects;
    for (const ObjectScene& said : scene.objects) {
        Object object = placed(said, ground);
        if (said.shape == Shape::mesh) {
            std::shared_ptr<const Mesh>& mesh = meshes[said.mesh];
            if (!mesh) {
                Result<Mesh> read = read_mesh(said.mesh);
                if (!read) return read.error();
                mesh = std::make_shared<const Mesh>(*std::move(read));
            }
            object.mesh = mesh;
        }
        objects.push_back(std::move(object));
    }
    return objects;
}

}  // namespace airlight
