#include "terrain/tile_store.h"

#include <algorithm>

#include "core/parallel.h"

namespace airlight {

TileStore::TileStore(HeightField field, std::size_t most_bytes)
    : field_(std::move(field)), most_tiles_(most_bytes / tile_bytes), worker_([this](const std::stop_token& stop) { build_ahead(stop); }) {}

TileStore::~TileStore() = default;

std::shared_ptr<const Tile> TileStore::find(const Node& node) {
    const auto found = tiles_.find(node);
    if (found == tiles_.end()) return nullptr;
    uses_.splice(uses_.begin(), uses_, found->second.use);
    return found->second.tile;
}

void TileStore::keep(std::shared_ptr<const Tile> tile) {
    const Node node = tile->node;
    ++built_;
    if (tiles_.contains(node)) return;
    uses_.push_front(node);
    tiles_.emplace(node, Entry{std::move(tile), uses_.begin()});
}

void TileStore::shed() {
    while (tiles_.size() > most_tiles_) {
        tiles_.erase(uses_.back());
        uses_.pop_back();
    }
}

std::vector<std::shared_ptr<const Tile>> TileStore::get(std::span<const Node> nodes) {
    std::vector<std::shared_ptr<const Tile>> tiles(nodes.size());
    std::vector<std::size_t> missing;
    {
        const std::lock_guard lock(mutex_);
        for (std::size_t i = 0; i < nodes.size(); ++i)
            if (!(tiles[i] = find(nodes[i]))) missing.push_back(i);
    }
    parallel_for(missing.size(),
                 [&](std::size_t k) { tiles[missing[k]] = std::make_shared<const Tile>(build_tile(nodes[missing[k]], field_)); });
    const std::lock_guard lock(mutex_);
    for (const std::size_t i : missing) keep(tiles[i]);
    shed();
    return tiles;
}

void TileStore::prefetch(std::vector<Node> nodes) {
    const std::lock_guard lock(mutex_);
    ahead_.assign(nodes.begin(), nodes.end());
    asked_.notify_all();
}

std::size_t TileStore::bytes() const {
    const std::lock_guard lock(mutex_);
    return tiles_.size() * tile_bytes;
}

std::size_t TileStore::built() const {
    const std::lock_guard lock(mutex_);
    return built_;
}

void TileStore::build_ahead(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (asked_.wait(lock, stop, [this] { return !ahead_.empty(); })) {
        const Node node = ahead_.front();
        ahead_.pop_front();
        if (tiles_.contains(node)) continue;
        lock.unlock();
        auto tile = std::make_shared<const Tile>(build_tile(node, field_));
        lock.lock();
        keep(std::move(tile));
        shed();
    }
}

}  // namespace airlight
