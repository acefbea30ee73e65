#version 450 core
// A sphere, a box or a cylinder into the geometry buffer.
#include "camera.glsl"
#include "geometry_buffer.glsl"
#include "solid_fragment.glsl"

void main() {
    vec3 direction = normalize(view_ray(gl_FragCoord.xy * camera_lens.w / camera_lens.xy - 1.0));
    Solid solid = drawn_solid();
    Crossing c = crossing(solid, vec3(0.0), direction);
    float along_axis = c.enters * dot(direction, camera_forward.xyz);
    if (c.enters >= c.leaves || along_axis < camera_lens.z) discard;
    gl_FragDepth = camera_lens.z / along_axis;
    write_surface(reflectance, normalize(solid.axes * c.normal), 1.0, 0.0);
}
