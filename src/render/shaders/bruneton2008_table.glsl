// A texel of the scattering tables at one altitude.
#include "bruneton2008_bake.glsl"
layout(rgba32f, binding = 0) writeonly uniform image3D scattering;  // [table and altitude][view][nu and sun]

struct TableTexel {
    int view;
    int across;
    float mu_s;
    float nu;
};

// False beyond the last.
bool table_texel(out TableTexel texel, out Way way) {
    int across = table_suns * table_nus, i = int(gl_GlobalInvocationID.x);
    if (i >= table_views * across) return false;
    texel.view = i / across;
    texel.across = i % across;
    texel.mu_s = bruneton2008_chosen_sun_of_coordinate(float(texel.across % table_suns) / float(table_suns - 1), table_twilight != 0);
    way = ways[bake_first * table_views + texel.view];
    // Angles that view and sun cannot make go on as the nearest that they can.
    float sines = sqrt(max((1.0 - way.mu * way.mu) * (1.0 - texel.mu_s * texel.mu_s), 0.0)), middle = way.mu * texel.mu_s;
    texel.nu = clamp(2.0 * float(texel.across / table_suns) / float(table_nus - 1) - 1.0, middle - sines, middle + sines);
    return true;
}

// Roots are kept: between texels, twilight fades by a factor in each degree.
void write_texel(TableTexel texel, Way way, int table, vec4 light) {
    float gain = way.grounded > 0.5 ? bruneton2008_gain(way.end.x) : 1.0;
    imageStore(scattering, ivec3(texel.across, texel.view, table * table_altitudes + bake_first), sqrt(light / gain));
}
