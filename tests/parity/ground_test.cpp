// What the ground and the sea look like in the geometry buffer, pixel by pixel.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "render/camera_block.h"
#include "render/geometry_buffer.h"
#include "render/ground_pass.h"
#include "render/light_pass.h"
#include "render/terrain_pass.h"
#include "terrain/ground_cover.h"
#include "terrain/octahedral.h"
#include "tools/gpu_case.h"
#include "tools/must.h"

using namespace airlight;
using namespace airlight::test;

namespace {

constexpr int width = 160, height = 90;
constexpr double radius_m = 6'371'000.0;

// A planet that is nowhere higher or lower.
HeightField even_height(double height_m, bool sea) {
    return {.radius_m = radius_m,
            .sample =
                [height_m](Vec3, double) {
                    return HeightSample{height_m, Vec3(0.0), Vec3(0.0), Vec3(0.0)};
                },
            .range =
                [height_m](const Cap&) {
                    return Interval{height_m, height_m};
                },
            .detail = [](double) { return 0.0; },
            .whole = {height_m, height_m},
            .sea = sea};
}

double linear(double level) { return level <= 0.04045 ? level / 12.92 : std::pow((level + 0.055) / 1.055, 2.4); }

// Of each pixel; the first row is the lowest.
struct Looks {
    std::vector<Vec3> reflectance, normal;
    std::vector<bool> there;
    std::vector<double> light;  // green
};

class Ground {
public:
    Ground(const HeightField& field, const GroundColour& colour = {})
        : target_(must(gpu::Framebuffer::create({&light_texture_}))),
          light_(must(render::LightPass::create())),
          surfaces_(must(render::GeometryBuffer::create(width, height))),
          terrain_(must(render::TerrainPass::create(field, {.pixels_per_radian = height}))),
          looks_(must(render::GroundPass::create(field, colour))) {}

    Looks draw(Camera camera, const render::Lights& lights = {}) {
        camera.width = width, camera.height = height;
        camera_.bind(camera);
        surfaces_.begin();
        terrain_.draw(camera);
        looks_.draw(surfaces_, camera);
        render::GeometryBuffer::end();
        target_.bind();
        light_.draw(surfaces_, lights);
        std::vector<float> colour(4 * width * height), light(4 * width * height);
        light_texture_.read(light);
        surfaces_.colour().read(colour);
        std::vector<float> normal(2 * width * height);
        surfaces_.normal().read(normal);
        Looks looks;
        for (std::size_t i = 0; i < colour.size(); i += 4) {
            looks.reflectance.emplace_back(linear(static_cast<double>(colour[i])), linear(static_cast<double>(colour[i + 1])),
                                           linear(static_cast<double>(colour[i + 2])));
            looks.there.push_back(colour[i + 3] > 0.0f);
            looks.light.push_back(static_cast<double>(light[i + 1]));
            const auto level = [&](std::size_t n) { return static_cast<std::uint32_t>(std::lround(normal[i / 2 + n] * 65535.0f)); };
            looks.normal.push_back(from_octahedral(level(0) | level(1) << 16));
        }
        return looks;
    }

private:
    gpu::Texture light_texture_{{width, height}};
    gpu::Framebuffer target_;
    render::LightPass light_;
    render::GeometryBuffer surfaces_;
    render::TerrainPass terrain_;
    render::GroundPass looks_;
    render::CameraBlock camera_;
};

// Straight down, north at the top.
Camera above(double latitude_deg, double longitude_deg, double altitude_m) {
    return look(Viewpoint{.latitude = latitude_deg * deg, .longitude = longitude_deg * deg, .altitude_m = altitude_m, .pitch = -90.0 * deg},
                radius_m);
}

// The direction from the planet's centre in which a pixel sees the ground, or none.
std::optional<Vec3> seen_at(const Camera& camera, int column, int row) {
    const Vec3 way = glm::normalize(direction_at(camera, (column + 0.5) / width * 2.0 - 1.0, (row + 0.5) / height * 2.0 - 1.0));
    const double along = -glm::dot(camera.eye, way), beside = glm::length(camera.eye + along * way);
    if (along < 0.0 || beside > 0.9 * radius_m) return {};
    return glm::normalize(camera.eye + way * (along - std::sqrt(radius_m * radius_m - beside * beside)));
}

// An image of noise that is smooth enough for linear light between its pixels to be close to that between its levels.
std::shared_ptr<const SurfaceImage> noisy_image(int rows) {
    SurfaceImage image{2 * rows, rows, {}};
    std::mt19937 random(7);
    for (int i = 0; i < image.width * image.height; ++i) {
        for (int c = 0; c < 3; ++c) image.levels.push_back(static_cast<std::uint8_t>(random() % 256));
        image.levels.push_back(255);
    }
    return std::make_shared<const SurfaceImage>(std::move(image));
}

// Linear light between the centres of an image's pixels.
Vec3 reflectance(const SurfaceImage& image, Vec3 d) {
    const double x = (std::atan2(d.y, d.x) / (2.0 * pi) + 0.5) * image.width - 0.5;
    const double y = (0.5 - std::atan2(d.z, std::hypot(d.x, d.y)) / pi) * image.height - 0.5;
    Vec3 sum(0.0);
    for (const int j : {0, 1})
        for (const int i : {0, 1}) {
            const double u = x - std::floor(x), v = y - std::floor(y), share = (i ? u : 1.0 - u) * (j ? v : 1.0 - v);
            const int column = (static_cast<int>(std::floor(x)) + i + image.width) % image.width,
                      row = std::clamp(static_cast<int>(std::floor(y)) + j, 0, image.height - 1);
            for (int c = 0; c < 3; ++c)
                sum[c] += share * linear(image.levels[static_cast<std::size_t>(4 * (row * image.width + column) + c)] / 255.0);
        }
    return sum;
}

struct Spread {
    Vec3 mean{0.0};
    double of_green = 0.0;  // the root of its mean square, over the mean
};

Spread spread_of(const std::vector<Vec3>& all) {
    Spread spread;
    for (const Vec3& one : all) spread.mean += one / static_cast<double>(all.size());
    for (const Vec3& one : all) spread.of_green += std::pow(one.y / spread.mean.y - 1.0, 2) / static_cast<double>(all.size());
    spread.of_green = std::sqrt(spread.of_green);
    return spread;
}

}  // namespace

