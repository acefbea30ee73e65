#version 450 core
// The light along each ray of the grid of air_rays.glsl, up to each layer of places on its way: marched by the model `airlight`, four
// wavelengths at a time, which add up to colours.
#include "air_rays.glsl"
#include "air_wavelengths.glsl"
layout(local_size_x = 8, local_size_y = 2) in;
layout(binding = 0, rgba32f) uniform image3D smooth_light;
layout(binding = 1, rgba32f) uniform image3D peaked_light;
layout(binding = 2, rgba32f) uniform image3D missing_light;
layout(binding = 3, rgba32f) uniform image3D once_share;
layout(binding = 13) uniform sampler2D peak;  // the reference phase function of what has a peak, even in the root of the scattering angle
layout(std430, binding = 5) readonly buffer AirWays {
    vec4 ways[];  // of each row: zenith cosine at the eye, and where the ray enters the air; empty way before it; length in the air, negative
                  // if the ground ends it
};
layout(std140, binding = 6) uniform AirShare {
    ivec4 share;        // 1 in the first and in the last of the groups of wavelengths
    vec4 peaked[2];     // 1 for each constituent whose phase function has a peak
};

struct Way {
    AirlightRay ray;
    float length;
    bool grounded;
    float angle;  // between the ray and the sun
};

Way way_of(int row, int azimuth) {
    vec4 w = ways[row];
    float mu = w.x, mu_s = dot(eye_up.xyz, towards_sun.xyz), h = max(eye_up.w, 0.0);
    float cos_azimuth = azimuth_cosine_of_coordinate(float(azimuth) / float(ray_counts.y - 1));
    float nu = clamp(mu * mu_s + sqrt(max((1.0 - mu * mu) * (1.0 - mu_s * mu_s), 0.0)) * cos_azimuth, -1.0, 1.0);
    Way way;
    way.ray.h = min(h, air.top);
    way.ray.mu = w.y;
    way.ray.mu_s = clamp(((air.bottom + h) * mu_s + nu * w.z) / (air.bottom + way.ray.h), -1.0, 1.0);
    way.ray.nu = nu;
    way.length = abs(w.w);
    way.grounded = w.w < 0.0;
    way.angle = acos(nu);
    return way;
}

// Adds the light between two places, in signed distances from the perigee of a ray that starts at `start`.
void march(AirlightRay ray, float start, float from, float to, inout AirlightColumns columns, inout AirlightSums sums) {
    float reach = 0.0;
    for (float x = from; x < to;) {
        float next = airlight_next_cut(densities, ray.h, start, x, to, reach);
        next = airlight_shadow_cut(ray, x, next);
        AirlightPiece piece = airlight_piece(ray.h, start, x, next);
        for (int k = 0; k < air.rule.count; ++k) {
            AirlightNode node = airlight_node(densities, start, piece, k, columns);
            airlight_gather(transmittance, source, ray, node, sums);
        }
        airlight_end_piece(densities, piece, columns);
        x = next;
    }
}

// 1 - e^-depth without cancellation.
Spectrum taken(Spectrum depth) {
    return mix(1.0 - exp(-depth), depth * (1.0 - depth * (0.5 - depth / 6.0)), lessThan(depth, Spectrum(0.03)));
}

// Adds these wavelengths' share of a texel. The last one makes of the sums what interpolates well: light over the share of light that
// the way takes, in units of a scale whose logarithm is kept, since twilight fades by powers of ten; and the mean extinction.
void add(ivec3 texel, Way way, float distance, AirlightColumns columns, AirlightSums sums) {
    AirlightLight light = airlight_summed(sums, columns);
    RadianceSpectrum even = Spectrum(0.0), peaks = Spectrum(0.0);  // scattered once
    for (int p = 0; p < airlight_parts; ++p)
        if (p < air.parts) {
            RadianceSpectrum scattered = light.single[p] * phase_of(p, way.angle);
            if (peaked[p / 4][p % 4] > 0.0) peaks += scattered;
            else even += scattered;
        }
    float x = texture_coordinate(sqrt(way.angle / pi), textureSize(peak, 0).x);
    vec3 once = colour_of(even), smooth_sum = once + colour_of(light.multiple), peaked_sum = colour_of(peaks) / look_up(peak, vec2(x, 0.5)).r;
    vec3 missing = colour_of(air.solar_irradiance * taken(airlight_depth(columns))) / colour_of_sun.rgb;
    if (share.x == 0) {
        smooth_sum += imageLoad(smooth_light, texel).rgb;
        peaked_sum += imageLoad(peaked_light, texel).rgb;
        missing += imageLoad(missing_light, texel).rgb;
        once += imageLoad(once_share, texel).rgb;
    }
    float scale = 0.0;
    if (share.y == 1) {
        once = clamp(once / max(smooth_sum, 1e-30), 0.0, 1.0);
        vec3 taken = max(missing, vec3(1e-9)), over = smooth_sum / taken;
        float brightest = max(max(over.r, over.g), max(over.b, 1e-20));
        scale = log(brightest);
        smooth_sum = over / brightest;
        peaked_sum /= taken * brightest;
        missing = mix(-log(max(1.0 - missing, vec3(1e-6))), missing * (1.0 + 0.5 * missing), lessThan(missing, vec3(1e-3))) / distance;
    }
    imageStore(smooth_light, texel, vec4(smooth_sum, scale));
    imageStore(peaked_light, texel, vec4(peaked_sum, 0.0));
    imageStore(missing_light, texel, vec4(missing, 0.0));
    imageStore(once_share, texel, vec4(once, 0.0));
}

void main() {
    ivec2 place = ivec2(gl_GlobalInvocationID.xy);
    if (place.x >= ray_counts.y || place.y >= ray_counts.z) return;
    Way way = way_of(place.y, place.x);
    float start = (air.bottom + way.ray.h) * way.ray.mu, distance = 0.0;
    AirlightColumns columns;
    for (int p = 0; p < airlight_parts; ++p) columns.of[p] = 0.0;
    AirlightSums sums = airlight_nothing();
    for (int i = 0; i <= ray_counts.w; ++i) {
        float before = distance, wanted = float(i) / float(ray_counts.w);
        if (i == 0) distance = 1e-3 * way.length / float(ray_counts.w);  // the eye itself
        else if (i == ray_counts.w) distance = way.length;
        else
            for (int step = 0; step < 6; ++step)  // Newton's
                distance = clamp(distance + (wanted - layer_place(distance, way.length, way.grounded)) /
                                                layer_slope(distance, way.length, way.grounded),
                                 before, way.length);
        march(way.ray, start, start + before, start + distance, columns, sums);
        add(ivec3(place, i), way, distance, columns, sums);
    }
}
