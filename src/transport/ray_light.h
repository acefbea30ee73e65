// The light that reaches the start of a ray through the air, gathered from the tables of one pack.
// Theory: docs/theory.md, section 5.5. Uses pack tables and ray nodes.
#pragma once

#include <array>
#include <vector>

#include "transport/pack_tables.h"

namespace airlight {

// Light that reaches the start of a ray, apart from the sun's disk itself.
struct RayLight {
    f32::RadianceSpectrum multiple;                         // two and more scatterings, and light from the ground
    std::array<f32::IrradianceSpectrum, max_parts> single;  // one scattering in each constituent; times its phase function it is radiance
    f32::Spectrum transmittance;                            // to the end of the ray
};

// What the light along a ray is gathered from.
struct Gathered {
    bool single = true;
    const Table<f32::RadianceSpectrum, 4>* source = nullptr;               // of higher orders; null: none
    const Table<f32::IrradianceSpectrum, 2>* diffuse_on_ground = nullptr;  // null: none
    bool direct_on_ground = true;
};

// Integrates along `nodes`, a ray whose cosine to the sun is `nu`.
RayLight gather(const PackAir& air, const Table<f32::Spectrum, 2>& transmittance, const Gathered& what, const RayNodes& nodes, float nu);

// A ray of which all that does not depend on the sun is worked out once, for gathering under many suns.
// Its nodes know of no shadow, so single scattering is answered only where all of it, or nothing of it, is lit.
class PreparedRay {
public:
    // `source_size`: of the table that higher orders will be gathered from.
    PreparedRay(const PackAir& air, double altitude_m, double mu, int nodes_per_piece, const std::array<int, 4>& source_size);

    // Higher orders and light from the ground.
    f32::RadianceSpectrum multiple(const PackAir& air, const Table<f32::Spectrum, 2>& transmittance, const Gathered& what, float mu_s,
                                   float nu) const;

    // Whether all of the ray stands in sunlight that grazed no dense air, nothing of it is lit, or neither.
    enum class Lit { all, nothing, part };
    Lit lit(const PackAir& air, float mu_s, float nu) const;

    // One scattering in each constituent, as RayLight::single; for a ray that is all lit.
    void single(const PackAir& air, const Table<f32::Spectrum, 2>& transmittance, float mu_s, float nu,
                std::array<f32::IrradianceSpectrum, max_parts>& light) const;

private:
    // A node, with its place in the tables.
    struct Node {
        f32::LengthSpectrum seen;  // transmittance from the start, times the length it stands for
        f32::Spectrum scattering;  // the same times the scattering coefficient
        std::array<float, max_parts> density;
        float altitude_m;
        float mu;
        float sine;  // of the ray's zenith angle
        float distance_m;
        float inverse_radius;  // in 1/m
        float horizon;         // cosine of the zenith angle of the horizon
        float clear_horizon;   // the same of the outermost of shadow_edges
        Texels view;           // of the source
        Texels altitude;
    };
    float sun_cosine(const Node& node, float mu_s, float nu) const {
        return (radius_m_ * mu_s + nu * node.distance_m) * node.inverse_radius;
    }

    std::vector<Node> nodes_;
    float radius_m_;  // of the start
    bool meets_ground_;
    float end_distance_m_;
    float end_inverse_radius_;
    f32::Spectrum transmittance_;
};

}  // namespace airlight
