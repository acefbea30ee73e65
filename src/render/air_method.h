// A way to compute the light of the air for a frame: a text that answers for rays, and what it reads. docs/decisions/0010-air-methods.md
// says what the text must answer. Uses gpu and camera.
#pragma once

#include <span>
#include <string>

#include "atmosphere/atmosphere.h"
#include "camera/camera.h"
#include "gpu/pass_timers.h"

namespace airlight::render {

// An atmosphere whose ground sphere is the planet's, and what its light looks like: the colour of radiance at each wavelength, red,
// green and blue, as ColourWeights says.
struct ColouredAir {
    const Atmosphere& atmosphere;
    std::span<const Wavelength> wavelengths;
    std::span<const Vec3> colours;
};

class AirMethod {
public:
    virtual ~AirMethod() = default;

    // The fragment shader of the picture: "air_exact.frag".
    virtual std::string shader() const = 0;
    // Makes what depends on the eye and the sun; `towards_sun` is of length one. Each pass is timed by its name. Draws and dispatches
    // to textures of its own.
    virtual void prepare(const Camera& camera, Vec3 towards_sun, gpu::PassTimers& timers) = 0;
    // How many pictures add up, and what the shader reads for each of them.
    virtual int pictures() const = 0;
    virtual void bind(int picture) const = 0;
};

}  // namespace airlight::render
