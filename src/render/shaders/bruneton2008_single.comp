#version 450 core
// The tables of single scattering, one for each constituent: without its phase function.
#include "bruneton2008_table.glsl"
void main() {
    TableTexel texel;
    Way way;
    if (!table_texel(texel, way)) return;
    OnceScattered once = gather_single(way, texel.view, texel.mu_s, texel.nu);
    for (int i = 0; i < bake_scatterers; ++i)
        write_texel(texel, way, 1 + i, once.by[i] * air.scattering[bake_part_of[i / 4][i % 4]] * air.solar_irradiance);
}
