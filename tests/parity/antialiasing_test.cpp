// Samples of pixels through the GPU: a frame that is shifted is the frame, shifted; the mean of samples has smooth edges, and only there.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "render/frame.h"
#include "terrain/procedural_relief.h"
#include "tools/gpu_case.h"

using namespace airlight;
using namespace airlight::test;

namespace {

constexpr int width = 96, height = 54;

// A planet that is lit from the side, whole in the picture.
struct Planet {
    HeightField field = procedural_height({});
    Camera camera = looking(field.radius_m);
    render::Lights lights{glm::normalize(camera.right - 0.5 * camera.forward), Vec3(3.0), Vec3(0.5)};

    static Camera looking(double radius_m) {
        Camera camera =
            look(Viewpoint{.latitude = 0.6, .longitude = 0.5, .altitude_m = 2e7, .heading = 1.0, .pitch = -90.0 * deg}, radius_m);
        camera.width = width, camera.height = height, camera.vertical_field_of_view = 40.0 * deg;
        return camera;
    }
};

// Red, green and blue of each pixel, and 1 in alpha where there is ground; the lowest row first.
std::vector<float> texels(render::Frame& frame, const Camera& camera, const render::Lights& lights) {
    REQUIRE(frame.render(camera, lights));
    std::vector<float> read(4 * width * height);
    frame.radiance().read(read);
    return read;
}

std::size_t at(int column, int row) { return static_cast<std::size_t>(4 * (row * width + column)); }

}  // namespace

TEST_CASE("a frame that is shifted by a pixel is the frame, shifted by a pixel") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const Planet planet;
    Result<render::Frame> frame = render::Frame::create(gpu_case.context(), planet.field, {}, planet.camera, {});
    REQUIRE(frame);
    const std::vector<float> still = texels(*frame, planet.camera, planet.lights);
    Camera shifted = planet.camera;
    shifted.shift_x = 1.0, shifted.shift_y = -2.0;
    const std::vector<float> moved = texels(*frame, shifted, planet.lights);
    int beside = 0, ground = 0;
    for (int row = 2; row < height; ++row)
        for (int column = 0; column + 1 < width; ++column) {
            const float* here = &moved[at(column, row)];
            const float* there = &still[at(column + 1, row - 2)];
            ground += there[3] > 0.0f;
            for (int c = 0; c < 4; ++c)
                if (std::abs(here[c] - there[c]) > 0.05f * there[c] + 1e-3f) {  // two levels of a dark reflectance
                    ++beside;
                    break;
                }
        }
    CHECK(ground > 500);
    CHECK(beside <= 3);  // an edge through the middle of a pixel may fall on either side
}

TEST_CASE("the mean of a pixel's samples is between ground and space at the planet's limb, and nowhere else") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const Planet planet;
    Result<render::Frame> frame = render::Frame::create(gpu_case.context(), planet.field, {}, planet.camera, {});
    REQUIRE(frame);
    constexpr int samples = 16;
    std::vector<float> mean(4 * width * height);
    for (int n = 0; n < samples; ++n) {
        const std::vector<float> sample = texels(*frame, sampled(planet.camera, n, samples), planet.lights);
        for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += sample[i] / samples;
    }
    const std::vector<float> one = texels(*frame, sampled(planet.camera, 0, 1), planet.lights);
    CHECK(one == texels(*frame, planet.camera, planet.lights));
    int edges = 0, between = 0;
    for (int row = 1; row + 1 < height; ++row)
        for (int column = 1; column + 1 < width; ++column) {
            const float covered = one[at(column, row) + 3], share = mean[at(column, row) + 3];
            CHECK((covered == 0.0f || covered == 1.0f));
            float least = 1.0f, most = 0.0f;
            for (const auto& [x, y] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {1, 1}, {-1, 1}, {1, -1}}) {
                least = std::min(least, one[at(column + x, row + y) + 3]);
                most = std::max(most, one[at(column + x, row + y) + 3]);
            }
            const bool edge = least != most;
            edges += edge, between += share > 0.01f && share < 0.99f;
            if (!edge) CHECK(share == doctest::Approx(covered));
        }
    // A circle of radius r crosses 8 r pixels; where it cuts off less than a sample it may leave none.
    const double radius =
        0.5 * height / half_size(planet.camera).height * std::tan(std::asin(planet.field.radius_m / (planet.field.radius_m + 2e7)));
    CHECK(between > 0.7 * 8.0 * radius);
    CHECK(between <= 8.0 * radius);
    CHECK(edges > between);
}
