// The rest of a program that marches: air_march.glsl.
Way way_of(int row, int azimuth) {
    vec4 w = ways[row];
    float bottom = air_shell.x, h = ray_eye.x, mu_s = ray_eye.z;
    float cos_azimuth = azimuth_cosine_of_coordinate(float(azimuth) / float(ray_counts.y - 1));
    Way way;
    way.nu = clamp(w.x * mu_s + sqrt(max((1.0 - w.x * w.x) * (1.0 - mu_s * mu_s), 0.0)) * cos_azimuth, -1.0, 1.0);
    way.h = min(h, air_shell.y);
    way.mu = w.y;
    way.mu_s = clamp(((bottom + h) * mu_s + way.nu * w.z) / (bottom + way.h), -1.0, 1.0);
    way.extent = abs(w.w);
    way.grounded = w.w < 0.0;
    way.angle = acos(way.nu);
    return way;
}

// Adds these wavelengths' share of a texel. The last one makes of the sums what interpolates well: light over the share of light that
// the way takes, in units of a scale whose logarithm is kept, since twilight fades by powers of ten; and the mean extinction.
void keep(ivec3 texel, Way way, float distance, Colours light) {
    float x = peak_coordinate(sin(0.5 * way.angle), textureSize(peak, 0).x);
    vec3 once = light.once, even = once + light.more, peaks = light.peaks / look_up(peak, vec2(x, 0.5)).r, taken = light.taken;
    ivec3 next = ivec3(imageSize(rays).x / ray_parts, 0, 0);
    ivec3 smooth_texel = texel + ray_smooth * next, peaked_texel = texel + ray_peaked * next;
    ivec3 extinction_texel = texel + ray_extinction * next, once_texel = texel + ray_once * next;
    if (share.x == 0) {
        even += imageLoad(rays, smooth_texel).rgb;
        peaks += imageLoad(rays, peaked_texel).rgb;
        taken += imageLoad(rays, extinction_texel).rgb;
        once += imageLoad(rays, once_texel).rgb;
    }
    float scale = 0.0;
    if (share.y == 1) {
        once = clamp(once / max(even, 1e-30), 0.0, 1.0);
        // Where hardly anything is taken, rounding and the primaries' negative parts may leave nothing of a colour.
        vec3 some = max(taken, vec3(max((taken.r + taken.g + taken.b) / 60.0, 1e-9)));
        even /= some;
        float brightest = max(max(even.r, even.g), max(even.b, 1e-20));
        scale = log(brightest);
        even /= brightest;
        peaks /= some * brightest;
        taken = mix(-log(max(1.0 - taken, vec3(1e-6))), taken * (1.0 + 0.5 * taken), lessThan(taken, vec3(1e-3))) / distance;
    }
    imageStore(rays, smooth_texel, vec4(even, scale));
    imageStore(rays, peaked_texel, vec4(peaks, 0.0));
    imageStore(rays, extinction_texel, vec4(taken, 0.0));
    imageStore(rays, once_texel, vec4(once, 0.0));
}

void main() {
    ivec2 place = ivec2(gl_GlobalInvocationID.xy);
    if (place.x >= ray_counts.y || place.y >= ray_counts.z) return;
    Way way = way_of(place.y, place.x);
    float distance = 0.0;
    Gathered gathered = nothing_gathered();
    for (int i = 0; i <= ray_counts.w; ++i) {
        float before = distance, wanted = float(i) / float(ray_counts.w);
        if (i == 0) distance = 1e-3 * way.extent / float(ray_counts.w);  // the eye itself
        else if (i == ray_counts.w) distance = way.extent;
        else
            for (int step = 0; step < 6; ++step)  // Newton's
                distance = clamp(distance + (wanted - layer_place(distance, way.extent, way.grounded)) /
                                                layer_slope(distance, way.extent, way.grounded),
                                 before, way.extent);
        gather(way, before, distance, gathered);
        keep(ivec3(place, i), way, distance, colours_of(way, gathered));
    }
}