// Levels of 8 bits are half a level apart from linear light: 0.5 / 255 of sRGB's curve, whose slope is at most 2.3. Coordinates in float and
// filters in 8 bits of a fraction leave as much again.
TEST_CASE("an image colours each pixel linearly between its own, over poles and round the date line") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const auto image = noisy_image(32);
    Ground ground(even_height(0.0, false), {image});
    for (const auto& [latitude, longitude] : {std::pair{0.0, 0.0}, {10.0, 179.0}, {89.0, 30.0}, {-89.0, 0.0}})
        for (const double altitude_m : {3e6, 8e6}) {  // farther than the ground varies by itself
            const Camera camera = above(latitude, longitude, altitude_m);
            const Looks looks = ground.draw(camera);
            double largest = 0.0;
            int seen = 0;
            for (int row = 0; row < height; ++row)
                for (int column = 0; column < width; ++column) {
                    const auto pixel = static_cast<std::size_t>(row * width + column);
                    Camera sized = camera;
                    sized.width = width, sized.height = height;
                    const std::optional<Vec3> direction = seen_at(sized, column, row);
                    if (!direction || !looks.there[pixel]) continue;
                    ++seen;
                    const Vec3 difference = glm::abs(looks.reflectance[pixel] - reflectance(*image, *direction));
                    largest = std::max({largest, difference.x, difference.y, difference.z});
                }
            fmt::print("  {:>5.0f} deg north, {:>4.0f} deg east, {:.0f} km: largest difference {:.4f}\n", latitude, longitude,
                       altitude_m / 1e3, largest);
            CHECK(seen > width * height / 8);
            CHECK(largest < 0.012);
        }
}

// From 100 radii away a pixel holds thousands of the image's.
TEST_CASE("an image seen from afar is grey where its pixels are black and white") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    SurfaceImage image{1024, 512, {}};
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < 4; ++c) image.levels.push_back((x + y) % 2 || c == 3 ? 255 : 0);
    Ground ground(even_height(0.0, false), {std::make_shared<const SurfaceImage>(image)});
    Camera camera = above(0.0, 0.0, 3e7);
    camera.width = width, camera.height = height;
    const Looks looks = ground.draw(camera);
    double largest = 0.0;
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const auto pixel = static_cast<std::size_t>(row * width + column);
            if (seen_at(camera, column, row)) largest = std::max(largest, std::abs(looks.reflectance[pixel].y - 0.5));
        }
    CHECK(largest < 0.01);
}

