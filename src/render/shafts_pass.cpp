#include "render/shafts_pass.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "render/shaders.h"

namespace airlight::render {

namespace {

constexpr unsigned slices_binding = 5, rays_binding = 6, even_binding = 11, slopes_binding = 12, blocks_binding = 13, peaked_binding = 14,
                   spans_binding = 15;

// Directions of the picture and places on the way; multiples of the work group of shafts_table.comp.
constexpr gpu::TextureSize table_size{16, 60, 128};
// A work group of shafts_slices.comp takes a slice, each invocation a block of it.
constexpr int fewest_slices = 384, blocks_of_slice = 64, places_of_block = 12, blocks_of_span = 8;

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

Result<ShaftsPass> ShaftsPass::create(int width, int height, Shafts method, const Atmosphere* air, int pixels_of_ray) {
    const bool only_surfaces = !air || method == Shafts::none;
    Result<gpu::Program> made = program("fullscreen.vert", only_surfaces ? "shafts_none.frag" : "shafts_picture.frag");
    if (!made) return made.error();
    gpu::Texture shade({width, height}, {}, gpu::TextureFormat::rgba16f);
    Result<gpu::Framebuffer> target = gpu::Framebuffer::create({&shade});
    if (!target) return target.error();
    std::optional<Rays> rays;
    if (!only_surfaces) {
        Result<Rays> of_method = rays_of(width, height, method, *air, pixels_of_ray);
        if (!of_method) return of_method.error();
        rays.emplace(*std::move(of_method));
    }
    return ShaftsPass(*std::move(made), std::move(shade), *std::move(target), std::move(rays));
}

Result<ShaftsPass::Rays> ShaftsPass::rays_of(int width, int height, Shafts method, const Atmosphere& air, int pixels_of_ray) {
    Result<gpu::Program> made = program("fullscreen.vert", shader_of(method));
    if (!made) return made.error();
    const auto rays_along = [&](int pixels) { return (pixels + pixels_of_ray - 1) / pixels_of_ray; };
    gpu::Texture lit({rays_along(width), rays_along(height)}, {}, gpu::TextureFormat::rgba16f);
    Result<gpu::Framebuffer> target = gpu::Framebuffer::create({&lit});
    if (!target) return target.error();
    std::optional<Table> table;
    if (method != Shafts::brute) {
        Result<gpu::Program> light = compute_program("shafts_table.comp");
        if (!light) return light.error();
        table.emplace(Table{*std::move(light), gpu::Texture(table_size), gpu::Texture(table_size)});
    }
    std::optional<SlicesOfMaps> slices;
    if (method == Shafts::epipolar) {
        Result<gpu::Program> sliced = compute_program("shafts_slices.comp");
        if (!sliced) return sliced.error();
        // Slices about a light within the picture leave its edge five pixels apart; four times as many are no nearer to brute force.
        const int count = std::max(fewest_slices, 3 * (width + height) / 8);
        slices.emplace(SlicesOfMaps{count, *std::move(sliced),
                                    gpu::Texture({blocks_of_slice * places_of_block + 1, count}, {}, gpu::TextureFormat::r32f),
                                    gpu::Texture({blocks_of_slice, count}), gpu::Texture({blocks_of_slice / blocks_of_span, count}),
                                    gpu::Buffer(sizeof(SlicesBlock))});
    }
    const std::array<std::int32_t, 4> block = {pixels_of_ray, 0, 0, 0};
    return Rays{*std::move(made), std::move(lit),   *std::move(target), gpu::Buffer(std::as_bytes(std::span(block))),
                ShaftsAir(air),   std::move(table), std::move(slices)};
}

ShaftsPass::ShaftsPass(gpu::Program program, gpu::Texture shade, gpu::Framebuffer target, std::optional<Rays> rays)
    : program_(std::move(program)), shade_(std::move(shade)), target_(std::move(target)), rays_(std::move(rays)) {}

void ShaftsPass::draw_slices(const SlicesOfMaps& slices, const ShadowPass& shadows, const Camera& camera) {
    const Interval angles = angles_about_light(camera, shadows.axes());
    const double reach = shadows.cascades().empty() ? 1.0 : shadows.cascades().back().to_m;
    const SlicesBlock block{
        {static_cast<float>(angles.low), static_cast<float>((angles.high - angles.low) / slices.count), static_cast<float>(reach), 0.0f},
        {slices.count, blocks_of_slice * places_of_block, places_of_block, angles.high - angles.low >= 2.0 * pi ? 1 : 0}};
    slices.block.write(std::as_bytes(std::span(&block, 1)));
    slices.block.bind_uniform(slices_binding);
    slices.slopes.bind_image(0);
    slices.blocks.bind_image(1);
    slices.spans.bind_image(2);
    slices.program.dispatch(static_cast<unsigned>(slices.count));
    slices.slopes.bind_sampler(slopes_binding);
    slices.blocks.bind_sampler(blocks_binding);
    slices.spans.bind_sampler(spans_binding);
}

void ShaftsPass::draw_rays(const ShadowPass& shadows, const Camera& camera) const {
    rays_->air.bind();
    if (rays_->table) {
        const Table& table = *rays_->table;
        table.even.bind_image(0);
        table.peaked.bind_image(1);
        table.program.dispatch(table_size.width / 8, table_size.height / 6);
        table.even.bind_sampler(even_binding);
        table.peaked.bind_sampler(peaked_binding);
    }
    if (rays_->slices) draw_slices(*rays_->slices, shadows, camera);
    rays_->block.bind_uniform(rays_binding);
    rays_->target.bind();
    rays_->program.use();
    triangle_.draw_triangles(3);
    rays_->lit.bind_sampler(even_binding);
}

void ShaftsPass::draw(const GeometryBuffer& surfaces, const ShadowPass& shadows, const Camera& camera) const {
    shadows.bind();
    surfaces.depth().bind_sampler(0);
    glDisable(GL_DEPTH_TEST);
    if (rays_) draw_rays(shadows, camera);
    target_.bind();
    program_.use();
    triangle_.draw_triangles(3);
}

}  // namespace airlight::render
