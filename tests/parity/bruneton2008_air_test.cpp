// The air by the tables of bruneton2008 against `airlight` on the CPU: what its text answers for rays, from the ground to space; and that
// what the older programs of these tables got wrong stays right [Sperlhofer2011, chapter 5].

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "atmosphere/presets.h"
#include "models/model.h"
#include "physics/f64.h"
#include "render/bruneton2008_air.h"
#include "render/shaders.h"
#include "tools/gpu_case.h"
#include "tools/temporary_folder.h"

using namespace airlight;
using namespace airlight::test;

namespace {

const std::vector<Wavelength> wavelengths = {450.0 * nm, 500.0 * nm, 550.0 * nm, 650.0 * nm};
// The source of the GPU's tables and of the truth alike, coarser than a picture's: it is what the tables make of it that is asked here.
constexpr BakeSettings around = {
    .sizes = {.transmittance_mu = 256, .transmittance_altitude = 64, .sun = 24, .azimuth = 4, .view = 8, .altitude = 12},
    .orders = 4,
    .extrapolate = false};

// A ray from the eye up to a distance.
constexpr double all_of_it = 1e12;
struct Question {
    double zenith, azimuth;  // from the sun
    double distance_m;
};
struct Answer {
    std::array<double, 4> light, transmittance;
};

// The text of the method, asked for rays.
class Asked {
public:
    Asked(const Atmosphere& atmosphere, const Bruneton2008Settings& texels) : shell_(atmosphere) {
        const Result<gpu::ShaderText> text = gpu::resolve_includes(R"(#version 450 core
#include "bruneton2008_air.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Rays { vec4 rays[]; };
layout(std430, binding = 1) writeonly buffer Answers { vec4 answers[]; };
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= rays.length()) return;
    AirSeen seen = air_seen(rays[i].xyz, rays[i].w);
    answers[2 * i] = seen.inscattered;
    answers[2 * i + 1] = seen.transmittance;
}
)",
                                                                   gpu::ReadText([](const std::string& path) -> Result<std::string> {
                                                                       const Result<gpu::ShaderText> file = render::shader_text(path);
                                                                       if (!file) return file.error();
                                                                       return file->text;
                                                                   }));
        REQUIRE(text);
        Result<gpu::Program> made = gpu::Program::compute("rays", *text);
        if (!made) FAIL(made.error().message());
        made->bind_block("AirlightBlock", 1);
        program_.emplace(std::move(*made));
        Result<std::shared_ptr<const render::Bruneton2008Programs>> programs = render::bruneton2008_programs();
        if (!programs) FAIL(programs.error().message());
        air_.emplace(render::Bruneton2008Bake(*programs, atmosphere, wavelengths, texels, around),
                     std::vector<Vec3>(wavelengths.size(), Vec3(1.0)));
        gpu::PassTimers timers;
        air_->prepare({}, timers);
    }

    std::vector<Answer> operator()(double altitude_m, double sun_zenith, const std::vector<Question>& questions) const {
        const auto f = [](double x) { return static_cast<float>(x); };
        // `uniform AirView`: the eye on the axis z, the sun above x.
        std::array<float, 32> view{};
        view[2] = 1.0f, view[3] = f(altitude_m);
        view[4] = f(std::sin(sun_zenith)), view[6] = f(std::cos(sun_zenith)), view[7] = f(shell_.sun.angular_radius);
        view[8] = f(shell_.bottom_radius.in(m)), view[9] = f(shell_.top_altitude.in(m));
        std::vector<float> rays;
        for (const Question& q : questions)
            rays.insert(rays.end(), {f(std::sin(q.zenith) * std::cos(q.azimuth)), f(std::sin(q.zenith) * std::sin(q.azimuth)),
                                     f(std::cos(q.zenith)), f(q.distance_m)});
        const gpu::Buffer view_block(std::as_bytes(std::span(view))), asked(std::as_bytes(std::span(rays)));
        const gpu::Buffer answered(questions.size() * 8 * sizeof(float));
        air_->bind(0);
        view_block.bind_uniform(2), asked.bind_storage(0), answered.bind_storage(1);
        program_->dispatch(static_cast<unsigned>(questions.size() + 63) / 64);
        std::vector<std::array<float, 8>> values(questions.size());
        answered.read(std::as_writable_bytes(std::span(values)));
        std::vector<Answer> answers;
        for (const std::array<float, 8>& v : values) answers.push_back({{v[0], v[1], v[2], v[3]}, {v[4], v[5], v[6], v[7]}});
        return answers;
    }

private:
    Atmosphere shell_;
    std::optional<gpu::Program> program_;
    std::optional<render::Bruneton2008Air> air_;
};

