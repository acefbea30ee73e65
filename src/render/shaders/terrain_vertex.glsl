// A vertex of a patch, where it stands for this eye (src/terrain/level_of_detail.h; glided_position() is this in double).
#include "camera.glsl"
#include "octahedral.glsl"

const int side = 17;          // vertices along a side of a patch
const int step_of_corner = 4; // a side is 2^4 squares
const int words = 10;         // of a TileVertex (src/terrain/tile.h)
const float glide_begin = 0.8;

struct Place {
    uint slot;   // of the tile
    int level;
    ivec2 towards;  // whither vertices glide along each axis: 1 or -1
    float span_m;   // no triangle's corners are farther apart
};
layout(std430, binding = 0) readonly buffer Tiles { uint tile_words[]; };
layout(std430, binding = 1) readonly buffer Places { Place places[]; };
layout(std140, binding = 1) uniform Reach { vec4 reach_m[7]; };

struct Vertex {
    vec3 place;  // relative to the eye
    vec3 normal;
    vec3 cover;  // of the ground (src/terrain/ground_cover.h)
    float height_m;
};

double number_at(uint at) { return packDouble2x32(uvec2(tile_words[at], tile_words[at + 1])); }

// 0 where a vertex of a level stands on its own place, 1 where it has become one of the coarser level.
float glide(int level, float distance_m) {
    if (level <= 0) return 0.0;
    float reach = reach_m[level / 4][level % 4];
    return clamp((distance_m - glide_begin * reach) / (reach - glide_begin * reach), 0.0, 1.0);
}

Vertex vertex_of(Place p, ivec2 at) {
    uint word = uint(((int(p.slot) * side + at.y) * side + at.x) * words);
    Vertex v;
    v.place = vec3(dvec3(number_at(word), number_at(word + 2), number_at(word + 4)) - camera_eye_m.xyz);
    vec3 fine = from_octahedral(unpackUnorm2x16(tile_words[word + 6])), coarse = from_octahedral(unpackUnorm2x16(tile_words[word + 7]));
    v.normal = mix(fine, coarse, glide(p.level, length(v.place)));
    v.height_m = uintBitsToFloat(tile_words[word + 8]);
    v.cover = unpackUnorm4x8(tile_words[word + 9]).rgb;
    return v;
}

// The vertex of this invocation; also gives its patch.
Vertex glided_vertex(out Place patch_place) {
    patch_place = places[gl_InstanceID];
    ivec2 at = ivec2(gl_VertexID % side, gl_VertexID / side);
    precise vec3 place = vec3(0.0);
    Vertex sum = Vertex(vec3(0.0), vec3(0.0), vec3(0.0), 0.0);
    precise float left = 1.0;
    for (int n = 0; n <= step_of_corner && left > 0.0; ++n) {
        Vertex v = vertex_of(patch_place, at);
        int step = findLSB(at.x | at.y | (1 << step_of_corner));
        precise float share = step < step_of_corner ? glide(patch_place.level - step, length(v.place)) : 0.0;
        precise float weight = left * (1.0 - share);
        place += weight * v.place;
        sum.normal += weight * v.normal;
        sum.cover += weight * v.cover;
        sum.height_m += weight * v.height_m;
        left *= share;
        at += patch_place.towards * (at & ivec2(1 << step));
    }
    sum.place = place;
    return sum;
}
