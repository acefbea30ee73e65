// Tables of spectra, read with linear interpolation exactly as a GPU reads its textures.
// Coordinates are texture coordinates: texel i of n lies at (i + 1/2) / n, and beyond the outermost centres the value stays.
// Uses physics (f32); knows nothing of what is in the table.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <new>
#include <span>
#include <vector>

#include "physics/f32.h"

namespace airlight {

// Where between two neighbouring texels a coordinate lies.
struct Texels {
    int low;
    int high;
    float weight;  // of `high`
};

AIRLIGHT_INLINE Texels texels_at(float coordinate, int size) {
    const float x = coordinate * static_cast<float>(size) - 0.5f;
    const float clamped = x < 0.0f ? 0.0f : (x > static_cast<float>(size - 1) ? static_cast<float>(size - 1) : x);
    const int low = static_cast<int>(clamped);
    return {low, low + 1 < size ? low + 1 : low, clamped - static_cast<float>(low)};
}

// Cells of D dimensions, the first one running fastest.
template <class Cell, int D>
class Table {
public:
    Table() = default;
    explicit Table(std::array<int, D> size) : size_(size) {
        std::size_t count = 1;
        for (const int n : size) count *= static_cast<std::size_t>(n);
        cells_.resize(count);
    }

    const std::array<int, D>& size() const { return size_; }
    std::span<Cell> cells() { return cells_; }
    std::span<const Cell> cells() const { return cells_; }

    AIRLIGHT_INLINE std::size_t index(std::array<int, D> i) const {
        std::size_t k = static_cast<std::size_t>(i[D - 1]);
        for (int d = D - 2; d >= 0; --d)
            k = k * static_cast<std::size_t>(size_[static_cast<std::size_t>(d)]) + static_cast<std::size_t>(i[static_cast<std::size_t>(d)]);
        return k;
    }
    Cell& operator[](std::array<int, D> i) { return cells_[index(i)]; }
    const Cell& operator[](std::array<int, D> i) const { return cells_[index(i)]; }

    // The multilinear interpolation at texture coordinates: a sum over 2^D cells.
    AIRLIGHT_INLINE Cell look_up(std::array<float, D> coordinates) const {
        std::array<Texels, D> places;
        for (std::size_t d = 0; d < D; ++d) places[d] = texels_at(coordinates[d], size_[d]);
        return at(places);
    }

    // The same between texels that were found before.
    AIRLIGHT_INLINE Cell at(const std::array<Texels, D>& places) const {
        Cell sum(Cell::Scalar::of(0.0f));
        for (unsigned corner = 0; corner < (1u << D); ++corner) {
            float weight = 1.0f;
            std::array<int, D> i;
            for (std::size_t d = 0; d < D; ++d) {
                const bool high = (corner >> d) & 1u;
                weight *= high ? places[d].weight : 1.0f - places[d].weight;
                i[d] = high ? places[d].high : places[d].low;
            }
            const Cell& cell = cells_[index(i)];
            for (int w = 0; w < Cell::size; ++w) sum.v[w] += weight * cell.v[w];
        }
        return sum;
    }

    // The same, but geometric along the first dimension, for what spans decades there. Cells are 0 or more.
    AIRLIGHT_INLINE Cell geometric_at(const std::array<Texels, D>& places) const {
        Cell mean = slice_at(places[0].low, places);
        const Cell high = slice_at(places[0].high, places);
        constexpr float least = 1e-37f;
        for (int w = 0; w < Cell::size; ++w) {
            const float a = fast_log(mean.v[w] > least ? mean.v[w] : least), b = fast_log(high.v[w] > least ? high.v[w] : least);
            const float value = fast_exp(a + places[0].weight * (b - a));
            mean.v[w] = value > 2.0f * least ? value : 0.0f;  // between zeros it is 0
        }
        return mean;
    }

private:
    // Linear along all dimensions but the first, of which it is the texel `first`.
    AIRLIGHT_INLINE Cell slice_at(int first, const std::array<Texels, D>& places) const {
        Cell sum(Cell::Scalar::of(0.0f));
        for (unsigned corner = 0; corner < (1u << (D - 1)); ++corner) {
            float weight = 1.0f;
            std::array<int, D> i{first};
            for (std::size_t d = 1; d < D; ++d) {
                const bool high = (corner >> (d - 1)) & 1u;
                weight *= high ? places[d].weight : 1.0f - places[d].weight;
                i[d] = high ? places[d].high : places[d].low;
            }
            const Cell& cell = cells_[index(i)];
            for (int w = 0; w < Cell::size; ++w) sum.v[w] += weight * cell.v[w];
        }
        return sum;
    }

    std::array<int, D> size_{};
    std::vector<Cell> cells_;
};

}  // namespace airlight
