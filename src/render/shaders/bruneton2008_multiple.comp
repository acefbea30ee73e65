#version 450 core
// The table of light scattered twice and more, by the sum of all orders of the source.
#include "bruneton2008_table.glsl"
void main() {
    TableTexel texel;
    Way way;
    if (table_texel(texel, way)) write_texel(texel, way, 0, gather_multiple(way, texel.view, texel.mu_s, texel.nu) * air.solar_irradiance);
}
