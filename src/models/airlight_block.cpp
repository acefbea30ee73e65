#include "models/airlight_block.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <utility>

namespace airlight {

namespace {

// std140: scalars stand at multiples of four bytes; spectra, structures and each element of an array at multiples of sixteen.
class Std140 {
public:
    explicit Std140(int first) : first_(first) {}

    void put(int x) { append(&x, sizeof(x)); }
    template <class R, int L, int W, int S, int P>
    void put(Quantity<R, L, W, S, P> x) {
        append(&x.value, sizeof(x.value));
    }
    template <class R, int N, int L, int W, int S, int P>
    void put(const Spectral<R, N, L, W, S, P>& x) {
        align();
        append(x.v + first_, gpu_wavelengths * sizeof(R));
    }
    template <class T, std::size_t count>
    void put(const T (&array)[count]) {
        for (const T& x : array) {
            align();
            put(x);
        }
        align();
    }
    void put(const f32::AirlightAxis& x) {
        align();
        put(x.segments), put(x.texels), put(x.from), put(x.inverse_range), put(x.first), put(x.last), put(x.crowds);
    }
    void put(const f32::AirlightRule& x) {
        align();
        put(x.count), put(x.node), put(x.weight);
    }
    void align() { bytes_.resize((bytes_.size() + 15) / 16 * 16); }
    std::vector<std::byte> take() { return std::move(bytes_); }

private:
    void append(const void* from, std::size_t size) {
        const std::size_t at = bytes_.size();
        bytes_.resize(at + size);
        std::memcpy(bytes_.data() + at, from, size);
    }
    int first_;
    std::vector<std::byte> bytes_;
};

}  // namespace

std::vector<std::byte> airlight_block(const f32::AirlightAir& air, int first) {
    assert(first >= 0 && first + gpu_wavelengths <= pack_size);
    Std140 block(first);
    block.put(air.bottom), block.put(air.top), block.put(air.parts);
    block.put(air.scattering), block.put(air.extinction), block.put(air.opacity);
    block.put(air.ground_albedo), block.put(air.solar_irradiance), block.put(air.sun_radius);
    block.put(air.density_axis), block.put(air.transmittance_axis), block.put(air.source_axis);
    block.put(air.least_depth), block.put(air.depth_range), block.put(air.log_low), block.put(air.log_range);
    block.put(air.sun_texels), block.put(air.azimuth_texels), block.put(air.view_texels), block.put(air.cosine_texels);
    block.put(air.rule);
    block.align();
    return block.take();
}

std::vector<std::byte> airlight_axis_block(const f32::AirlightAxis& axis) {
    Std140 block(0);
    block.put(axis);
    block.align();
    return block.take();
}

std::vector<float> gpu_texels(const PackedTexels& table, int first) {
    std::vector<float> texels;
    for (std::size_t i = 0; i < table.values.size(); i += static_cast<std::size_t>(pack_size))
        for (int w = 0; w < gpu_wavelengths; ++w)
            texels.push_back(static_cast<float>(table.values[i + static_cast<std::size_t>(first + w)]) / 65535.0f);
    return texels;
}

std::vector<float> gpu_densities(const AirlightTables& tables) {
    std::vector<float> texels;
    for (const f32::Spectrum& row : tables.densities) texels.insert(texels.end(), row.v, row.v + 4);
    return texels;
}

std::vector<float> gpu_phases(const PackPhases& phases, int first) {
    const std::size_t parts = phases.parts().size(), samples = parts > 0 ? phases.samples().size() / parts : 1;
    const std::size_t row = samples * gpu_wavelengths;
    std::vector<float> texels(row * f32::airlight_parts, 0.0f);
    for (std::size_t i = 0; i < parts; ++i)
        for (std::size_t k = 0; k < samples; ++k)
            std::copy_n(phases.samples()[k * parts + i].v + first, gpu_wavelengths, &texels[row * phases.parts()[i] + k * gpu_wavelengths]);
    return texels;
}

}  // namespace airlight
