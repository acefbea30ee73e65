// Slices through the eye that contain the light's direction: each crosses the shadow maps along a line, on which the ground is a curve,
// and each ray of a slice is seen from the sun as a part of that line [Engelhardt2010; Chen2011]. A ray's height along the light over its
// distance across it is one number, its slope: ground on the line that stands higher than the ray has a greater slope.
layout(std140, binding = 5) uniform Slices {
    vec4 slice_angles;    // the first slice's, about the light; between slices; the farthest distance across the light
    ivec4 slice_counts;   // slices; places on each; places of a block; 1 if the last slice is beside the first
};

const int blocks_of_span = 8;

// Places crowd towards the eye.
float across_light(float place) {
    float t = place / float(slice_counts.y);
    return slice_angles.z * (t * t) * (t * t) * t;
}
float place_across(float across) { return pow(clamp(across / slice_angles.z, 0.0, 1.0), 0.2) * float(slice_counts.y); }
