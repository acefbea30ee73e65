// A way to compute the light of the air for a frame: a text that answers for rays, and what it reads. docs/decisions/0010-air-methods.md
// says what the text must answer. Uses gpu.
#pragma once

#include <array>
#include <span>
#include <string>

#include "atmosphere/atmosphere.h"
#include "gpu/pass_timers.h"
#include "render/air_eye.h"
#include "units/vector.h"

namespace airlight::render {

// An atmosphere whose ground sphere is the planet's, and what its light looks like: the colour of radiance at each wavelength, red,
// green and blue, as ColourWeights says.
struct ColouredAir {
    const Atmosphere& atmosphere;
    std::span<const Wavelength> wavelengths;
    std::span<const Vec3> colours;
};

// Bindings that a method may use, and of the block of physics/models/airlight_air.glsl.
inline constexpr unsigned first_method_texture = 8, airlight_block_binding = 1;

// A vector and a number as std140 has them.
using Four = std::array<float, 4>;
inline Four four(Vec3 v, double w) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), static_cast<float>(w)};
}

class AirMethod {
public:
    virtual ~AirMethod() = default;

    // The fragment shader of the picture: "air_exact.frag".
    virtual std::string shader() const = 0;
    // Does a part of what the first picture would wait for, as much as fits between two pictures. Whether nothing of it is left.
    virtual bool begin(gpu::PassTimers&) { return true; }
    // Makes what depends on the eye and the sun, in textures of its own. Each pass is timed by its name. An AirView is bound.
    virtual void prepare(const AirEye& eye, gpu::PassTimers& timers) = 0;
    // How many pictures add up, and what the shader reads for each of them.
    virtual int pictures() const = 0;
    virtual void bind(int picture) const = 0;
};

}  // namespace airlight::render
