// What the passes that fill the tables of bruneton2008 have in common (src/render/bruneton2008_tables.h). All light is over the sun's
// irradiance. A pass works from the altitude `bake_first` on.
#include "physics/readings/glsl.glsl"
#include "physics/shell.glsl"
#include "physics/maps.glsl"
#include "physics/models/bruneton2008.glsl"
#include "physics/models/airlight_air.glsl"
#include "physics/models/airlight.glsl"
layout(local_size_x = 64) in;
layout(binding = 0) uniform sampler2D densities;
layout(binding = 1) uniform sampler2D transmittance;
layout(binding = 2) uniform sampler3D source;      // of the light that is gathered
layout(binding = 3) uniform sampler2D diffuse;     // irradiance of the ground by the same light
layout(binding = 4) uniform sampler2D soft_phases;  // [constituent that scatters][sample], of the harmonics that light is scattered in
layout(std140, binding = 2) uniform BakeBlock {
    int bake_suns, bake_azimuths, bake_angles, bake_altitudes;  // directions around points
    int bake_degree;                                            // of harmonics
    int bake_capacity;                                          // nodes of a way, at most
    int bake_scatterers;                                        // constituents that scatter
    int bake_order;                                             // of the light that is gathered
    int table_views, table_suns, table_nus, table_altitudes;    // of the scattering tables
    int bake_first;                                             // altitude, of points or of the tables
    int table_twilight;                                         // which axis the sun has
    int bake_padding_0, bake_padding_1;
    ivec4 bake_part_of[2];                                      // the constituents that scatter
};

// A direction at an altitude, and its way through the air.
struct Way {
    float h;
    float mu;
    float grounded;  // 1 where it ends at the ground
    float nodes;
    vec4 end;            // its distance
    vec4 transmittance;  // of all of it
};
struct WayNode {
    vec4 place;              // altitude, zenith cosine of the ray there, distance from its start
    vec4 seen;               // transmittance from the start, times the length that the node stands for
    vec4 scattering;         // times the scattering coefficient of all constituents
    vec4 density_low;        // of each constituent that scatters
    vec4 density_high;
};
layout(std430, binding = 0) buffer Ways { Way ways[]; };           // [altitude][direction]
layout(std430, binding = 1) buffer WayNodes { WayNode way_nodes[]; };  // [direction][bake_capacity], of one altitude

// Zenith cosine of the sun at a distance along a ray, where the altitude is `h`.
float sun_along(float h_start, float mu_s, float nu, float distance_m, float h) {
    return sun_cosine_at(h_start, mu_s, nu, distance_m, h, air.bottom);
}

struct OnceScattered {
    vec4 by[airlight_parts];  // over coefficient and phase function, of each constituent that scatters
};

OnceScattered gather_single(Way way, int direction, float mu_s, float nu) {
    OnceScattered sum;
    for (int i = 0; i < airlight_parts; ++i) sum.by[i] = vec4(0.0);
    int first = direction * bake_capacity, last = first + int(way.nodes);
    for (int k = first; k < last; ++k) {
        vec4 place = way_nodes[k].place;
        vec4 lit = airlight_sunlight(transmittance, place.x, sun_along(way.h, mu_s, nu, place.z, place.x)) * way_nodes[k].seen;
        vec4 low = way_nodes[k].density_low;
        for (int i = 0; i < 4; ++i) sum.by[i] += lit * low[i];
        if (bake_scatterers > 4) {
            vec4 high = way_nodes[k].density_high;
            for (int i = 0; i < 4; ++i) sum.by[4 + i] += lit * high[i];
        }
    }
    return sum;
}

vec4 gather_multiple(Way way, int direction, float mu_s, float nu) {
    vec4 sum = vec4(0.0);
    int first = direction * bake_capacity, last = first + int(way.nodes);
    for (int k = first; k < last; ++k) {
        vec4 place = way_nodes[k].place;
        sum += airlight_source(source, place.x, place.y, sun_along(way.h, mu_s, nu, place.z, place.x), nu) * way_nodes[k].scattering;
    }
    return sum;
}

// Light over the sun's irradiance as tables hold it.
vec4 logarithm_of(vec4 light) { return clamp((log(max(light, vec4(1e-30))) - air.log_low) / air.log_range, 0.0, 1.0); }
