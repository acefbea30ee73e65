// A planet's ground, drawn into the geometry buffer: one small set of triangles for all patches [Sperlhofer2011, section 4.4].
// Uses terrain and gpu.
#pragma once

#include <memory>
#include <unordered_map>

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "gpu/vertex_array.h"
#include "terrain/tile_store.h"

namespace airlight::render {

struct TerrainMemory {
    std::size_t tiles_bytes = std::size_t{64} << 20;  // of tiles kept in memory
    int gpu_tiles = 2048;                             // of tiles kept on the GPU: 24 MB
};

struct TerrainCount {
    std::size_t patches = 0, triangles = 0;
    int visited = 0, culled = 0;
    std::size_t built = 0;  // tiles, for this frame
    bool sea = false;       // whether some of the patches may reach below it
};

class TerrainPass {
public:
    // `tiles`: of this field, those of another pass; without them, they are built.
    static Result<TerrainPass> create(const HeightField& field, DetailSettings detail, TerrainMemory memory = {},
                                      std::shared_ptr<TileStore> tiles = {});

    // Draws what the camera sees, as finely as `detail` asks, for GroundPass; tiles that are missing are built first. A geometry buffer has
    // begun, and a CameraBlock of the same camera is bound.
    void draw(const Camera& camera, Culling culling = {});

    // Draws the depths of an eye's ground, what of it is chosen, whether the eye sees it or not, into the bound shadow map. A CameraBlock of
    // the eye and a ShadowBlock are bound. Returns how many patches.
    std::size_t draw_depths(Vec3 eye, const PatchChoice& choice);

    // Of the last draw().
    const TerrainCount& count() const { return count_; }
    const Quadtree& quadtree() const { return tree_; }
    std::size_t tiles_bytes() const { return store_->bytes(); }
    const std::shared_ptr<TileStore>& tiles() const { return store_; }

private:
    struct Slot {
        Node node;
        std::size_t used = 0;  // in which batch; 0 never
    };
    TerrainPass(const HeightField& field, const LevelReach& reach, TerrainMemory memory, std::shared_ptr<TileStore> tiles,
                gpu::Program program, gpu::Program shadow_program);
    void draw_patches(std::span<const Node> nodes);
    void draw_batch(std::span<const Node> nodes);
    std::size_t slot_of(const Node& node);

    Quadtree tree_;
    std::shared_ptr<TileStore> store_;
    gpu::Program program_, shadow_program_;
    gpu::Buffer tiles_, places_, reach_, indices_;
    gpu::VertexArray triangles_;
    std::vector<Slot> slots_;
    std::unordered_map<Node, std::size_t, NodeHash> slot_by_node_;
    std::size_t batch_ = 0;
    TerrainCount count_;
};

}  // namespace airlight::render
