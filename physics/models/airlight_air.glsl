// What the text of physics/models/airlight.glsl is given of an atmosphere.
// Functions take it as their first argument in C++; in GLSL it is a uniform block that they all see, since a structure that is passed
// by value is copied, arrays and all, into each function: declare `WITH_AIRLIGHT_AIR Length h`, call with `AIRLIGHT_AIR h`.

const int airlight_parts = 8;      // constituents, at most
const int airlight_segments = 8;   // of an altitude axis, at most
const int airlight_nodes = 16;     // on a piece of a ray, at most

// The altitudes of a table's texels: segments between jumps of density, between which nothing is interpolated.
struct AirlightAxis {
    int segments;
    int texels;
    Number from[airlight_segments];           // altitude_coordinate of a segment's first texel
    Number inverse_range[airlight_segments];  // of the coordinate over the segment
    Number first[airlight_segments];          // texel
    Number last[airlight_segments];
    Number crowds[airlight_segments];         // 1 where texels crowd towards the segment's upper end, else 0
};

// Gauss's rule on [0, 1].
struct AirlightRule {
    int count;
    Number node[airlight_nodes];
    Number weight[airlight_nodes];
};

// Air at N wavelengths, and how rays through it are integrated.
struct AirlightAir {
    Length bottom;
    Length top;
    int parts;
    ScatteringSpectrum scattering[airlight_parts];  // where the density is 1
    ScatteringSpectrum extinction[airlight_parts];
    InverseLength opacity[airlight_parts];          // the greatest extinction at any wavelength that the ray is shared by
    Spectrum ground_albedo;
    IrradianceSpectrum solar_irradiance;
    Number sun_radius;  // angular; 0 is a point
    AirlightAxis density_axis;
    AirlightAxis transmittance_axis;
    AirlightAxis source_axis;
    // Tables hold values of 0 to 1: the logarithm of the optical depth over least_depth, up to depth_range; and that of the source
    // over the sun's irradiance, from log_low to log_low + log_range.
    Number least_depth;
    Number depth_range;
    Number log_low;
    Number log_range;
    int sun_texels;
    int azimuth_texels;
    int view_texels;
    int cosine_texels;
    AirlightRule rule;
};

#ifdef __cplusplus
#define WITH_AIRLIGHT_AIR IN(AirlightAir) air,
#define AIRLIGHT_AIR air,
#else
layout(std140) uniform AirlightBlock { AirlightAir air; };
#define WITH_AIRLIGHT_AIR
#define AIRLIGHT_AIR
#endif
