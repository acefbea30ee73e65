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
    // `colours`: of radiance at each wavelength of `bake`. The first picture waits for all of its slices.
    Bruneton2008Air(Bruneton2008Bake bake, std::span<const Vec3> colours);

    // Other tables, which are filled between the pictures that follow, some slices before each; until then the old ones are drawn.
    void replace(Bruneton2008Bake bake, std::span<const Vec3> colours);
    // Whether the newest tables are drawn.
    bool up_to_date() const { return !next_; }

    std::string shader() const override { return "bruneton2008_air.frag"; }
    void prepare(const AirEye& eye, gpu::PassTimers& timers) override;
    int pictures() const override;
    void bind(int picture) const override;

private:
    struct Tables {
        Bruneton2008Textures textures;
        std::vector<gpu::Buffer> colours;  // of each group
        gpu::Buffer block;
    };
    struct Next {
        Bruneton2008Bake bake;
        std::vector<Vec3> colours;
    };
    std::optional<Tables> tables_;  // none before the first picture
    std::optional<Next> next_;
};

}  // namespace airlight::render