TEST_CASE("water stands where the ground is below 0 m, if the planet has a sea") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const auto is = [](double height_m, bool sea, int kind) {
        const Vec3 seen = spread_of(Ground(even_height(height_m, sea)).draw(above(0.0, 0.0, 1e3)).reflectance).mean;
        return glm::length(seen - ground_materials()[static_cast<std::size_t>(kind)].reflectance) < 0.01;
    };
    CHECK(is(-20.0, true, 5));
    CHECK(is(-20.0, false, 2));
    CHECK(is(1.0, true, 2));
}

namespace {

// A slope on which rock and what else is there share the ground, at a height and a latitude where snow and steppe do as well.
constexpr double mixed_height_m = 1700.0, mixed_latitude_deg = 60.0;
HeightField rocky_ground(double height_m) {
    HeightField field = even_height(height_m, true);
    field.sample = [height_m](Vec3 d, double) {
        const Vec3 along = glm::normalize(glm::cross(Vec3(0, 0, 1), d));
        return HeightSample{height_m, Vec3(0.0), Vec3(0.0), 0.38 * along};
    };
    return field;
}
GroundCover rocky_cover(double latitude, double height_m) {
    const Vec3 d(std::cos(latitude), 0.0, std::sin(latitude));
    return ground_cover(d, height_m, glm::normalize(d - 0.38 * Vec3(0, 1, 0)));
}

Vec3 mean_reflectance(const GroundCover& cover) {
    Vec3 sum = ground_materials()[0].reflectance;
    sum = glm::mix(sum, ground_materials()[1].reflectance, cover.steppe);
    sum = glm::mix(sum, ground_materials()[3].reflectance, cover.rock);
    return glm::mix(sum, ground_materials()[4].reflectance, cover.snow);
}

}  // namespace

TEST_CASE("the ground varies near and far, and in the mean it reflects what covers it, from afar it does not vary") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const GroundCover cover = rocky_cover(mixed_latitude_deg * deg, mixed_height_m);
    for (const double share : {cover.steppe, cover.rock, cover.snow}) CHECK(std::abs(share - 0.5) < 0.49);
    const Vec3 expected = mean_reflectance(cover);
    Ground ground(rocky_ground(mixed_height_m));
    for (const double above_m : {3.0, 30.0, 1e3, 3e4}) {
        std::vector<Vec3> all;
        for (int place = 0; place < 24; ++place) {
            const Looks looks = ground.draw(above(mixed_latitude_deg, 15.0 * place, mixed_height_m + above_m));
            all.insert(all.end(), looks.reflectance.begin(), looks.reflectance.end());
        }
        const Spread spread = spread_of(all);
        const Vec3 off = glm::abs(spread.mean / expected - 1.0);
        fmt::print("  {:>6.0f} m above: off by {:.2f} %, {:.2f} %, {:.2f} %; spread {:.2f}\n", above_m, 100.0 * off.x, 100.0 * off.y,
                   100.0 * off.z, spread.of_green);
        CHECK(std::max({off.x, off.y, off.z}) < 0.01);
        CHECK(spread.of_green > 0.2);
    }
    // Near the equator rock and grass share the ground, at any latitude alike.
    Camera far = above(0.0, 0.0, 4e7);
    far.vertical_field_of_view = 3.4 * deg;
    const Vec3 even = mean_reflectance(rocky_cover(0.0, 100.0));
    double largest = 0.0;
    for (const Vec3& seen : Ground(rocky_ground(100.0)).draw(far).reflectance) largest = std::max(largest, std::abs(seen.y / even.y - 1.0));
    CHECK(largest < 0.02);  // a level of 8 bits
}

// A wave of the least width that a pixel takes part of, w pixels of sqrt(3) at the slant, moves by a quarter of a pixel: by pi / (2 w) of
// its height. Texels that alias would be new ones each time, and differ by more than the spread itself.
TEST_CASE("a quarter of a pixel changes little of a picture of the ground, looked at straight or at a low angle") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    Ground ground(rocky_ground(mixed_height_m));
    for (const double above_m : {2.0, 100.0, 1e4})
        for (const double pitch_deg : {-90.0, -30.0, -10.0}) {
            Viewpoint view{
                .latitude = mixed_latitude_deg * deg, .altitude_m = mixed_height_m + above_m, .heading = 0.3, .pitch = pitch_deg * deg};
            Camera camera = look(view, radius_m), moved = camera;
            camera.vertical_field_of_view = moved.vertical_field_of_view = 25.0 * deg;
            const double quarter = 0.25 * 25.0 * deg / height;
            moved.forward = glm::normalize(camera.forward + quarter * camera.up);
            moved.up = glm::normalize(camera.up - quarter * camera.forward);
            const Looks first = ground.draw(camera), second = ground.draw(moved);
            double change = 0.0;
            for (std::size_t i = 0; i < first.reflectance.size(); ++i)
                change += std::abs(first.reflectance[i].y - second.reflectance[i].y) / static_cast<double>(first.reflectance.size());
            const Spread spread = spread_of(first.reflectance);
            const double share = change / spread.mean.y / spread.of_green;
            fmt::print("  {:>6.0f} m above, pitch {:.0f}: changes by {:.3f} of the spread of {:.2f}\n", above_m, pitch_deg, share,
                       spread.of_green);
            CHECK(share < 0.3);
        }
}

