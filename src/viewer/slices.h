// A picture that takes long, drawn in slices, one a frame, so that its user can fly on.
// Uses nothing.
#pragma once

#include <optional>

namespace airlight::viewer {

class Slices {
public:
    // Of a picture of this size, in pixels, nothing of which is drawn.
    Slices(int width, int height);

    // A rectangle of the picture, whose lowest row is 0.
    struct Slice {
        int left, bottom, width, height;
    };
    // What is drawn next: some tiles of a band of them, or whole bands, from the highest down; none if all is drawn.
    std::optional<Slice> next() const;

    // That it is drawn, and took so long. The one after it takes about `slice_ms`, but has no more than twice as many tiles.
    void drawn(double milliseconds);

    // Of the picture, 0 to 1.
    double share() const;

    static constexpr double slice_ms = 100.0;

    // Drivers draw whole blocks of pixels: slices of single rows would be worked off several times.
    static constexpr int tile_side = 16;

private:
    int tiles_of_next() const;

    int width_, height_;
    int across_, bands_;  // tiles
    int done_ = 0;        // tiles, band by band
    int count_ = 1;       // of the next slice, if its band and the picture have as many; 1 or more
};

}  // namespace airlight::viewer
