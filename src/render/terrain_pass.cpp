#include "render/terrain_pass.h"

#include <algorithm>

#include "render/shaders.h"

namespace airlight::render {

namespace {

// std430, and std140 for the reaches.
struct Place {
    std::uint32_t slot;
    std::int32_t level, towards_x, towards_y;
    float span_m;  // no triangle's corners are farther apart
    float unused;
};
using Reaches = std::array<float, 28>;
static_assert(deepest_level < 28);

Reaches reaches_of(const LevelReach& reach) {
    Reaches all{};
    for (std::size_t level = 1; level < reach.reach_m.size(); ++level) all[level] = static_cast<float>(reach.reach_m[level]);
    return all;
}

// Gliding makes a triangle up to two squares wide each way: 2 sqrt(2), and what the cube's map and slopes add.
constexpr double squares_of_span = 3.5;

Place place_of(const Node& node, std::size_t slot, double radius_m) {
    const GlideDirection towards = glide_direction(node);
    return {static_cast<std::uint32_t>(slot),
            node.level,
            towards.x,
            towards.y,
            static_cast<float>(squares_of_span * spacing_m(node.level, radius_m)),
            {}};
}

}  // namespace

Result<TerrainPass> TerrainPass::create(const HeightField& field, DetailSettings detail, TerrainMemory memory,
                                        std::shared_ptr<TileStore> tiles) {
    Result<gpu::Program> made = program("terrain.vert", "terrain.frag");
    if (!made) return made.error();
    Result<gpu::Program> shadow = program("terrain_shadow.vert", "depth.frag");
    if (!shadow) return shadow.error();
    const LevelReach reach = level_reach(field, detail);
    if (!tiles) tiles = std::make_shared<TileStore>(field, memory.tiles_bytes);
    return TerrainPass(field, reach, memory, std::move(tiles), std::move(*made), std::move(*shadow));
}

TerrainPass::TerrainPass(const HeightField& field, const LevelReach& reach, TerrainMemory memory, std::shared_ptr<TileStore> tiles,
                         gpu::Program made, gpu::Program shadow)
    : tree_(field, reach),
      store_(std::move(tiles)),
      program_(std::move(made)),
      shadow_program_(std::move(shadow)),
      tiles_(static_cast<std::size_t>(memory.gpu_tiles) * tile_bytes),
      places_(static_cast<std::size_t>(memory.gpu_tiles) * sizeof(Place)),
      reach_(sizeof(Reaches)),
      indices_(std::as_bytes(std::span(patch_triangles()))),
      triangles_(gpu::VertexArray::indexed(indices_)),
      slots_(static_cast<std::size_t>(memory.gpu_tiles)) {
    const Reaches reaches = reaches_of(reach);
    reach_.write(std::as_bytes(std::span(reaches)));
}

void TerrainPass::draw(const Camera& camera, Culling culling) {
    const Selection selection = tree_.select(camera, culling);
    const std::size_t before = store_->built();
    program_.use();
    draw_patches(selection.nodes);
    count_ = {selection.nodes.size(),
              selection.nodes.size() * patch_triangles().size(),
              selection.visited,
              selection.culled,
              store_->built() - before,
              tree_.field().sea && std::ranges::any_of(selection.nodes, [&](const Node& node) {
                  return tree_.bounds(node).radii_m.low <= tree_.field().radius_m;
              })};
}

std::size_t TerrainPass::draw_depths(Vec3 eye, const PatchChoice& choice) {
    const Selection selection = tree_.select(eye, choice);
    shadow_program_.use();
    draw_patches(selection.nodes);
    return selection.nodes.size();
}

void TerrainPass::draw_patches(std::span<const Node> nodes) {
    tiles_.bind_storage(0);
    places_.bind_storage(1);
    reach_.bind_uniform(1);
    for (std::size_t first = 0; first < nodes.size(); first += slots_.size())
        draw_batch(nodes.subspan(first, std::min(slots_.size(), nodes.size() - first)));
}

void TerrainPass::draw_batch(std::span<const Node> nodes) {
    ++batch_;
    std::vector<Node> missing;
    for (const Node& node : nodes) {
        const auto found = slot_by_node_.find(node);
        if (found == slot_by_node_.end()) missing.push_back(node);
        else slots_[found->second].used = batch_;
    }
    for (const std::shared_ptr<const Tile>& tile : store_->get(missing))
        tiles_.write(std::as_bytes(std::span(tile->vertices)), slot_of(tile->node) * tile_bytes);
    std::vector<Place> places;
    for (const Node& node : nodes) places.push_back(place_of(node, slot_by_node_.at(node), tree_.field().radius_m));
    places_.write(std::as_bytes(std::span(places)));
    triangles_.draw_indexed(static_cast<int>(3 * patch_triangles().size()), static_cast<int>(nodes.size()));
}

// A slot for a tile that has none: the one that was used longest ago. This batch's are the latest, and no more than there are slots.
std::size_t TerrainPass::slot_of(const Node& node) {
    const auto oldest = std::min_element(slots_.begin(), slots_.end(), [](const Slot& a, const Slot& b) { return a.used < b.used; });
    const auto slot = static_cast<std::size_t>(oldest - slots_.begin());
    if (oldest->used > 0) slot_by_node_.erase(oldest->node);
    *oldest = {node, batch_};
    slot_by_node_[node] = slot;
    return slot;
}

}  // namespace airlight::render
