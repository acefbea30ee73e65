#include "render/air_pass.h"

#include <epoxy/gl.h>

#include <array>
#include <cassert>
#include <utility>

#include "render/shaders.h"

namespace airlight::render {

namespace {

constexpr unsigned view_binding = 2;

// The colour of the sun's light of which a share is taken at each wavelength.
template <class Share>
Vec3 colour_of_sun(const ColouredAir& air, Share share) {
    Vec3 sum(0.0);
    for (std::size_t w = 0; w < air.wavelengths.size(); ++w)
        sum += air.colours[w] * (air.atmosphere.sun.irradiance.at(air.wavelengths[w]).value * share(air.wavelengths[w]));
    return sum;
}

}  // namespace

Result<AirPass> AirPass::create(const ColouredAir& air, std::unique_ptr<AirMethod> method) {
    assert(air.colours.size() == air.wavelengths.size());
    Result<gpu::Program> made = program("fullscreen.vert", method->shader());
    if (!made) return made.error();
    made->bind_block("AirlightBlock", airlight_block_binding);
    const Sun& sun = air.atmosphere.sun;
    const Vec3 whole = colour_of_sun(air, [](Wavelength) { return 1.0; });
    const auto mean = [&](const SpectrumOf<Number>& u) {
        return four(colour_of_sun(air, [&](Wavelength w) { return u.at(w).value; }) / whole, 0.0);
    };
    const View view{.eye_up = {},
                    .towards_sun = {0.0f, 0.0f, 0.0f, static_cast<float>(sun.angular_radius)},
                    .shell = {static_cast<float>(air.atmosphere.bottom_radius.in(m)), static_cast<float>(air.atmosphere.top_altitude.in(m)),
                              0.0f, 0.0f},
                    .colour_of_sun = four(whole, 0.0),
                    .limb_darkening_1 = mean(sun.limb_darkening_1),
                    .limb_darkening_2 = mean(sun.limb_darkening_2),
                    .ground_albedo = mean(air.atmosphere.ground_albedo)};
    return AirPass(std::move(*made), std::move(method), view, air.atmosphere.bottom_radius.in(m));
}

AirPass::AirPass(gpu::Program program, std::unique_ptr<AirMethod> method, const View& view, double bottom_m)
    : program_(std::move(program)),
      method_(std::move(method)),
      view_(view),
      bottom_m_(bottom_m),
      view_block_(sizeof(View)),
      lit_({1, 1}, std::array{1.0f, 1.0f, 1.0f, 1.0f}) {}

void AirPass::prepare(const Camera& camera, Vec3 towards_sun, gpu::PassTimers& timers) {
    const double radius_m = glm::length(camera.eye);
    view_.eye_up = four(camera.eye / radius_m, radius_m - bottom_m_);
    view_.towards_sun = four(towards_sun, static_cast<double>(view_.towards_sun[3]));
    view_block_.write(std::as_bytes(std::span(&view_, 1)));
    view_block_.bind_uniform(view_binding);
    method_->prepare({radius_m - bottom_m_, glm::dot(camera.eye, towards_sun) / radius_m}, timers);
}

void AirPass::draw(const GeometryBuffer& surfaces, const gpu::Texture* shade) const {
    view_block_.bind_uniform(view_binding);
    unsigned binding = 0;
    for (const gpu::Texture* texture : {&surfaces.depth(), &surfaces.colour(), &surfaces.normal(), &surfaces.material()})
        texture->bind_sampler(binding++);
    (shade ? *shade : lit_).bind_sampler(7);
    program_.use();
    glDisable(GL_DEPTH_TEST);
    glBlendFunc(GL_ONE, GL_ONE);
    for (int picture = 0; picture < method_->pictures(); ++picture) {
        method_->bind(picture);
        triangle_.draw_triangles(3);
        glEnable(GL_BLEND);  // the next adds to it
    }
    glDisable(GL_BLEND);
}

}  // namespace airlight::render
