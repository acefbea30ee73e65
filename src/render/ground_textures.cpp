#include "render/ground_textures.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <array>

#include "terrain/ground_cover.h"

namespace airlight::render {

namespace {

constexpr unsigned block_binding = 2, image_binding = 0;

// std140: `uniform Ground`.
struct Block {
    std::array<std::array<float, 4>, ground_kinds> reflectance{};
    float sea = 0.0f;            // 1: what lies below 0 m is under water
    float image_pixel_m = 0.0f;  // from north to south; 0: there is no image
    float padding[2]{};
};

Block block_of(const HeightField& field, const SurfaceImage* image) {
    Block block;
    for (std::size_t kind = 0; kind < block.reflectance.size(); ++kind)
        for (int c = 0; c < 3; ++c)
            block.reflectance[kind][static_cast<std::size_t>(c)] = static_cast<float>(ground_materials()[kind].reflectance[c]);
    block.sea = field.sea ? 1.0f : 0.0f;
    if (image) block.image_pixel_m = static_cast<float>(pi * field.radius_m / image->height);
    return block;
}

}  // namespace

Result<GroundTextures> GroundTextures::create(const HeightField& field, const GroundColour& colour) {
    const SurfaceImage* image = colour.image.get();
    if (image) {
        GLint widest = 0;
        glGetIntegerv(GL_MAX_TEXTURE_SIZE, &widest);
        if (image->width > widest)
            return Error{"ground.surface",
                         fmt::format("the image is {} pixels wide, and this driver's textures at most {}.", image->width, widest),
                         "Make it smaller with gdal_translate -outsize."};
    }
    return GroundTextures(field, image);
}

GroundTextures::GroundTextures(const HeightField& field, const SurfaceImage* image)
    : block_([&] {
          const Block block = block_of(field, image);
          return gpu::Buffer(std::as_bytes(std::span(&block, 1)));
      }()),
      image_(image ? gpu::Texture::around_a_sphere({image->width, image->height}, image->levels) : gpu::Texture({1, 1})) {}

void GroundTextures::bind() const {
    block_.bind_uniform(block_binding);
    image_.bind_sampler(image_binding);
}

}  // namespace airlight::render