class Truth {
public:
    explicit Truth(const Atmosphere& atmosphere)
        : sky_(*make_sky("airlight", atmosphere, wavelengths, {.bake = around, .cache = {.folder = folder_.path}})) {}

    std::vector<double> operator()(double altitude_m, double sun_zenith, const Question& q) const {
        return sky_->aerial_perspective({altitude_m * m, q.zenith, sun_zenith, q.azimuth}, q.distance_m * m)->inscattered_W_m2_sr_nm;
    }

private:
    TemporaryFolder folder_;
    std::unique_ptr<Sky> sky_;
};

// The sum of differences over the sum of the truth.
double mean_error(const Asked& gpu, const Truth& truth, double altitude_m, double sun_zenith, const std::vector<Question>& questions) {
    const std::vector<Answer> answers = gpu(altitude_m, sun_zenith, questions);
    double difference = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < questions.size(); ++i) {
        const std::vector<double> expected = truth(altitude_m, sun_zenith, questions[i]);
        for (std::size_t w = 0; w < wavelengths.size(); ++w) difference += std::abs(answers[i].light[w] - expected[w]), sum += expected[w];
    }
    return difference / sum;
}

// The largest difference of a ray at a wavelength, over the truth.
double worst_error(const Asked& gpu, const Truth& truth, double altitude_m, double sun_zenith, const std::vector<Question>& questions) {
    const std::vector<Answer> answers = gpu(altitude_m, sun_zenith, questions);
    double worst = 0.0;
    for (std::size_t i = 0; i < questions.size(); ++i) {
        const std::vector<double> expected = truth(altitude_m, sun_zenith, questions[i]);
        for (std::size_t w = 0; w < wavelengths.size(); ++w) worst = std::max(worst, std::abs(answers[i].light[w] / expected[w] - 1.0));
    }
    return worst;
}

double dip(const Atmosphere& air, double altitude_m) { return std::acos(air.bottom_radius.in(m) / (air.bottom_radius.in(m) + altitude_m)); }

}  // namespace

TEST_CASE("the air by tables is within 5 % of airlight from 0 m to 20 000 km, the sun at 0 to 96 degrees, before surfaces in dusk 8 %") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const Atmosphere atmosphere = *preset("earth-clear");
    const Asked gpu(atmosphere, render::fine_texels);
    const Truth truth(atmosphere);
    double all = 0.0;
    int count = 0;
    fmt::print("  mean error, %            whole  surfaces\n");
    for (const double altitude_m : {0.0, 2e3, 1e4, 3e4, 4e5, 2e7})
        for (const double sun_deg : {0.0, 30.0, 60.0, 80.0, 88.0, 93.0, 96.0}) {
            // Over what an eye sees of the air: all of the sky and the ground, or from space the planet and the air beside it.
            const double lowest = 90.0 * deg + dip(atmosphere, altitude_m);
            const double first = altitude_m > 1e5 ? lowest - 0.5 * (lowest - 90.0 * deg) : 1.0 * deg;
            std::vector<Question> whole, before;
            for (int i = 0; i < 24; ++i)
                for (int j = 0; j < 6; ++j) {
                    const double azimuth = (10.0 + 32.0 * j) * deg, zenith = std::lerp(first, 179.0 * deg, i / 23.0);
                    // From the ground itself there is no way to it.
                    if (altitude_m > 0.0 || zenith < lowest) whole.push_back({zenith, azimuth, all_of_it});
                    // Surfaces: 30 km away in the sky, and some way above the ground.
                    const f64::Length over = f64::Length::of(std::min(1e3, 0.5 * altitude_m)),
                                      bottom = f64::Length::of(atmosphere.bottom_radius.in(m));
                    if (f64::meets_ground(f64::Length::of(altitude_m) - over, std::cos(zenith), bottom + over))
                        before.push_back(
                            {zenith, azimuth,
                             f64::distance_to_ground(f64::Length::of(altitude_m) - over, std::cos(zenith), bottom + over).value});
                    else if (altitude_m < 1e5 && zenith < lowest) before.push_back({zenith, azimuth, 3e4});
                }
            const double sky = mean_error(gpu, truth, altitude_m, sun_deg * deg, whole);
            const double surfaces = mean_error(gpu, truth, altitude_m, sun_deg * deg, before);
            fmt::print("  {:>8.0f} m, sun {:>2.0f} {:>10.3f} {:>9.3f}\n", altitude_m, sun_deg, 100.0 * sky, 100.0 * surfaces);
            CHECK(sky <= 0.05);
            CHECK(surfaces <= (sun_deg > 90.0 ? 0.08 : 0.05));
            all += sky + surfaces, count += 2;
        }
    fmt::print("  in the mean {:.3f}\n", 100.0 * all / count);
    CHECK(all / count <= 0.015);
}

