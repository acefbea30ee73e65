#version 450 core
// The optical depth from each altitude, in each direction, to the top of the air.
#include "bruneton2008_bake.glsl"
layout(std430, binding = 2) readonly buffer Altitudes { float altitude_of[]; };
layout(rgba32f, binding = 0) writeonly uniform image2D depths;

void main() {
    ivec2 size = imageSize(depths);
    int i = int(gl_GlobalInvocationID.x) % size.x, j = int(gl_GlobalInvocationID.x) / size.x;
    if (j >= size.y) return;
    float h = altitude_of[j], mu = transmittance_cosine_of_coordinate(h, float(i) / float(size.x - 1), air.bottom, air.top);
    float start = (air.bottom + h) * mu, end = start + distance_to_top(h, mu, air.bottom, air.top), reach = 0.0;
    AirlightColumns columns;
    for (int p = 0; p < airlight_parts; ++p) columns.of[p] = 0.0;
    for (float x = start; x < end;) {
        float to = airlight_next_cut(densities, h, start, x, end, reach);
        AirlightPiece piece = airlight_piece(h, start, x, to);
        for (int k = 0; k < air.rule.count; ++k)
            airlight_add_columns(densities, piece, k > 0 ? air.rule.node[k - 1] : 0.0, air.rule.node[k], columns);
        airlight_end_piece(densities, piece, columns);
        x = to;
    }
    vec4 depth = vec4(0.0);
    for (int p = 0; p < air.parts; ++p) depth += air.extinction[p] * columns.of[p];
    imageStore(depths, ivec2(i, j), log(max(depth, air.least_depth) / air.least_depth) / air.depth_range);
}
