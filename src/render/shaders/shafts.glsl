// What every method of light shafts writes: the share of the light scattered once towards the eye that stays where ground shades the air,
// in red, green and blue; in alpha, the share of the sun's light that reaches the pixel's surface. A method's text answers
//
//   vec3 lit_share(vec2 place, vec3 direction, AirRay start, float way, vec2 part)
//
// of a ray from the start of its air over a distance, of which a part may be shaded.
#include "camera.glsl"
#include "shadow.glsl"
layout(binding = 0) uniform sampler2D depth_buffer;
layout(location = 0) in vec2 place;
layout(location = 0) out vec4 shade;

void main() {
    float depth = texelFetch(depth_buffer, ivec2(gl_FragCoord.xy), 0).r;
    vec3 position = depth > 0.0 ? position_at(place, depth) : vec3(0.0), direction = normalize(view_ray(place));
    shade = vec4(1.0);
    if (depth > 0.0) shade.a = sun_visibility(position);
    AirRay start;
    if (!enter_air(direction, start)) return;
    float way = way_in_air(start, depth > 0.0 ? length(position) : 1e30);
    vec2 part = shaded_part(start, way);
    if (part.y > part.x) shade.rgb = lit_share(place, direction, start, way, part);
}