TEST_CASE("what older programs of these tables got wrong is right: no noise and no seam beside the horizon, no peak below it, no bands") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const Atmosphere atmosphere = *preset("earth-clear");
    // Of half as many texels as a picture's.
    const Asked gpu(atmosphere, {.altitude = 32, .sun = 48, .twilight = true});
    const Truth truth(atmosphere);

    // Half floats and radii lost the horizon [Sperlhofer2011, section 5.1]: here the light is airlight's on both sides, ray by ray.
    for (const double altitude_m : {2.0, 500.0, 5e3, 2e4}) {
        const double horizon = 90.0 * deg + dip(atmosphere, altitude_m);
        const double distance = std::sqrt(altitude_m * (2.0 * atmosphere.bottom_radius.in(m) + altitude_m));
        std::vector<Question> whole, before;
        for (int i = -40; i <= 40; ++i) {
            if (i == 0) continue;
            whole.push_back({horizon + i * 0.02 * deg, 1.0, all_of_it});
            before.push_back({horizon + i * 0.02 * deg, 1.0, 0.9 * distance});
        }
        for (const double sun_deg : {40.0, 86.0})
            for (const std::vector<Question>& questions : {whole, before}) {
                const double worst = worst_error(gpu, truth, altitude_m, sun_deg * deg, questions);
                fmt::print("  {:>6.0f} m, sun {}, {}: {:.2f} %\n", altitude_m, sun_deg,
                           questions[0].distance_m < all_of_it ? "before surfaces" : "whole rays", 100.0 * worst);
                CHECK(worst <= 0.08);
            }
    }

    // The rule of proportion gave aerosol's peak to rays that the ground ends [Sperlhofer2011, section 5.1].
    for (const double altitude_m : {100.0, 3e3}) {
        std::vector<Question> below;
        for (int i = 1; i <= 24; ++i) below.push_back({90.0 * deg + dip(atmosphere, altitude_m) + i * 0.25 * deg, 0.0, all_of_it});
        for (const double sun_deg : {86.0, 91.0}) CHECK(mean_error(gpu, truth, altitude_m, sun_deg * deg, below) <= 0.05);
    }

    // Tables of 16 and of 8 bits gave bands [Sperlhofer2011, section 5.2]: light before a surface grows with its distance, without a step.
    for (const double altitude_m : {2.0, 1000.0})
        for (const double zenith_deg : {85.0, 89.0}) {
            std::vector<Question> questions;
            for (int i = 0; i < 400; ++i) questions.push_back({zenith_deg * deg, 0.7, 100.0 * (i + 1)});
            const std::vector<Answer> answers = gpu(altitude_m, 50.0 * deg, questions);
            for (std::size_t w = 0; w < wavelengths.size(); ++w)
                for (std::size_t i = 1; i + 1 < answers.size(); ++i) {
                    const double step = answers[i].light[w] - answers[i - 1].light[w], next = answers[i + 1].light[w] - answers[i].light[w];
                    CHECK(step > 0.0);
                    CHECK(next <= 2.0 * step + 1e-3 * answers.back().light[w] / 400.0);
                }
        }
}

TEST_CASE("tables that are filled between pictures are those that the first picture fills") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const std::vector<Vec3> colours(wavelengths.size(), Vec3(1.0));
    const Result<std::shared_ptr<const render::Bruneton2008Programs>> programs = render::bruneton2008_programs();
    REQUIRE(programs);
    const Bruneton2008Settings texels = {.altitude = 4, .view = 8, .sun = 8, .nu = 2, .twilight = true};
    const BakeSettings few = {
        .sizes = {.transmittance_mu = 32, .transmittance_altitude = 16, .sun = 8, .azimuth = 4, .view = 8, .altitude = 8}, .orders = 2};
    const auto air = [&] {
        return render::Bruneton2008Air(render::Bruneton2008Bake(*programs, *preset("mars"), wavelengths, texels, few), colours);
    };
    gpu::PassTimers timers;
    render::Bruneton2008Air at_once = air(), between = air();
    at_once.prepare({}, timers);
    const std::size_t all = timers.read().size();
    std::size_t passes = 0;
    bool whole = false;
    for (int pictures = 0; !whole && pictures < 1000; ++pictures) {
        whole = between.begin(timers);
        const std::size_t done = timers.read().size();
        CHECK(done > 0);  // each time goes on
        passes += done;
    }
    CHECK(whole);
    CHECK(passes == all);
    CHECK(between.begin(timers));
    between.prepare({}, timers);
    CHECK(timers.read().empty());
    CHECK(between.pictures() == at_once.pictures());
}
