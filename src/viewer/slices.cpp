#include "viewer/slices.h"

#include <algorithm>

namespace airlight::viewer {

Slices::Slices(int width, int height)
    : width_(width), height_(height), across_((width + tile_side - 1) / tile_side), bands_((height + tile_side - 1) / tile_side) {}

int Slices::tiles_of_next() const {
    const int column = done_ % across_;
    if (column == 0 && count_ >= across_) return std::min(count_ / across_ * across_, across_ * bands_ - done_);
    return std::min(count_, across_ - column);
}

std::optional<Slices::Slice> Slices::next() const {
    if (done_ == across_ * bands_) return std::nullopt;
    const int tiles = tiles_of_next(), column = done_ % across_, band = done_ / across_, bands = std::max(1, tiles / across_);
    const int right = std::min((column + std::min(tiles, across_)) * tile_side, width_), left = column * tile_side;
    const int top = height_ - band * tile_side, bottom = std::max(top - bands * tile_side, 0);
    return Slice{left, bottom, right - left, top - bottom};
}

void Slices::drawn(double milliseconds) {
    if (!next()) return;
    const int tiles = tiles_of_next();
    done_ += tiles;
    count_ = static_cast<int>(std::clamp(tiles * slice_ms / std::max(milliseconds, 1e-3), 1.0, 2.0 * count_));
}

double Slices::share() const { return static_cast<double>(done_) / (across_ * bands_); }

}  // namespace airlight::viewer
