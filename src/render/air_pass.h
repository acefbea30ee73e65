// The air as one post-process over any scene that fills the geometry buffer: aerial perspective, the sky, the sun's disk, and the light
// of sun and sky on surfaces, by any method of air. From the ground to space. Uses the passes' buffers; knows no method.
//
// Leaves out: a surface has the light of an even sky, none from the planet or other surfaces.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "camera/camera.h"
#include "gpu/buffer.h"
#include "gpu/program.h"
#include "gpu/vertex_array.h"
#include "render/air_method.h"
#include "render/geometry_buffer.h"
#include "render/heavens.h"

namespace airlight::render {

class AirPass {
public:
    // `air` is what `method` was made for.
    static Result<AirPass> create(const ColouredAir& air, std::unique_ptr<AirMethod> method);

    // As AirMethod::begin.
    bool begin(gpu::PassTimers& timers) { return method_->begin(timers); }

    // Makes the tables of the frame that draw() draws. Binds framebuffers of its own. `eclipse`: what takes sunlight from the planet.
    // `night_sky`: whether the light between the stars is scattered and falls on surfaces.
    void prepare(const Camera& camera, Vec3 towards_sun, gpu::PassTimers& timers, const std::optional<Eclipse>& eclipse = {},
                 bool night_sky = false);

    // Draws into the bound framebuffer, whose colours are floats: red, green and blue; alpha means nothing. Its depth is that of
    // `surfaces`, and stays. A CameraBlock of the same camera is bound. Hues beyond the triangle of the primaries have negative parts.
    // `shade`: of ShaftsPass, where anything casts a shadow. `background`: of BackgroundPass, what stands above the air. `water`: whether
    // there may be any, which costs a fifth more.
    // Fails if the method's shader cannot be compiled.
    Result<Done> draw(const GeometryBuffer& surfaces, const gpu::Texture* shade = nullptr, const gpu::Texture* background = nullptr,
                      bool water = true);

    // Adds the light of the air and on surfaces, as if the sun, where prepare() was told that it stands, shone with shares of its light.
    // Fails as draw() does.
    Result<Done> add(const GeometryBuffer& surfaces, Vec3 shares, bool water = true);

    const Atmosphere& atmosphere() const { return atmosphere_; }

private:
    struct View {
        Four eye_up, towards_sun, shell, colour_of_sun, limb_darkening_1, limb_darkening_2, ground_albedo, moon, eclipse, night_scattered,
            night_illuminance;
    };
    AirPass(std::unique_ptr<AirMethod> method, const View& view, Atmosphere atmosphere);
    enum class Part { surfaces, rest };  // what the geometry buffer holds; the sky and the ground sphere
    Result<Done> use_program(Part part, bool water);
    Result<Done> draw_pictures(const GeometryBuffer& surfaces, const gpu::Texture* shade, const gpu::Texture* background, bool water);

    // Drivers that draw on the CPU work off both branches everywhere: what a part of a picture lacks is left out of its text. By whether
    // there are surfaces, water, and a moon before the sun; each is compiled when a picture needs it.
    std::array<std::array<std::array<std::optional<gpu::Program>, 2>, 2>, 2> programs_;
    std::unique_ptr<AirMethod> method_;
    View view_;
    Atmosphere atmosphere_;
    gpu::Buffer view_block_;
    gpu::Texture lit_;  // the shade where there is none
    gpu::Texture covered_sun_;
    gpu::VertexArray triangle_;
};

}  // namespace airlight::render
