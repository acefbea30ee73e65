// A direction in two numbers from 0 to 1: the sphere unfolded over an octahedron into a square [Cigolle2014, section 4].
// The same map as src/terrain/octahedral.h.
vec2 sign_of(vec2 x) { return vec2(x.x < 0.0 ? -1.0 : 1.0, x.y < 0.0 ? -1.0 : 1.0); }

vec2 octahedral(vec3 d) {
    vec2 p = d.xy / (abs(d.x) + abs(d.y) + abs(d.z));
    if (d.z < 0.0) p = (1.0 - abs(p.yx)) * sign_of(p);
    return 0.5 * p + 0.5;
}

vec3 from_octahedral(vec2 packed_direction) {
    vec2 p = 2.0 * packed_direction - 1.0;
    float z = 1.0 - abs(p.x) - abs(p.y);
    if (z < 0.0) p = (1.0 - abs(p.yx)) * sign_of(p);
    return normalize(vec3(p, z));
}
