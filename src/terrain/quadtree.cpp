#include "terrain/quadtree.h"

#include <algorithm>
#include <cmath>

namespace airlight {

namespace {

// 100 bytes each: a view takes some thousands.
constexpr std::size_t most_bounds = 100'000;

// What rounding of float distances on the GPU may take: a node is divided a little before any vertex needs it.
constexpr double margin = 1.0 + 1e-5;

}  // namespace

std::size_t NodeHash::operator()(const Node& n) const {
    std::uint64_t key = (std::uint64_t{n.x} << 32 | n.y) ^ (static_cast<std::uint64_t>(n.face * 32 + n.level) << 24);
    key = (key ^ (key >> 31)) * 0x9e3779b97f4a7c15u;
    return key ^ (key >> 29);
}

Quadtree::Quadtree(HeightField field, LevelReach reach) : field_(std::move(field)), reach_(reach) {}

const NodeBounds& Quadtree::bounds(const Node& node) {
    if (const auto found = bounds_.find(node); found != bounds_.end()) return found->second;
    if (bounds_.size() >= most_bounds) bounds_.clear();
    return bounds_.emplace(node, bounds_of(node, field_)).first->second;
}

double Quadtree::solid_m(Vec3 eye) const {
    const double least = field_.radius_m + (field_.sea ? std::max(0.0, field_.whole.low) : field_.whole.low);
    const double r = glm::length(eye);
    const double horizon_m = std::sqrt(std::max(0.0, (r - least) * (r + least)));
    int level = 0;
    while (level < reach_.deepest && reach_.reach_m[static_cast<std::size_t>(level + 1)] > horizon_m) ++level;
    // Its vertices may all have glided: then its squares are those of the level before.
    const double diagonal = 1.5 * spacing_m(std::max(0, level - 1), field_.radius_m);
    return least - diagonal * diagonal / (8.0 * field_.radius_m) * 1.01;
}

Selection Quadtree::select(const Camera& camera, Culling culling) {
    const Frustum planes = frustum(camera);
    const double solid = solid_m(camera.eye);
    return select(camera.eye, {.culled =
                                   [&](const NodeBounds& b) {
                                       return (culling.frustum && outside(b, camera.eye, planes)) ||
                                              (culling.horizon && below_horizon(b, camera.eye, solid));
                                   },
                               .fine_enough = [](const Node&, const NodeBounds&) { return false; }});
}

Selection Quadtree::select(Vec3 eye, const PatchChoice& choice) {
    Selection selection;
    for (int face = 0; face < cube_faces; ++face) select({face, 0, 0, 0}, eye, choice, selection);
    return selection;
}

void Quadtree::select(const Node& node, Vec3 eye, const PatchChoice& choice, Selection& selection) {
    ++selection.visited;
    const NodeBounds b = bounds(node);
    if (choice.culled(b)) {
        ++selection.culled;
        return;
    }
    const auto next = static_cast<std::size_t>(node.level + 1);
    if (node.level >= reach_.deepest || choice.fine_enough(node, b) || distance_to(b, eye) > margin * reach_.reach_m[next]) {
        selection.nodes.push_back(node);
        return;
    }
    for (const Node& child : children(node)) select(child, eye, choice, selection);
}

}  // namespace airlight
