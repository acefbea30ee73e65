#version 450 core
// The ground as the eye sees it.
#include "terrain_vertex.glsl"
layout(location = 0) out vec3 normal;
layout(location = 1) out vec3 cover;
layout(location = 2) out float height_m;
layout(location = 3) flat out vec2 depth_limits;  // of the triangle

void main() {
    Place p;
    Vertex v = glided_vertex(p);
    normal = v.normal, cover = v.cover, height_m = v.height_m;
    gl_Position = clip_position(v.place);
    float z = gl_Position.w;
    depth_limits = camera_lens.z / max(vec2(z + p.span_m, z - p.span_m), vec2(camera_lens.z));
}
