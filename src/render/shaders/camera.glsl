// The camera, and the depth that all passes agree on (src/render/camera_block.h).
// Positions are relative to the eye, along the axes of the world.
layout(std140, binding = 0) uniform CameraBlock {
    dvec4 camera_eye_m;
    vec4 camera_right, camera_up, camera_forward;  // .w of the first two: how far the picture is shifted, in halves of its size
    vec4 camera_lens;  // half width and half height at distance 1; near_m; width of a pixel at distance 1
};

// Where a point appears: its depth is near / distance along the axis.
vec4 clip_position(vec3 p) {
    float ahead = dot(p, camera_forward.xyz);
    return vec4(dot(p, camera_right.xyz) / camera_lens.x - camera_right.w * ahead,
                dot(p, camera_up.xyz) / camera_lens.y - camera_up.w * ahead, camera_lens.z, ahead);
}

// Towards a place of the picture, x to the right and y up from -1 to 1: of length 1 along the camera's axis.
vec3 view_ray(vec2 place) {
    return camera_forward.xyz + (place.x + camera_right.w) * camera_lens.x * camera_right.xyz +
           (place.y + camera_up.w) * camera_lens.y * camera_up.xyz;
}

// The point that was drawn at a place of the picture; depth > 0.
vec3 position_at(vec2 place, float depth) { return view_ray(place) * (camera_lens.z / depth); }
