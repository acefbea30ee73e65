// The sky in water, by the pass of air through the same camera: against Fresnel's equations on the CPU, from the ground to space.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "render/air_airlight.h"
#include "render/air_exact.h"
#include "render/camera_block.h"
#include "tools/air_case.h"
#include "tools/full_screen.h"
#include "tools/gpu_case.h"

using namespace airlight;
using namespace airlight::test;

namespace {

// The ground sphere as a mirror of water, or as black land.
class Sea {
public:
    explicit Sea(double bottom_m) : bottom_m_(bottom_m) {}

    // What the water adds to each pixel's light: red, green, blue, and 0 where there is none.
    std::vector<double> mirrored(render::AirPass& air, const Camera& camera, Vec3 towards_sun, double roughness) const {
        gpu::PassTimers timers;
        air.prepare(camera, towards_sun, timers);
        const std::vector<float> with = draw(air, camera, roughness, 1.0f), without = draw(air, camera, roughness, 0.0f);
        std::vector<double> difference;
        for (std::size_t i = 0; i < with.size(); ++i) difference.push_back(static_cast<double>(with[i]) - static_cast<double>(without[i]));
        return difference;
    }

private:
    std::vector<float> draw(render::AirPass& air, const Camera& camera, double roughness, float water) const {
        const std::array<float, 4> block = {static_cast<float>(bottom_m_), static_cast<float>(roughness), water, 0.0f};
        const gpu::Buffer uniform(std::as_bytes(std::span(block)));
        uniform.bind_uniform(3);
        camera_block_.bind(camera);
        surfaces_->begin();
        program_.draw();
        render::GeometryBuffer::end();
        target_->bind();
        REQUIRE(air.draw(*surfaces_));
        std::vector<float> pixels(4 * width * height);
        radiance_.read(pixels);
        return pixels;
    }

    double bottom_m_;
    Result<render::GeometryBuffer> surfaces_ = render::GeometryBuffer::create(width, height);
    gpu::Texture radiance_{{width, height}};
    Result<gpu::Framebuffer> target_ = gpu::Framebuffer::create({&radiance_}, &surfaces_->depth());
    render::CameraBlock camera_block_;
    FullScreen program_{"sea", R"(#version 450 core
#include "camera.glsl"
#include "geometry_buffer.glsl"
layout(std140, binding = 3) uniform SeaBlock { vec4 sea; };  // radius, roughness, water
layout(location = 0) in vec2 place;
void main() {
    dvec3 way = normalize(dvec3(view_ray(place)));
    double along = -dot(camera_eye_m.xyz, way), inside = along * along - dot(camera_eye_m.xyz, camera_eye_m.xyz) + double(sea.x) * double(sea.x);
    if (along <= 0.0 || inside <= 0.0) discard;
    dvec3 position = way * (along - sqrt(inside));
    gl_FragDepth = camera_lens.z / dot(vec3(position), camera_forward.xyz);
    write_surface(vec3(0.0), normalize(vec3(camera_eye_m.xyz + position)), sea.y, sea.z);
}
)"};
};

// The light of the sky by still water of a refractive index of 1.33, by Fresnel's equations, towards the eye; none where there is no water, or the
// sun's glint.
std::vector<double> mirrored_by_cpu(const Truth& model, const Camera& camera, Vec3 way, Vec3 sun) {
    const double along = -glm::dot(camera.eye, way), beside = glm::length(camera.eye + along * way), bottom = model.bottom_m();
    if (along <= 0.0 || beside >= bottom) return {};
    const double distance = along - std::sqrt((bottom - beside) * (bottom + beside));
    const Vec3 from_centre = camera.eye + distance * way, up = glm::normalize(from_centre);
    const double c = -glm::dot(way, up);
    const Vec3 mirrored = way + 2.0 * c * up;
    if (angle_between(mirrored, sun) < 15.0 * deg) return {};
    const double index = 1.33, inner = std::sqrt(1.0 - (1.0 - c * c) / (index * index));
    const double across = (c - index * inner) / (c + index * inner), parallel = (index * c - inner) / (index * c + inner);
    const double reflected = 0.5 * (across * across + parallel * parallel);
    const AerialPerspective air = *model.sky->aerial_perspective(view_of(camera.eye, bottom, way, sun), distance * m);
    View from_water = view_of(up * bottom, bottom, mirrored, sun);
    from_water.altitude = 0.0 * m;
    std::vector<double> light = model.sky->radiance(from_water)->radiance_W_m2_sr_nm;
    for (std::size_t w = 0; w < light.size(); ++w) light[w] *= reflected * air.transmittance[w];
    return light;
}

double mean_mirror_error(const std::vector<double>& seen, const Truth& model, const Camera& camera, Vec3 sun) {
    return mean_error(seen, camera, [&](Vec3 way) { return mirrored_by_cpu(model, camera, way, sun); });
}

}  // namespace

// Waves of a roughness of 0.02 are as good as still. The sun stands behind the eye.
TEST_CASE("water mirrors the sky over it: the exact pass as the CPU marches it, and in real time within 15 %") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const Truth model;
    render::AirPass fast = model.pass(must(render::airlight_air(model.baked, colours))),
                    exact = model.pass(render::exact_air(model.baked, colours));
    const Sea sea(model.bottom_m());
    fmt::print("  mean error, %         {:>8} {:>10}\n", "exact", "real time");
    for (const auto& [altitude_m, pitch_deg] :
         {std::pair{2.0, -40.0}, {50.0, -33.0}, {3e3, -35.0}, {1e4, -60.0}, {4e5, -60.0}, {2e7, -89.0}})
        for (const double sun_deg : {20.0, 60.0, 80.0, 88.0}) {
            Camera camera = camera_above(model, altitude_m, pitch_deg);
            if (altitude_m > 1e6) camera.vertical_field_of_view = 20.0 * deg;
            const Vec3 sun = sun_at(model, sun_deg);
            const double by_exact = mean_mirror_error(sea.mirrored(exact, camera, sun, 0.02), model, camera, sun),
                         by_fast = mean_mirror_error(sea.mirrored(fast, camera, sun, 0.02), model, camera, sun);
            fmt::print("  {:>8.0f} m, sun {:>2.0f} {:>11.2f} {:>10.2f}\n", altitude_m, sun_deg, 100.0 * by_exact, 100.0 * by_fast);
            CHECK(by_exact <= 0.03);
            CHECK(by_fast <= 0.15);
        }
}
