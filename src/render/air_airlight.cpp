#include "render/air_airlight.h"

#include <cassert>
#include <utility>

#include "models/airlight_tables.h"
#include "render/air_ray_grid.h"
#include "render/air_wavelengths.h"
#include "render/shaders.h"

namespace airlight::render {

namespace {

// Of a piece of a ray between two layers.
constexpr int nodes_per_piece = 2;

f32::Number part_of(int i, int count) { return f32::Number(static_cast<double>(i) / (count - 1)); }

AirRayGrid grid_of(const Tables& tables, std::span<const Vec3> colours) {
    AirRayGrid::Air air{{}, colours};
    std::vector<AirlightTables> packs;
    for (const Tables::Pack& pack : tables.packs()) {
        air.packs.push_back(pack.optics);
        packs.push_back(airlight_tables(pack, nodes_per_piece));
    }
    const PackLight sunlight = [&](std::size_t p, int i, int j) {
        const AirlightTables& t = packs[p];
        const f32::Length h = f32::altitude_of_coordinate(part_of(j, AirRayGrid::sunlight_altitudes), t.air.top);
        const f32::Number mu =
            f32::transmittance_cosine_of_coordinate(h, part_of(i, AirRayGrid::sunlight_cosines), t.air.bottom, t.air.top);
        return f32::airlight_upward(t.air, t.transmittance_table(), h, mu) * t.air.solar_irradiance;
    };
    const PackLight skylight = [&](std::size_t p, int i, int j) {
        const AirlightTables& t = packs[p];
        const auto upward = [&](f32::Length h) { return f32::airlight_upward(t.air, t.transmittance_table(), h, f32::Number(1.0f)); };
        const f32::Length h = f32::altitude_of_coordinate(part_of(j, AirRayGrid::skylight_altitudes), t.air.top);
        return t.diffuse_on_ground(f32::sun_of_coordinate(part_of(i, AirRayGrid::skylight_suns)).value) *
               AirRayGrid::skylight_left(upward(h), upward(0.0f * f32::m));
    };
    return AirRayGrid(air, tables.packs()[0].air.densities.jumps_m(), sunlight, skylight);
}

}  // namespace

Result<std::unique_ptr<AirMethod>> airlight_air(const Tables& tables, std::span<const Vec3> colours) {
    assert(colours.size() == tables.wavelengths().size());
    Result<gpu::Program> march = compute_program("air_airlight.comp");
    if (!march) return march.error();
    march->bind_block("AirlightBlock", airlight_block_binding);
    return AirOfRays<AirWavelengths>::create(*std::move(march), air_wavelengths(tables, colours, nodes_per_piece),
                                             grid_of(tables, colours));
}

}  // namespace airlight::render
