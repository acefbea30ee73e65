#version 450 core
// The height of the side away from the sun, where a ray towards it enters.
#include "shadow_block.glsl"
#include "solid_fragment.glsl"

void main() {
    vec4 place = cascade_place[0];
    vec2 at = place.xy + place.w * (2.0 * (gl_FragCoord.xy - vec2(map_corner(0))) / float(shadow_count.y) - 1.0);
    vec3 origin = at.x * light_right.xyz + at.y * light_up.xyz + place.z * light_towards_sun.xyz;
    Crossing c = crossing(drawn_solid(), origin, light_towards_sun.xyz);
    if (c.enters >= c.leaves) discard;
    gl_FragDepth = clamp(c.enters / cascade_depth[0].x, 0.0, 1.0);
}
