// A corner of the box about a sphere, a box or a cylinder, a little larger than it, and what its pixels' rays need.
#include "object.glsl"
layout(location = 0) flat out vec4 right_and_shape;
layout(location = 1) flat out vec4 forward_and_beyond;
layout(location = 2) flat out vec3 up;
layout(location = 3) flat out vec3 low;
layout(location = 4) flat out vec3 high;
layout(location = 5) flat out vec3 reflectance;

// Gives the corner relative to the eye.
vec3 solid_corner() {
    Object o = objects[gl_InstanceID];
    dvec3 from_eye = o.centre_m.xyz - camera_eye_m.xyz, half_size = dvec3(o.right.w, o.forward.w, o.up.w);
    dvec3 middle = dvec3(dot(from_eye, o.right.xyz), dot(from_eye, o.forward.xyz), dot(from_eye, o.up.xyz));
    low = vec3(middle - half_size), high = vec3(middle + half_size), reflectance = o.reflectance.rgb;
    double height = o.centre_m.w == 0.0 ? middle.z : 0.0lf;  // a cylinder's counts for nothing
    double beyond = middle.x * middle.x + middle.y * middle.y + height * height - half_size.x * half_size.x;
    mat3 axes = axes_of(o);
    right_and_shape = vec4(axes[0], float(o.centre_m.w)), forward_and_beyond = vec4(axes[1], float(beyond)), up = axes[2];
    const float larger = 1.001;
    return place_on(o, dvec3(larger * (2.0 * vec3(gl_VertexID & 1, gl_VertexID >> 1 & 1, gl_VertexID >> 2 & 1) - 1.0)));
}
