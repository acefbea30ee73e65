// A picture that takes long, drawn in slices of its rows, one a frame, so that its user can fly on.
// Uses nothing.
#pragma once

#include <optional>

namespace airlight::viewer {

class Slices {
public:
    // Of a picture with so many rows, none of which is drawn.
    explicit Slices(int rows) : rows_(rows) {}

    // Rows of the picture, the lowest of which is 0.
    struct Slice {
        int first, count;
    };
    // What is drawn next, from the highest down; none if all is.
    std::optional<Slice> next() const;

    // That it is drawn, and took so long. The one after it takes about `slice_ms`, but has no more than twice as many rows.
    void drawn(double milliseconds);

    // Of the picture, 0 to 1.
    double share() const;

    static constexpr double slice_ms = 100.0;

private:
    int rows_;
    int done_ = 0;
    int count_ = 4;  // of the next slice; 1 or more
};

}  // namespace airlight::viewer
