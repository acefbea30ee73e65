#include "render/ground_pass.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "render/shaders.h"
#include "terrain/ground_cover.h"

namespace airlight::render {

namespace {

constexpr unsigned materials_binding = 1, eye_binding = 2, image_binding = 4;

// A unit of places in the noise (src/render/shaders/ground_detail.glsl); 2^32 of them are a period, 67 109 km.
constexpr double units_a_m = 64.0;
// The widest octave of the noise where there is no image whose pixels would be narrower: 16 km. The narrowest is a unit wide.
constexpr int widest_octave = 10;

// std140: `uniform Ground`.
struct Materials {
    std::array<std::array<float, 4>, ground_kinds> reflectance{};  // and contrast
    std::array<std::array<float, 4>, ground_kinds> tint{};         // and relief
    float sea = 0.0f;                                              // 1: what lies below 0 m is under water
    float image_pixel_m = 0.0f;                                    // from north to south; 0: there is no image
    float widest = 0.0f;                                           // octave
    float padding = 0.0f;
};
struct EyeBlock {
    std::array<std::uint32_t, 4> units{};
    std::array<float, 4> rest{};  // of a unit
};

// Octaves are four times as wide as the one before.
int octave_below(double wavelength_m) { return static_cast<int>(std::floor(0.5 * std::log2(wavelength_m * units_a_m))); }

std::array<float, 4> four(Vec3 v, double w) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), static_cast<float>(w)};
}

Materials materials_of(const HeightField& field, const SurfaceImage* image) {
    Materials block;
    for (std::size_t kind = 0; kind < block.reflectance.size(); ++kind) {
        const GroundMaterial& material = ground_materials()[kind];
        block.reflectance[kind] = four(material.reflectance, material.contrast);
        block.tint[kind] = four(material.tint, material.relief);
    }
    block.sea = field.sea ? 1.0f : 0.0f;
    const double pixel_m = image ? pi * field.radius_m / image->height : 0.0;
    block.image_pixel_m = static_cast<float>(pixel_m);
    block.widest = static_cast<float>(image ? std::min(widest_octave, octave_below(pixel_m)) : widest_octave);
    return block;
}

EyeBlock eye_block(Vec3 eye_m) {
    EyeBlock block;
    for (int axis = 0; axis < 3; ++axis) {
        const double units = eye_m[axis] * units_a_m, whole = std::floor(units);
        block.units[static_cast<std::size_t>(axis)] = static_cast<std::uint32_t>(static_cast<std::int64_t>(whole));
        block.rest[static_cast<std::size_t>(axis)] = static_cast<float>(units - whole);
    }
    return block;
}

}  // namespace

Result<GroundPass> GroundPass::create(const HeightField& field, const GroundColour& colour) {
    const SurfaceImage* image = colour.image.get();
    if (image) {
        GLint widest = 0;
        glGetIntegerv(GL_MAX_TEXTURE_SIZE, &widest);
        if (image->width > widest)
            return Error{"ground.surface",
                         fmt::format("the image is {} pixels wide, and this driver's textures at most {}.", image->width, widest),
                         "Make it smaller with gdal_translate -outsize."};
    }
    Result<gpu::Program> made = program("fullscreen.vert", "ground.frag");
    if (!made) return made.error();
    return GroundPass(field, image, std::move(*made));
}

GroundPass::GroundPass(const HeightField& field, const SurfaceImage* image, gpu::Program program)
    : program_(std::move(program)),
      materials_([&] {
          const Materials block = materials_of(field, image);
          return gpu::Buffer(std::as_bytes(std::span(&block, 1)));
      }()),
      eye_(sizeof(EyeBlock)),
      image_(image ? gpu::Texture::around_a_sphere({image->width, image->height}, image->levels) : gpu::Texture({1, 1})) {}

void GroundPass::draw(const GeometryBuffer& surfaces, const Camera& camera) const {
    const EyeBlock block = eye_block(camera.eye);
    eye_.write(std::as_bytes(std::span(&block, 1)));
    eye_.bind_uniform(eye_binding);
    materials_.bind_uniform(materials_binding);
    unsigned binding = 0;
    for (const gpu::Texture* texture : {&surfaces.depth(), &surfaces.colour(), &surfaces.normal(), &surfaces.material()})
        texture->bind_sampler(binding++);
    image_.bind_sampler(image_binding);
    program_.use();
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_LESS);  // where anything is nearer than the triangle, whose depth is that of nothing
    glTextureBarrier();    // each pixel reads what it then writes
    triangle_.draw_triangles(3);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_TRUE);
}

}  // namespace airlight::render
