// The air by the tables of bruneton2008: two look-ups for what is before a surface, one for the sky, four wavelengths at a time.
// From the ground to space. Uses bruneton2008_tables.h.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "render/air_method.h"
#include "render/bruneton2008_tables.h"

namespace airlight::render {

class Bruneton2008Air : public AirMethod {
public:
    // `colours`: of radiance at each wavelength of `bake`, whose slices begin() does, or the first picture.
    Bruneton2008Air(Bruneton2008Bake bake, std::span<const Vec3> colours);

    std::string shader() const override { return "bruneton2008_air.frag"; }
    bool begin(gpu::PassTimers& timers) override;
    void prepare(const AirEye& eye, gpu::PassTimers& timers) override;
    int pictures() const override;
    void bind(int picture) const override;

private:
    struct Tables {
        Bruneton2008Textures textures;
        std::vector<gpu::Buffer> colours;  // of each group
        gpu::Buffer block;
    };
    void advance(gpu::PassTimers& timers);

    std::vector<Vec3> colours_;
    std::optional<Bruneton2008Bake> bake_;  // until all slices are done
    std::optional<Tables> tables_;          // then
};

}  // namespace airlight::render
