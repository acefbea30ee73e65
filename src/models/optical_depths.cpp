#include "models/optical_depths.h"

#include <algorithm>

#include "core/parallel.h"
#include "physics/models/f64.h"

namespace airlight {

std::vector<f32::Spectrum> optical_depths(const PackAir& air) {
    const f64::Length bottom = f64::Length::of(air.shell.bottom_m), top = f64::Length::of(air.shell.top_m);
    std::vector<f32::Spectrum> depths(depths_across * depths_down);
    parallel_for(depths_down, [&](std::size_t j) {
        const f64::Length h = f64::bruneton2008_altitude_of_coordinate(static_cast<double>(j) / (depths_down - 1), bottom, top);
        RayNodes nodes;
        for (std::size_t i = 0; i < depths_across; ++i) {
            // A hair above the horizon, so that the last ray does not meet the ground by rounding.
            const double mu = std::max(f64::bruneton2008_sky_cosine(h, static_cast<double>(i) / (depths_across - 1), bottom, top).value,
                                       f64::horizon_cosine(h, bottom).value + 1e-12);
            sample_ray(air.shell, {h.value, mu, 1.0, mu}, air.densities, {}, RayNodes::max_per_piece, nodes);
            depths[j * depths_across + i] = optical_depth_of(air, nodes.total_column_m);
        }
    });
    return depths;
}

}  // namespace airlight
