#version 450 core
// The ground and the sea into the geometry buffer.
#include "camera.glsl"
#include "geometry_buffer.glsl"
#include "ground.glsl"
layout(location = 0) in vec3 normal;
layout(location = 1) in vec4 cover;
layout(location = 2) in float height_m;
layout(location = 3) in vec3 place;
layout(location = 4) flat in vec2 depth_limits;

const float rough_sea = 0.2, rough_land = 1.0;
const float widest_shore_m = 10.0;  // of heights in a pixel

// How wide a pixel is on the ground: between its width and its length, which on ground that is seen at a low angle are far apart.
float footprint_m() {
    vec3 across = dFdx(place), along = dFdy(place);
    float longest = max(dot(across, across), dot(along, along)), area = length(cross(across, along));
    return max(sqrt(area), sqrt(longest) / 3.0);
}

void main() {
    // A triangle seen edge-on, at a limb, is narrower than the rasterizer's steps: its depth between corners is then anything.
    gl_FragDepth = clamp(gl_FragCoord.z, depth_limits.x, depth_limits.y);
    float shore_m = clamp(fwidth(height_m), 1e-3, widest_shore_m), footprint = footprint_m();
    float water = ground_wishes.x * clamp(0.5 - height_m / shore_m, 0.0, 1.0);
    vec3 reflectance;
    if (ground_wishes.y > 0.0) reflectance = image_reflectance(normalize(vec3(camera_eye_m.xyz) + place), footprint);
    else reflectance = mix(covered_reflectance(cover), ground_reflectance[sea].rgb, water);
    write_surface(reflectance, normalize(normal), mix(rough_land, rough_sea, water), water);
}
