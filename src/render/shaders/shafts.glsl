// What every method of light shafts writes for a ray: the share of the light scattered once towards the eye that stays where ground shades
// the air, in red, green and blue; in alpha, the logarithm of how far the ray goes. A method's text answers
//
//   vec3 lit_share(vec2 place, vec3 direction, AirRay start, float way, vec2 part)
//
// of a ray from the start of its air over a distance, of which a part may be shaded.
#include "camera.glsl"
layout(binding = 0) uniform sampler2D depth_buffer;
layout(std140, binding = 6) uniform ShaftsRays { ivec4 pixels_of_ray; };  // across and up: a ray is that of the lowest pixel on the left
layout(location = 0) out vec4 lit;

void main() {
    ivec2 size = textureSize(depth_buffer, 0), pixel = min(ivec2(gl_FragCoord.xy) * pixels_of_ray.x, size - 1);
    vec2 place = (vec2(pixel) + 0.5) / vec2(size) * 2.0 - 1.0;
    float depth = texelFetch(depth_buffer, pixel, 0).r;
    vec3 direction = normalize(view_ray(place));
    float distance_m = depth > 0.0 ? length(position_at(place, depth)) : 1e30;
    lit = vec4(1.0, 1.0, 1.0, log(distance_m));
    AirRay start;
    if (!enter_air(direction, start)) return;
    float way = way_in_air(start, distance_m);
    vec2 part = shaded_part(start, way);
    if (part.y > part.x) lit.rgb = lit_share(place, direction, start, way, part);
}
