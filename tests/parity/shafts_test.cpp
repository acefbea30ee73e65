// Light shafts: each method against brute force, between mountains and above them; where nothing casts a shadow none of the light is lost,
// and where all is shadow, all of what is scattered once. AIRLIGHT_PICTURES=<folder> keeps the shares.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <numeric>

#include "atmosphere/presets.h"
#include "image/png.h"
#include "render/air_pass.h"
#include "render/camera_block.h"
#include "render/shafts_pass.h"
#include "terrain/procedural_relief.h"
#include "tools/gpu_case.h"
#include "tools/must.h"

using namespace airlight;
using namespace airlight::test;
using render::Shafts;

namespace {

constexpr int width = 64, height = 36;
constexpr double latitude = 36.2 * deg, longitude = 31.5 * deg;

// A method that is never drawn: the pass of air only tells what it knows of the frame.
class NoMethod : public render::AirMethod {
public:
    std::string shader() const override { return "air_exact.frag"; }
    void prepare(const render::AirEye&, gpu::PassTimers&) override {}
    int pictures() const override { return 0; }
    void bind(int) const override {}
};

Atmosphere air_of(const HeightField& field) {
    Atmosphere air = *preset("earth-clear");
    air.bottom_radius = field.radius_m * m;
    return air;
}

class Scene {
public:
    explicit Scene(const HeightField& field)
        : air_(air_of(field)),
          pass_(must(render::AirPass::create({air_, wavelengths_, colours_}, std::make_unique<NoMethod>()))),
          terrain_(must(render::TerrainPass::create(
              field, {.pixels_per_radian = 0.5 * height / std::tan(30.0 * deg), .pixels_of_error = 1.0, .pixels_of_square = 5.0}))) {}

    // What the methods are asked about from now on.
    void look(const Camera& camera, Vec3 towards_sun) {
        view_ = camera, sun_ = towards_sun;
        camera_.bind(view_);
        surfaces_.begin();
        terrain_.draw(view_);
        render::GeometryBuffer::end();
        gpu::PassTimers timers;
        pass_.prepare(view_, sun_, timers);
        shadows_.draw(terrain_, objects_, view_, sun_);
    }

    // Red, green, blue and the surface's light of each pixel, the lowest row first.
    std::vector<float> shade(Shafts method, int pixels_of_ray = 1) const {
        const render::ShaftsPass shafts = must(render::ShaftsPass::create(width, height, method, &air_, pixels_of_ray));
        camera_.bind(view_);
        shafts.draw(surfaces_, shadows_, view_);
        std::vector<float> texels(4 * width * height);
        shafts.shade().read(texels);
        return texels;
    }

private:
    std::vector<Wavelength> wavelengths_ = {550.0 * nm};
    std::vector<Vec3> colours_ = {Vec3(1.0)};
    Atmosphere air_;
    render::AirPass pass_;
    render::TerrainPass terrain_;
    render::GeometryBuffer surfaces_ = must(render::GeometryBuffer::create(width, height));
    render::ObjectPass objects_ = must(render::ObjectPass::create({}));
    render::ShadowPass shadows_ = must(render::ShadowPass::create());
    render::CameraBlock camera_;
    Camera view_;
    Vec3 sun_;
};

Camera camera_at(const HeightField& field, double altitude_m, double heading_deg, double pitch_deg) {
    Camera camera = look(
        Viewpoint{
            .latitude = latitude, .longitude = longitude, .altitude_m = altitude_m, .heading = heading_deg * deg, .pitch = pitch_deg * deg},
        field.radius_m);
    camera.width = width, camera.height = height;
    return camera;
}

Vec3 sun_at(const HeightField& field, double heading_deg, double elevation_deg) {
    return camera_at(field, 0.0, heading_deg, elevation_deg).forward;
}

void keep_picture(const std::vector<float>& shade, const std::string& name) {
    const char* folder = std::getenv("AIRLIGHT_PICTURES");
    if (!folder) return;
    Image image(width, height, 3);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            for (std::size_t c = 0; c < 3; ++c)
                image.pixel(column, row)[c] = shade[static_cast<std::size_t>(4 * ((height - 1 - row) * width + column)) + c];
    CHECK(write_png(std::filesystem::path(folder) / (name + ".png"), image));
}

struct Method {
    Shafts method;
    std::string_view name;
    double mean, high, worst;  // error of a share that is allowed: in the mean, of 99 in 100, of all
};
constexpr std::array<Method, 4> methods = {{{Shafts::epipolar, "epipolar", 0.0075, 0.06, 0.5},
                                            {Shafts::marched, "marched", 0.018, 0.14, 0.5},
                                            {Shafts::planes, "planes", 0.008, 0.06, 0.5},
                                            {Shafts::volumes, "volumes", 0.008, 0.06, 0.5}}};

struct Difference {
    double mean = 0.0, high = 0.0, worst = 0.0;
};
Difference difference(const std::vector<float>& a, const std::vector<float>& b) {
    std::vector<double> errors;
    for (std::size_t at = 0; at < a.size(); ++at)
        if (at % 4 < 3) errors.push_back(std::abs(static_cast<double>(a[at]) - static_cast<double>(b[at])));
    std::sort(errors.begin(), errors.end());
    return {std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size()), errors[errors.size() * 99 / 100],
            errors.back()};
}

double mean_share(const std::vector<float>& shade) { return 1.0 - difference(shade, std::vector<float>(shade.size(), 1.0f)).mean; }