// Rocks slope by 0.25, grass by 0.16, along any line: half of each here. Their mean square is that of the slopes' along two lines.
TEST_CASE("the ground is rough near and far, but level in the mean and from afar, no edge of the cube shows in colours or normals") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    Ground ground(rocky_ground(100.0));
    for (const double above_m : {3.0, 1e3}) {
        Vec3 mean(0.0);
        double square = 0.0;
        int count = 0;
        // Of the middle of the picture, below which the ground is level to 10^-4; the meridian is an edge between two faces.
        std::vector<double> step(width - 1, 0.0), colour_step(width - 1, 0.0);
        for (int place = 0; place < 12; ++place) {
            const Camera camera = above(5.0 + place, 45.0, 100.0 + above_m);
            const Looks looks = ground.draw(camera);
            const Vec3 up = glm::normalize(camera.eye);
            for (std::size_t row = 0; row < height; ++row)
                for (std::size_t column = 0; column + 1 < width; ++column) {
                    const std::size_t i = row * width + column;
                    const Vec3 slope = looks.normal[i] / glm::dot(looks.normal[i], up) - up;
                    mean += slope;
                    square += glm::dot(slope, slope);
                    ++count;
                    step[column] += glm::length(looks.normal[i + 1] - looks.normal[i]);
                    colour_step[column] += glm::length(looks.reflectance[i + 1] - looks.reflectance[i]);
                }
        }
        fmt::print("  {:>6.0f} m above: slopes of {:.3f}, {:.4f} in the mean\n", above_m, std::sqrt(0.5 * square / count),
                   glm::length(mean) / count);
        CHECK(glm::length(mean) / count < 0.01);
        CHECK(std::sqrt(0.5 * square / count) > 0.1);
        CHECK(std::sqrt(0.5 * square / count) < 0.3);
        for (const std::vector<double>& steps : {step, colour_step}) {
            double usual = 0.0;
            for (const double one : steps) usual += one / static_cast<double>(steps.size());
            CHECK(steps[width / 2 - 1] < 1.3 * usual);
        }
    }
}

// From 4 km a pixel is wider than any wave that has an octave; from 3 m it is a few millimetres wide. Noise is no Gaussian: its fourth moment
// is 2.7 of its square's for 3, and its sums are nearer. Of 24 places a few dozen waves are seen of the widest.
TEST_CASE("the sea's glint has the same light in the mean where its waves are seen as where they are not") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    Ground sea(even_height(-100.0, true));
    for (const double pitch_deg : {-70.0, -40.0, -20.0})
        for (const double beside_deg : {0.0, 8.0, 16.0}) {
            const auto glint = [&](double altitude_m) {
                double sum = 0.0, square = 0.0;
                for (int place = 0; place < 24; ++place) {
                    const Viewpoint view{
                        .latitude = 0.4, .longitude = 0.2 * place, .altitude_m = altitude_m, .heading = 1.0, .pitch = pitch_deg * deg};
                    Camera camera = look(view, radius_m);
                    camera.vertical_field_of_view = 6.0 * deg;
                    Viewpoint sun = view;
                    sun.pitch = -view.pitch - beside_deg * deg;
                    const Looks looks = sea.draw(camera, {.towards_sun = look(sun, radius_m).forward, .sun = Vec3(1.0), .sky = Vec3(0.0)});
                    for (const double one : looks.light)
                        sum += one / (24.0 * width * height), square += one * one / (24.0 * width * height);
                }
                return std::pair{sum, std::sqrt(square / (sum * sum) - 1.0)};
            };
            const auto [near, rough] = glint(3.0);
            const auto [far, even] = glint(4e3);
            fmt::print("  pitch {:.0f}, sun {:>2.0f} deg beside: near {:.4f} (spread {:.2f}), far {:.4f} (spread {:.2f})\n", pitch_deg,
                       beside_deg, near, rough, far, even);
            CHECK(rough > 1.3 * even);
            CHECK(near == doctest::Approx(far).epsilon(0.03));
        }
}

