#include "render/shafts_pass.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "render/shaders.h"

namespace airlight::render {

namespace {

constexpr unsigned slices_binding = 5, even_binding = 11, slopes_binding = 12, blocks_binding = 13, peaked_binding = 14, spans_binding = 15;

// Directions of the picture and places on the way; multiples of the work group of shafts_table.comp.
constexpr gpu::TextureSize table_size{16, 36, 128};
// A work group of shafts_slices.comp takes a slice, each invocation a block of it.
constexpr int slice_count = 1024, blocks_of_slice = 64, places_of_block = 16, blocks_of_span = 8;

// std140: `uniform Slices`.
struct SlicesBlock {
    std::array<float, 4> angles;
    std::array<std::int32_t, 4> counts;
};

std::string shader_of(Shafts method) {
    switch (method) {
        case Shafts::epipolar:
            return "shafts_epipolar.frag";
        case Shafts::marched:
            return "shafts_marched.frag";
        case Shafts::planes:
            return "shafts_planes.frag";
        case Shafts::volumes:
            return "shafts_volumes.frag";
        case Shafts::brute:
            return "shafts_brute.frag";
        case Shafts::none:
            break;
    }
    return "shafts_none.frag";
}

// The angles about the light between which a camera looks: all of them, if it looks towards the light or away from it.
Interval angles_about_light(const Camera& camera, const LightAxes& axes) {
    constexpr int steps = 64;
    double turned = 0.0, last = 0.0;
    Interval range;
    for (int i = 0; i <= 4 * steps; ++i) {
        // Along the picture's edge.
        const double along = 2.0 * (i % steps) / steps - 1.0;
        const std::array<std::pair<double, double>, 4> edge = {{{along, -1.0}, {1.0, along}, {-along, 1.0}, {-1.0, -along}}};
        const auto [x, y] = edge[static_cast<std::size_t>(i / steps % 4)];
        const Vec3 d = direction_at(camera, x, y);
        const double angle = std::atan2(glm::dot(d, axes.up), glm::dot(d, axes.right));
        turned = i == 0 ? angle : turned + std::remainder(angle - last, 2.0 * pi);
        if (i == 0) range = {angle, angle};
        range = {std::min(range.low, turned), std::max(range.high, turned)};
        last = angle;
    }
    return range.high - range.low >= 2.0 * pi ? Interval{-pi, pi} : range;
}

}  // namespace

Result<ShaftsPass> ShaftsPass::create(int width, int height, Shafts method, const Atmosphere* air) {
    if (!air) method = Shafts::none;
    Result<gpu::Program> made = program("fullscreen.vert", shader_of(method));
    if (!made) return made.error();
    gpu::Texture shade({width, height}, {}, gpu::TextureFormat::rgba16f);
    Result<gpu::Framebuffer> target = gpu::Framebuffer::create({&shade});
    if (!target) return target.error();
    std::optional<ShaftsAir> optics;
    if (method != Shafts::none) optics.emplace(*air);
    std::optional<Table> table;
    if (method != Shafts::none && method != Shafts::brute) {
        Result<gpu::Program> light = compute_program("shafts_table.comp");
        if (!light) return light.error();
        table.emplace(Table{std::move(*light), gpu::Texture(table_size), gpu::Texture(table_size)});
    }
    std::optional<SlicesOfMaps> slices;
    if (method == Shafts::epipolar) {
        Result<gpu::Program> sliced = compute_program("shafts_slices.comp");
        if (!sliced) return sliced.error();
        slices.emplace(SlicesOfMaps{std::move(*sliced),
                                    gpu::Texture({blocks_of_slice * places_of_block, slice_count}, {}, gpu::TextureFormat::r32f),
                                    gpu::Texture({blocks_of_slice, slice_count}),
                                    gpu::Texture({blocks_of_slice / blocks_of_span, slice_count}), gpu::Buffer(sizeof(SlicesBlock))});
    }
    return ShaftsPass(std::move(*made), std::move(shade), std::move(*target), std::move(optics), std::move(table), std::move(slices));
}

ShaftsPass::ShaftsPass(gpu::Program program, gpu::Texture shade, gpu::Framebuffer target, std::optional<ShaftsAir> air,
                       std::optional<Table> table, std::optional<SlicesOfMaps> slices)
    : program_(std::move(program)),
      shade_(std::move(shade)),
      target_(std::move(target)),
      air_(std::move(air)),
      table_(std::move(table)),
      slices_(std::move(slices)) {}

void ShaftsPass::draw_slices(const ShadowPass& shadows, const Camera& camera) const {
    const Interval angles = angles_about_light(camera, shadows.axes());
    const double reach = shadows.cascades().empty() ? 1.0 : shadows.cascades().back().to_m;
    const SlicesBlock block{
        {static_cast<float>(angles.low), static_cast<float>((angles.high - angles.low) / slice_count), static_cast<float>(reach), 0.0f},
        {slice_count, blocks_of_slice * places_of_block, places_of_block, angles.high - angles.low >= 2.0 * pi ? 1 : 0}};
    slices_->block.write(std::as_bytes(std::span(&block, 1)));
    slices_->block.bind_uniform(slices_binding);
    slices_->slopes.bind_image(0);
    slices_->blocks.bind_image(1);
    slices_->spans.bind_image(2);
    slices_->program.dispatch(slice_count);
    slices_->slopes.bind_sampler(slopes_binding);
    slices_->blocks.bind_sampler(blocks_binding);
    slices_->spans.bind_sampler(spans_binding);
}

void ShaftsPass::draw(const GeometryBuffer& surfaces, const ShadowPass& shadows, const Camera& camera) const {
    shadows.bind();
    if (air_) air_->bind();
    if (table_) {
        table_->even.bind_image(0);
        table_->peaked.bind_image(1);
        table_->program.dispatch(table_size.width / 8, table_size.height / 6);
        table_->even.bind_sampler(even_binding);
        table_->peaked.bind_sampler(peaked_binding);
    }
    if (slices_) draw_slices(shadows, camera);
    surfaces.depth().bind_sampler(0);
    target_.bind();
    program_.use();
    glDisable(GL_DEPTH_TEST);
    triangle_.draw_triangles(3);
}

}  // namespace airlight::render
