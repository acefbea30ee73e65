#include "viewer/slices.h"

#include <algorithm>

namespace airlight::viewer {

std::optional<Slices::Slice> Slices::next() const {
    if (done_ == rows_) return std::nullopt;
    const int count = std::min(count_, rows_ - done_);
    return Slice{rows_ - done_ - count, count};
}

void Slices::drawn(double milliseconds) {
    const std::optional<Slice> slice = next();
    if (!slice) return;
    done_ += slice->count;
    const double rows = slice->count * slice_ms / std::max(milliseconds, 1e-3);
    count_ = static_cast<int>(std::clamp(rows, 1.0, 2.0 * count_));
}

double Slices::share() const { return static_cast<double>(done_) / rows_; }

}  // namespace airlight::viewer