namespace {

// Of light that still water of a refractive index of 1.33 reflects at an angle of this cosine.
double fresnel(double c) {
    const double index = 1.33, inner = std::sqrt(1.0 - (1.0 - c * c) / (index * index));
    const double across = (c - index * inner) / (c + index * inner), along = (index * c - inner) / (index * c + inner);
    return 0.5 * (across * across + along * along);
}

// Of waves whose slopes are Gaussian, by the areas that the eye sees of them at an angle from straight down.
double reflectance_of_waves(double zenith, double mean_square) {
    std::mt19937 random(3);
    std::normal_distribution<double> slope(0.0, std::sqrt(0.5 * mean_square));
    const Vec3 view(std::sin(zenith), 0.0, std::cos(zenith));
    double sum = 0.0, area = 0.0;
    for (int n = 0; n < 100'000; ++n) {
        const double x = slope(random), y = slope(random);
        const Vec3 tilted(-x, -y, 1.0);
        const double seen = std::max(0.0, glm::dot(tilted, view));
        sum += seen * fresnel(std::min(seen / glm::length(tilted), 1.0)), area += seen;
    }
    return sum / area;
}

}  // namespace

// Near waves hide nothing of each other here, and those that lean away from the eye, which it would not see, have their share of pixels.
TEST_CASE("the sea mirrors of an even sky what the sum over its waves says, where they are seen and where they are not") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    Ground sea(even_height(-100.0, true));
    for (const double pitch_deg : {-80.0, -50.0, -30.0, -15.0, -8.0}) {
        const auto share = [&](double altitude_m) {
            std::vector<double> all;
            for (int place = 0; place < 12; ++place) {
                const Viewpoint view{
                    .latitude = 0.4, .longitude = 0.2 * place, .altitude_m = altitude_m, .heading = 1.0, .pitch = pitch_deg * deg};
                Camera camera = look(view, radius_m);
                camera.vertical_field_of_view = 2.0 * deg;
                const Looks looks = sea.draw(camera, {.towards_sun = camera.up, .sun = Vec3(0.0), .sky = Vec3(pi)});
                all.insert(all.end(), looks.light.begin(), looks.light.end());
            }
            double sum = 0.0;
            for (const double one : all) sum += one / static_cast<double>(all.size());
            return sum - ground_materials()[5].reflectance.y;
        };
        const double expected = reflectance_of_waves((90.0 + pitch_deg) * deg, 0.04), near = share(3.0), far = share(4e3);
        fmt::print("  pitch {:.0f}: {:.4f} of the sky, near {:.4f}, far {:.4f}\n", pitch_deg, expected, near, far);
        CHECK(far == doctest::Approx(expected).epsilon(0.08));
        CHECK(near == doctest::Approx(expected).epsilon(0.12));
    }
}

// A coast that rises by a hundredth northward: sand covers 2 m of height wholly and 28 m half, a strip of 1600 m.
TEST_CASE("a beach has the same sand from near, where it is many pixels wide, as from afar, where it is a part of one") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    HeightField coast = even_height(0.0, true);
    coast.sample = [](Vec3 d, double) {
        return HeightSample{std::clamp(0.01 * radius_m * std::asin(d.z), -600.0, 600.0), Vec3(0.0), Vec3(0.0), Vec3(0.0)};
    };
    coast.range = [](const Cap&) { return Interval{-600.0, 600.0}; };
    coast.whole = {-600.0, 600.0};
    Ground ground(coast);
    const double sea = ground_materials()[5].reflectance.x, sand = ground_materials()[2].reflectance.x,
                 grass = ground_materials()[0].reflectance.x;
    for (const double altitude_m : {5e3, 5e4, 3e5}) {
        const Camera camera = above(0.0, 10.0, altitude_m);
        const double pixel_m = 2.0 * altitude_m * half_size(camera).height / height;
        const int rows = std::clamp(static_cast<int>(std::ceil(4000.0 / pixel_m)), 5, height / 2);
        double sum = 0.0;
        const Looks looks = ground.draw(camera);
        for (int row = height / 2 - rows; row < height / 2 + rows; ++row)
            for (int column = 0; column < width; ++column)
                sum += looks.reflectance[static_cast<std::size_t>(row * width + column)].x * pixel_m / width;
        const double strip_m = (sum - rows * pixel_m * (sea + grass)) / (sand - grass);
        fmt::print("  a pixel of {:>5.0f} m: a strip of {:.0f} m\n", pixel_m, strip_m);
        CHECK(strip_m == doctest::Approx(1600.0).epsilon(0.15));
    }
}