// A flat ground, but for a wall towards the east that reaches above the air.
HeightField walled_ground(double radius_m) {
    const Vec3 zenith = direction_of(latitude, longitude), east(-std::sin(longitude), std::cos(longitude), 0.0);
    const auto sample = [=](Vec3 d, double) {
        const double away_m = radius_m * std::atan2(glm::dot(d, east), glm::dot(d, zenith));
        const double rise = std::clamp((away_m - 30'000.0) / 20'000.0, 0.0, 1.0);
        return HeightSample{130'000.0 * rise, Vec3(0.0), Vec3(0.0), Vec3(0.0)};
    };
    return {.radius_m = radius_m,
            .sample = sample,
            .range =
                [](const Cap&) {
                    return Interval{0.0, 130'000.0};
                },
            .detail = [](double spacing_m) { return 0.01 * spacing_m; },
            .whole = {0.0, 130'000.0},
            .sea = false};
}

}  // namespace

TEST_CASE("light shafts: each method is near brute force, in a valley, over mountains and from above the air") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const HeightField field = procedural_height({.sea = false});
    Scene scene(field);
    const double ground = field.sample(direction_of(latitude, longitude), 1.0).height_m;
    struct View {
        std::string_view name;
        double altitude_m, heading_deg, pitch_deg, sun_heading_deg, sun_elevation_deg;
    };
    const std::array<View, 4> views = {{{"valley", ground + 50.0, 280.0, 5.0, 300.0, 6.0},
                                        {"beside", ground + 3000.0, 30.0, -5.0, 300.0, 4.0},
                                        {"towards", ground + 4000.0, 300.0, -3.0, 300.0, 3.0},
                                        {"orbit", 4e5, 30.0, -40.0, 300.0, 4.0}}};
    fmt::print("  {:>8} {:>6}", "", "share");
    for (const Method& m : methods) fmt::print(" {:>18}", m.name);
    fmt::print(" {:>18}\n", "epipolar, 2 x 2");
    for (const View& v : views) {
        CAPTURE(v.name);
        scene.look(camera_at(field, v.altitude_m, v.heading_deg, v.pitch_deg), sun_at(field, v.sun_heading_deg, v.sun_elevation_deg));
        const std::vector<float> truth = scene.shade(Shafts::brute);
        keep_picture(truth, fmt::format("shafts-{}-brute", v.name));
        fmt::print("  {:>8} {:>6.3f}", v.name, mean_share(truth));
        for (const Method& m : methods) {
            CAPTURE(m.name);
            const std::vector<float> shade = scene.shade(m.method);
            keep_picture(shade, fmt::format("shafts-{}-{}", v.name, m.name));
            const Difference d = difference(shade, truth);
            fmt::print("  {:.4f} {:.3f} {:.3f}", d.mean, d.high, d.worst);
            CHECK(d.mean <= m.mean);
            CHECK(d.high <= m.high);
            CHECK(d.worst <= m.worst);
        }
        // Between the rays of two by two pixels, in a picture so small that neighbouring rays have little in common.
        const Difference shared = difference(scene.shade(Shafts::epipolar, 2), truth);
        fmt::print("  {:.4f} {:.3f} {:.3f}\n", shared.mean, shared.high, shared.worst);
        CHECK(shared.mean <= 0.0095);
        CHECK(shared.high <= 0.11);
        CHECK(shared.worst <= 0.36);
    }
}

TEST_CASE("light shafts: where nothing casts a shadow all of the light stays") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    HeightField level = procedural_height({});
    level.sample = [](Vec3, double) { return HeightSample{0.0, Vec3(0.0), Vec3(0.0), Vec3(0.0)}; };
    level.range = [](const Cap&) { return Interval{}; };
    level.whole = {};
    Scene scene(level);
    scene.look(camera_at(level, 500.0, 20.0, -2.0), sun_at(level, 60.0, 30.0));
    for (const Shafts method : {Shafts::brute, Shafts::planes, Shafts::volumes, Shafts::none})
        CHECK(mean_share(scene.shade(method)) == 1.0);
    // Places of their own may lie a little below flat triangles of a round planet.
    for (const Shafts method : {Shafts::epipolar, Shafts::marched}) CHECK(mean_share(scene.shade(method)) > 0.9998);
}

TEST_CASE("light shafts: seen from space, the day side of a planet has none") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const HeightField field = procedural_height({.sea = false});
    Scene scene(field);
    scene.look(camera_at(field, 1.2e7, 30.0, -90.0), sun_at(field, 60.0, 70.0));
    for (const Shafts method : {Shafts::brute, Shafts::epipolar, Shafts::marched})
        for (const int pixels_of_ray : {1, 2}) {
            const std::vector<float> shade = scene.shade(method, pixels_of_ray);
            for (std::size_t at = 0; at < shade.size(); ++at)
                if (at % 4 < 3) CHECK(shade[at] > 0.9f);
        }
}

TEST_CASE("light shafts: behind a wall as high as the air nothing stays of light scattered once, on the ground nothing of the sun's") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const HeightField field = walled_ground(6'371'000.0);
    Scene scene(field);
    // Down to the ground, which is in the shadow from the eye on.
    scene.look(camera_at(field, 50.0, 270.0, -35.0), sun_at(field, 90.0, 10.0));
    for (const Shafts method : {Shafts::brute, Shafts::epipolar, Shafts::marched, Shafts::planes, Shafts::volumes}) {
        const std::vector<float> shade = scene.shade(method);
        CHECK(*std::max_element(shade.begin(), shade.end()) == 0.0f);
    }
    // Along the sky, where the far end of a ray is above the shadow, in nearly no air; `volumes` takes that end for the eye's.
    scene.look(camera_at(field, 50.0, 270.0, 12.0), sun_at(field, 90.0, 10.0));
    for (const Shafts method : {Shafts::brute, Shafts::epipolar, Shafts::marched, Shafts::planes})
        CHECK(mean_share(scene.shade(method)) < 0.01);
}
