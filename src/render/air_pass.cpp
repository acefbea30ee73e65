#include "render/air_pass.h"

#include <epoxy/gl.h>

#include <array>
#include <cassert>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "render/eclipse_table.h"
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
    const Sun& sun = air.atmosphere.sun;
    const Vec3 whole = colour_of_sun(air, [](Wavelength) { return 1.0; });
    const auto mean = [&](const SpectrumOf<Number>& u) {
        return four(colour_of_sun(air, [&](Wavelength w) { return u.at(w).value; }) / whole, 0.0);
    };
    const View view{.eye_up = {},
                    .towards_sun = {},
                    .shell = {static_cast<float>(air.atmosphere.bottom_radius.in(m)), static_cast<float>(air.atmosphere.top_altitude.in(m)),
                              0.0f, 0.0f},
                    .colour_of_sun = four(whole, 0.0),
                    .limb_darkening_1 = mean(sun.limb_darkening_1),
                    .limb_darkening_2 = mean(sun.limb_darkening_2),
                    .ground_albedo = mean(air.atmosphere.ground_albedo),
                    .moon = {},
                    .eclipse = {},
                    .night_scattered = {},
                    .night_illuminance = {}};
    AirPass pass(std::move(method), view, air.atmosphere);
    if (const Result<Done> made = pass.use_program(Part::surfaces, true); !made) return made.error();
    return pass;
}

AirPass::AirPass(std::unique_ptr<AirMethod> method, const View& view, Atmosphere atmosphere)
    : method_(std::move(method)),
      view_(view),
      atmosphere_(std::move(atmosphere)),
      view_block_(sizeof(View)),
      lit_({1, 1}, std::array{1.0f, 1.0f, 1.0f, 1.0f}),
      covered_sun_({1, 1}) {}

void AirPass::prepare(const Camera& camera, Vec3 towards_sun, gpu::PassTimers& timers, const std::optional<Eclipse>& eclipse,
                      bool night_sky) {
    const double radius_m = glm::length(camera.eye), altitude_m = radius_m - atmosphere_.bottom_radius.in(m);
    view_.eye_up = four(camera.eye / radius_m, altitude_m);
    view_.towards_sun = four(towards_sun, eclipse ? eclipse->sun_radius : atmosphere_.sun.angular_radius);
    view_.moon = eclipse ? four(eclipse->moon_m, eclipse->moon_radius_m) : Four{};
    view_.eclipse = {};
    if (eclipse) {
        const double reach_m = (atmosphere_.bottom_radius + atmosphere_.top_altitude).in(m);
        const EclipseTable table = eclipse_table(*eclipse, -camera.eye, reach_m);
        view_.eclipse = {static_cast<float>(1.0 / eclipse->sun_distance_m), table.first_ratio, table.last_ratio, 0.0f};
        covered_sun_ = gpu::Texture({EclipseTable::columns, EclipseTable::rows}, table.texels);
    }
    const NightLight night = night_sky ? night_light() : NightLight{};
    view_.night_scattered = four(night.scattered, 0.0);
    view_.night_illuminance = four(night.illuminance, 0.0);
    view_block_.write(std::as_bytes(std::span(&view_, 1)));
    view_block_.bind_uniform(view_binding);
    method_->prepare({altitude_m, glm::dot(camera.eye, towards_sun) / radius_m}, timers);
}

Result<Done> AirPass::use_program(Part part, bool water) {
    const bool surfaces = part == Part::surfaces, wet = surfaces && water, moon = view_.moon[3] > 0.0f;
    std::optional<gpu::Program>& of_part = programs_[surfaces][wet][moon];
    if (!of_part) {
        std::vector<std::string_view> lacks;
        if (!surfaces) lacks.push_back("AIR_WITHOUT_SURFACES");
        if (!wet) lacks.push_back("AIR_WITHOUT_WATER");
        if (!moon) lacks.push_back("AIR_WITHOUT_MOON");
        Result<gpu::Program> made = program("fullscreen.vert", method_->shader(), lacks);
        if (!made) return made.error();
        made->bind_block("AirlightBlock", airlight_block_binding);
        of_part.emplace(*std::move(made));
    }
    of_part->use();
    return Done{};
}

Result<Done> AirPass::draw(const GeometryBuffer& surfaces, const gpu::Texture* shade, const gpu::Texture* background, bool water) {
    glDisable(GL_BLEND);
    return draw_pictures(surfaces, shade, background, water);
}

Result<Done> AirPass::add(const GeometryBuffer& surfaces, Vec3 shares, bool water) {
    glBlendColor(static_cast<float>(shares.r), static_cast<float>(shares.g), static_cast<float>(shares.b), 0.0f);
    glBlendFunc(GL_CONSTANT_COLOR, GL_ONE);
    glEnable(GL_BLEND);
    return draw_pictures(surfaces, nullptr, nullptr, water);
}

Result<Done> AirPass::draw_pictures(const GeometryBuffer& surfaces, const gpu::Texture* shade, const gpu::Texture* background, bool water) {
    view_.shell[2] = background ? 1.0f : 0.0f;
    view_block_.write(std::as_bytes(std::span(&view_, 1)));
    view_block_.bind_uniform(view_binding);
    unsigned binding = 0;
    for (const gpu::Texture* texture : {&surfaces.depth(), &surfaces.colour(), &surfaces.normal(), &surfaces.material()})
        texture->bind_sampler(binding++);
    (background ? *background : lit_).bind_sampler(4);
    covered_sun_.bind_sampler(5);
    (shade ? *shade : lit_).bind_sampler(7);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    for (int picture = 0; picture < method_->pictures(); ++picture) {
        method_->bind(picture);
        for (const Part part : {Part::surfaces, Part::rest}) {
            if (const Result<Done> used = use_program(part, water); !used) return used.error();
            glDepthFunc(part == Part::surfaces ? GL_LESS : GL_EQUAL);  // of the triangle's depth, 0: of nothing
            triangle_.draw_triangles(3);
        }
        if (!glIsEnabled(GL_BLEND)) {  // the next adds to it
            glBlendFunc(GL_ONE, GL_ONE);
            glEnable(GL_BLEND);
        }
    }
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    return Done{};
}

}  // namespace airlight::render
