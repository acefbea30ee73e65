// What varies on the ground from place to place: octaves of gradient noise of three dimensions [Perlin2002], each four times as wide as the
// one before. A pixel takes three of them, from a few of its own widths on, which come and go with its distance: so a texture is near and
// far at once, repeats nowhere, is cut neither by patches nor by faces of the cube, and is gone before it would alias.
layout(std140, binding = 2) uniform GroundEye {
    uvec4 eye_units;  // the eye in units of 1/64 m from the planet's centre, whole ones modulo 2^32
    vec4 eye_rest;    // and what is left, in units
};
const float units_a_m = 64.0;
// The narrowest octave is a unit wide.
const float narrowest_m = 1.0 / units_a_m;
const float least_pixels = 2.5;         // of a wavelength
// What makes the mean square of the noise's value, and of each component of its gradient, one.
const float of_value = 1.0 / 0.1908, of_gradient = 1.0 / 0.4981;

// A direction for a corner of the noise's lattice: each component is spread evenly from -1 to 1.
vec3 lattice_gradient(uint mixed) {
    uint h = mixed * 0x2c1b3c6du;
    h = (h ^ (h >> 15)) * 0x297a2d39u;
    return vec3(uvec3(h >> 22, h >> 11, h) & uvec3(1023u)) / 511.5 - 1.0;
}

// The noise of an octave at a place relative to the eye: its gradient along the axes of the world, for a wavelength of one, and its value.
vec4 octave_noise(int octave, vec3 place) {
    uint shift = uint(2 * octave), size = 1u << shift;
    vec3 p = (vec3(eye_units.xyz & uvec3(size - 1u)) + eye_rest.xyz + units_a_m * place) / float(size), whole = floor(p), t = p - whole;
    uvec3 period = uvec3(0xffffffffu >> shift), low = (eye_units.xyz >> shift) + uvec3(ivec3(whole));
    const uvec3 primes = uvec3(0x9e3779b1u, 0x85ebca77u, 0xc2b2ae3du);
    uvec3 a = (low & period) * primes + uint(octave), b = ((low + 1u) & period) * primes + uint(octave);
    vec3 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0), slope = 30.0 * t * t * (t * (t - 2.0) + 1.0), s = t - 1.0;
    vec3 g000 = lattice_gradient(a.x ^ a.y ^ a.z), g100 = lattice_gradient(b.x ^ a.y ^ a.z), g010 = lattice_gradient(a.x ^ b.y ^ a.z),
         g110 = lattice_gradient(b.x ^ b.y ^ a.z), g001 = lattice_gradient(a.x ^ a.y ^ b.z), g101 = lattice_gradient(b.x ^ a.y ^ b.z),
         g011 = lattice_gradient(a.x ^ b.y ^ b.z), g111 = lattice_gradient(b.x ^ b.y ^ b.z);
    vec4 v000 = vec4(g000, dot(g000, t)), v100 = vec4(g100, dot(g100, vec3(s.x, t.y, t.z))),
         v010 = vec4(g010, dot(g010, vec3(t.x, s.y, t.z))), v110 = vec4(g110, dot(g110, vec3(s.x, s.y, t.z))),
         v001 = vec4(g001, dot(g001, vec3(t.x, t.y, s.z))), v101 = vec4(g101, dot(g101, vec3(s.x, t.y, s.z))),
         v011 = vec4(g011, dot(g011, vec3(t.x, s.y, s.z))), v111 = vec4(g111, dot(g111, s));
    vec4 x00 = mix(v000, v100, fade.x), x10 = mix(v010, v110, fade.x), x01 = mix(v001, v101, fade.x), x11 = mix(v011, v111, fade.x);
    vec4 xy0 = mix(x00, x10, fade.y), xy1 = mix(x01, x11, fade.y), sum = mix(xy0, xy1, fade.z);
    sum.x += slope.x * mix(mix(v100.w - v000.w, v110.w - v010.w, fade.y), mix(v101.w - v001.w, v111.w - v011.w, fade.y), fade.z);
    sum.y += slope.y * mix(x10.w - x00.w, x11.w - x01.w, fade.z);
    sum.z += slope.z * (xy1.w - xy0.w);
    return sum * vec4(vec3(of_gradient), of_value);
}

// Five numbers that vary each by itself: of mean 0, as often above as below, of a mean square of 0.75 to 1 near the eye, 0 from afar.
struct Detail {
    float grain, patches;
    vec3 slope;  // the gradient of the grain, for a wavelength of one
    vec3 bumps;  // the same with less of what is wide, which the triangles have
};

// At a place relative to the eye, where a pixel is `footprint_m` wide; octaves go up to `widest`.
Detail detail_at(vec3 place, float footprint_m, int widest) {
    float x = max(0.5 * log2(footprint_m * least_pixels / narrowest_m), 0.0), share = fract(x);
    int first = int(x);
    Detail sum = Detail(0.0, 0.0, vec3(0.0), vec3(0.0));
    for (int octave = first; octave <= min(first + 2, widest); ++octave) {
        int i = octave - first;
        float weight = sqrt(0.5) * (i == 0 ? 1.0 - share : i == 1 ? 1.0 : share), bump = 0.5 * (i == 0 ? 2.0 - 2.0 * share : i == 1 ? 1.0 + share : share);
        vec4 whole = octave_noise(octave, place), noise = weight * whole;
        sum.grain += noise.w;
        sum.patches += octave % 2 == 0 ? noise.w : -noise.w;
        sum.slope += noise.xyz;
        sum.bumps += bump * whole.xyz;
    }
    return sum;
}

// Waves of the sea that a pixel shows: their slopes, along the axes of the world, and the share of all waves' mean square that is theirs.
// Octaves up to `widest_wave` hold an eighth of it each, narrower ones than any octave the rest.
struct Waves {
    vec3 slope;
    float share;
};
const int widest_wave = 5;  // 16 m wide: a fresh breeze
const float share_of_octave = 0.125;

// `mean_square`: of the slope of all waves.
Waves waves_at(vec3 place, float footprint_m, float mean_square) {
    float x = max(0.5 * log2(footprint_m * least_pixels / narrowest_m), 0.0), share = fract(x);
    int first = int(x);
    Waves sum = Waves(vec3(0.0), 0.0);
    for (int octave = first; octave <= min(first + 2, widest_wave); ++octave) {
        int i = octave - first;
        float weight = i == 0 ? 1.0 - share : i == 1 ? 1.0 : share;
        sum.slope += weight * sqrt(0.5 * share_of_octave * mean_square) * octave_noise(octave, place).xyz;
        sum.share += weight * weight * share_of_octave;
    }
    return sum;
}
