// Tiles that were built, kept within a bound of memory; what is missing is built on all cores, or ahead of need in the background.
// Uses core.
#pragma once

#include <condition_variable>
#include <list>
#include <memory>
#include <mutex>
#include <span>
#include <thread>
#include <unordered_map>

#include "terrain/quadtree.h"

namespace airlight {

class TileStore {
public:
    // Holds at most `most_bytes` of tiles, or one request's, if that is more: the least lately used go first.
    TileStore(HeightField field, std::size_t most_bytes);
    ~TileStore();
    TileStore(const TileStore&) = delete;
    TileStore& operator=(const TileStore&) = delete;

    // The tiles of these nodes, in their order; those that are missing are built first.
    std::vector<std::shared_ptr<const Tile>> get(std::span<const Node> nodes);

    // Builds these in the background, the first first, in place of what was asked for before and is not begun.
    void prefetch(std::vector<Node> nodes);

    std::size_t bytes() const;
    std::size_t built() const;  // since the beginning

private:
    struct Entry {
        std::shared_ptr<const Tile> tile;
        std::list<Node>::iterator use;
    };
    std::shared_ptr<const Tile> find(const Node& node);
    void keep(std::shared_ptr<const Tile> tile);
    void shed();
    void build_ahead(const std::stop_token& stop);

    HeightField field_;
    std::size_t most_tiles_;
    mutable std::mutex mutex_;  // guards what follows
    std::condition_variable_any asked_;
    std::list<Node> uses_;  // latest first
    std::unordered_map<Node, Entry, NodeHash> tiles_;
    std::list<Node> ahead_;
    std::size_t built_ = 0;
    std::jthread worker_;  // the last member: it stops before the others go
};

// What a tile takes.
inline constexpr std::size_t tile_bytes = patch_vertices * sizeof(TileVertex);

}  // namespace airlight
