#include "render/bruneton2008_tables.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <utility>

#include "gpu/program.h"
#include "models/airlight_block.h"
#include "physics/models/f64.h"
#include "render/shaders.h"
#include "transport/pack_arithmetic.h"
#include "transport/view_rule.h"

namespace airlight::render {

namespace {

// Directions around a point, and the harmonics in which light is scattered. tests/parity/bruneton2008_test.cpp compares them with the
// finer ones of the bake on the CPU.
constexpr ViewAngles view_angles{.sky = 16, .ground = 10, .layer = 6};
constexpr HarmonicLayout layout{16};
constexpr int azimuths = 18;  // midpoints over half a turn: exact for products of two harmonics
constexpr int multiples = layout.degree + 1;
constexpr int harmonics = multiples * multiples;  // [degree][multiple of the azimuth]

// On a piece of a way: sunlight has edges that higher orders lack.
constexpr int nodes_for_sunlight = 16;
constexpr int nodes_for_source = 6;

constexpr unsigned work_group = 64;
constexpr unsigned air_binding = 1, bake_binding = 2;
enum Storage : unsigned { ways_at, way_nodes_at, third_at, fourth_at, fifth_at, sixth_at, seventh_at };
enum Sampler : unsigned { densities_at, transmittance_at, source_at, diffuse_at, soft_phases_at };

// `uniform BakeBlock`.
struct BakeBlock {
    int suns, azimuths, angles, altitudes;
    int degree, capacity, scatterers, order;
    int views, table_suns, nus, table_altitudes;
    int first, twilight, padding[2];
    int part_of[8];
};

// `struct Way`.
struct Way {
    float h, mu, grounded, nodes;
    float end[4], transmittance[4];
};
constexpr std::size_t way_node_bytes = 80;

template <class T>
gpu::Buffer buffer_of(const std::vector<T>& values) {
    return gpu::Buffer(std::as_bytes(std::span(values)));
}

gpu::Buffer buffer_of_spectra(std::size_t count) { return gpu::Buffer(count * 4 * sizeof(float)); }

constexpr const char* pass_names[] = {"transmittance", "ways",    "radiance", "turns",   "irradiance",
                                      "moments",       "density", "single",   "multiple"};

double fraction(int i, int size) { return static_cast<double>(i) / (size - 1); }

// At the ground, the way to the ground is taken from here, in metres: the light on it, over its gain, has a limit there.
constexpr double lowest_m = 1.0;

AltitudeAxis table_altitudes(const PackAir& air, const Bruneton2008Settings& texels) {
    return {air.shell.top_m, air.densities.jumps_m(), texels.altitude};
}

// The directions of the scattering tables, by altitude.
std::vector<Way> ways_of_tables(const Shell& shell, const Bruneton2008Settings& texels, const AltitudeAxis& altitudes) {
    const f64::Length bottom = f64::Length::of(shell.bottom_m), top = f64::Length::of(shell.top_m);
    std::vector<Way> ways;
    for (int k = 0; k < texels.altitude; ++k) {
        const f64::Length h = f64::Length::of(altitudes.altitude_m(k));
        for (int v = 0; v < texels.view; ++v) {
            const int half = texels.view / 2;
            const bool ground = v < half;
            const f64::Length above = ground ? std::max(h, f64::Length::of(lowest_m)) : h;
            const double mu = ground ? f64::bruneton2008_ground_cosine(above, fraction(v, half), bottom).value
                                     : f64::bruneton2008_sky_cosine(h, fraction(v - half, half), bottom, top).value;
            ways.push_back({static_cast<float>(above.value), static_cast<float>(mu), ground ? 1.0f : 0.0f, 0.0f, {}, {}});
        }
    }
    return ways;
}

// The points around which light is gathered, and the harmonics there.
struct Around {
    int angles = 0;               // the most that an altitude has
    std::vector<Way> ways;        // [altitude][angle]
    std::vector<float> cosines;   // [altitude][angle]: mu and its weight
    std::vector<float> legendre;  // [altitude][angle][harmonic], times the weight
};

Around around(const PackAir& air) {
    std::vector<ViewRule> rules;
    Around made;
    for (int k = 0; k < air.source_axis.size(); ++k) {
        rules.push_back(view_rule(layout, view_angles, view_edges(air.shell, air.densities, air.source_axis.altitude_m(k))));
        made.angles = std::max(made.angles, static_cast<int>(rules.back().angles.size()));
    }
    for (int k = 0; k < air.source_axis.size(); ++k) {
        ViewRule& rule = rules[static_cast<std::size_t>(k)];
        // Where there are fewer edges, angles of no weight fill the row.
        rule.angles.resize(static_cast<std::size_t>(made.angles), {1.0, 0.0f, legendre_values(layout, 1.0)});
        const double h = air.source_axis.altitude_m(k);
        for (const ViewRule::Angle& angle : rule.angles) {
            const bool ground = f64::meets_ground(f64::Length::of(h), angle.mu, f64::Length::of(air.shell.bottom_m));
            made.ways.push_back({static_cast<float>(h), static_cast<float>(angle.mu), ground ? 1.0f : 0.0f, 0.0f, {}, {}});
            made.cosines.insert(made.cosines.end(), {static_cast<float>(angle.mu), angle.weight});
            for (int l = 0; l < multiples; ++l)
                for (int k_phi = 0; k_phi < multiples; ++k_phi)
                    made.legendre.push_back(k_phi <= l ? angle.weight * angle.legendre[static_cast<std::size_t>(layout.index(l, k_phi))]
                                                       : 0.0f);
        }
    }
    return made;
}

// Shares of a turn times the cosine of each multiple of the azimuth: [azimuth][multiple].
std::vector<float> turn_weights() {
    std::vector<float> weights;
    for (int j = 0; j < azimuths; ++j)
        for (int k = 0; k < multiples; ++k)
            weights.push_back(static_cast<float>(2.0 * pi / azimuths * std::cos(k * pi * (j + 0.5) / azimuths)));
    return weights;
}

// Of the texels of the density: [view][harmonic] and [azimuth][multiple].
std::vector<float> legendres_of_views(int views) {
    std::vector<float> values;
    for (int i = 0; i < views; ++i) {
        const std::vector<float> legendre = legendre_values(layout, f64::view_of_coordinate(fraction(i, views)).value);
        for (int l = 0; l < multiples; ++l)
            for (int k = 0; k < multiples; ++k) values.push_back(k <= l ? legendre[static_cast<std::size_t>(layout.index(l, k))] : 0.0f);
    }
    return values;
}
std::vector<float> cosines_of_azimuths(int count) {
    std::vector<float> values;
    for (int j = 0; j < count; ++j) {
        const double phi = std::acos(f64::azimuth_cosine_of_coordinate(fraction(j, count)).value);
        for (int k = 0; k < multiples; ++k) values.push_back(static_cast<float>(std::cos(k * phi)));
    }
    return values;
}

// What the harmonics of light are multiplied by when it scatters, of four wavelengths: [altitude][degree].
std::vector<float> factors_of(const AirOptics& optics, const PackAir& air, const std::vector<std::vector<f64::Spectrum>>& moments,
                              int first) {
    std::vector<float> factors;
    for (int k = 0; k < air.source_axis.size(); ++k) {
        float density[max_parts]{};
        air.densities.at(static_cast<float>(air.source_axis.inner_altitude_m(k)), density);
        for (std::size_t l = 0; l < multiples; ++l)
            for (int w = first; w < first + gpu_wavelengths; ++w) {
                double sum = 0.0, total = 0.0;
                for (std::size_t p = 0; p < optics.parts.size(); ++p) {
                    const double share = optics.parts[p].scattering.v[w] * static_cast<double>(density[p]);
                    total += share;
                    sum += share * moments[p][l].v[w];
                }
                factors.push_back(static_cast<float>(total > 0.0 ? sum / total : l == 0 ? 1.0 : 0.0));
            }
    }
    return factors;
}

// Phase functions of the constituents that scatter as the harmonics have them, so that light is neither lost nor won between the
// directions: [constituent][sample], even in the root of the angle.
gpu::Texture soft_phases(const std::vector<std::vector<f64::Spectrum>>& moments, const std::vector<std::size_t>& parts, int first) {
    constexpr int samples = 513;
    std::vector<float> texels;
    for (const std::size_t p : parts)
        for (int i = 0; i < samples; ++i) {
            const double u = fraction(i, samples), nu = std::cos(pi * u * u);
            for (int w = first; w < first + gpu_wavelengths; ++w) {
                double sum = 0.0, legendre = 1.0, previous = 0.0;
                for (int l = 0; l <= layout.degree; ++l) {
                    sum += (2 * l + 1) / (4.0 * pi) * moments[p][static_cast<std::size_t>(l)].v[w] * legendre;
                    previous = std::exchange(legendre, ((2 * l + 1) * nu * legendre - l * previous) / (l + 1));
                }
                texels.push_back(static_cast<float>(sum));
            }
        }
    return gpu::Texture({samples, std::max(static_cast<int>(parts.size()), 1)}, texels);
}

gpu::Texture phases_of(const PackPhases& phases, int first) {
    const std::vector<float> texels = gpu_phases(phases, first);
    return gpu::Texture({static_cast<int>(texels.size()) / (gpu_wavelengths * f32::airlight_parts), f32::airlight_parts}, texels);
}

unsigned groups_for(int count) { return (static_cast<unsigned>(count) + work_group - 1) / work_group; }

}  // namespace

struct Bruneton2008Bake::State {
    // What the passes of four wavelengths read beside their tables.
    struct Inputs {
        gpu::Buffer air_for_sunlight;
        gpu::Texture soft_phases;
        gpu::Buffer factors;
    };

    State(std::shared_ptr<const Bruneton2008Programs> compiled, const PackAir& air, const Around& around,
          const Bruneton2008Settings& texels, const BakeSettings& settings, const AirlightTables& medium, std::vector<std::size_t> parts);
    void add_groups(const AirOptics& optics, const PackAir& air);
    void plan(std::size_t group);
    void run(const char* pass, int threads);
    void ways(const gpu::Buffer& of, int directions, int altitude);
    void bind(std::size_t group, const gpu::Buffer& air, const gpu::Texture& light_source) const;
    void order(std::size_t group, int n, int altitude);
    void scatter(std::size_t group, int n);

    std::shared_ptr<const Bruneton2008Programs> programs;
    TableSizes sizes;
    int orders;
    BakeBlock block{};
    gpu::Buffer block_buffer{sizeof(BakeBlock)};
    gpu::Buffer points, tables, altitudes, angles, weighted_legendres, weights_of_turns, view_legendres, azimuth_cosines;
    gpu::Buffer point_count, table_count;
    gpu::Buffer way_nodes, radiances, turns, moments, density_sums, irradiance_sums;
    gpu::Texture delta_density, density, delta_irradiance;
    Bruneton2008Textures made;
    std::vector<Inputs> inputs;
    std::vector<std::function<void(gpu::PassTimers&)>> slices;
    std::size_t done = 0;
};

namespace {

std::vector<float> altitudes_of(const AltitudeAxis& axis) {
    std::vector<float> altitudes;
    for (int j = 0; j < axis.size(); ++j) altitudes.push_back(static_cast<float>(axis.altitude_m(j)));
    return altitudes;
}

// A way is cut where densities jump, on both sides of its perigee, there, and after some free paths.
int capacity_of(const f32::AirlightAir& air) { return (2 * air.density_axis.segments + 8) * nodes_for_sunlight; }

}  // namespace

Bruneton2008Bake::State::State(std::shared_ptr<const Bruneton2008Programs> compiled, const PackAir& air, const Around& around,
                               const Bruneton2008Settings& texels, const BakeSettings& settings, const AirlightTables& medium,
                               std::vector<std::size_t> parts)
    : programs(std::move(compiled)),
      sizes(settings.sizes),
      orders(settings.orders),
      block{.suns = sizes.sun,
            .azimuths = azimuths,
            .angles = around.angles,
            .altitudes = sizes.altitude,
            .degree = layout.degree,
            .capacity = capacity_of(medium.air),
            .scatterers = static_cast<int>(parts.size()),
            .order = 1,
            .views = texels.view,
            .table_suns = texels.sun,
            .nus = texels.nu,
            .table_altitudes = texels.altitude,
            .first = 0,
            .twilight = texels.twilight,
            .padding = {},
            .part_of = {}},
      points(buffer_of(around.ways)),
      tables(buffer_of(ways_of_tables(air.shell, texels, table_altitudes(air, texels)))),
      altitudes(buffer_of(altitudes_of(air.transmittance_axis))),
      angles(buffer_of(around.cosines)),
      weighted_legendres(buffer_of(around.legendre)),
      weights_of_turns(buffer_of(turn_weights())),
      view_legendres(buffer_of(legendres_of_views(sizes.view))),
      azimuth_cosines(buffer_of(cosines_of_azimuths(sizes.azimuth))),
      point_count(buffer_of(std::vector<int>{around.angles})),
      table_count(buffer_of(std::vector<int>{texels.view})),
      way_nodes(static_cast<std::size_t>(std::max(around.angles, texels.view) * block.capacity) * way_node_bytes),
      radiances(buffer_of_spectra(static_cast<std::size_t>(sizes.altitude * sizes.sun * around.angles * azimuths))),
      turns(buffer_of_spectra(static_cast<std::size_t>(sizes.altitude * sizes.sun * around.angles * multiples))),
      moments(buffer_of_spectra(static_cast<std::size_t>(sizes.altitude * sizes.sun * harmonics))),
      density_sums(buffer_of_spectra(static_cast<std::size_t>(sizes.altitude * sizes.sun * sizes.view * sizes.azimuth))),
      irradiance_sums(buffer_of_spectra(static_cast<std::size_t>(sizes.altitude * sizes.sun))),
      delta_density({sizes.sun, sizes.view, sizes.altitude * sizes.azimuth}),
      // Dark, as it stays where there is one order.
      density({sizes.sun, sizes.view, sizes.altitude * sizes.azimuth},
              std::vector<float>(static_cast<std::size_t>(4 * sizes.sun * sizes.view * sizes.altitude * sizes.azimuth), 0.0f)),
      delta_irradiance({sizes.sun, 1}),
      made{texels,
           table_altitudes(air, texels),
           std::move(parts),
           gpu::Texture({medium.air.density_axis.texels, 2}, gpu_densities(medium)),
           {}} {
    for (std::size_t i = 0; i < made.parts.size(); ++i) block.part_of[i] = static_cast<int>(made.parts[i]);
}

void Bruneton2008Bake::State::add_groups(const AirOptics& optics, const PackAir& air) {
    const AirlightTables medium = airlight_medium(air, sizes, nodes_for_source);
    AirlightTables for_sunlight = medium;
    for_sunlight.air.rule = airlight_rule(nodes_for_sunlight);
    const PackPhases phases(optics);
    std::vector<std::vector<f64::Spectrum>> moments_of_parts;
    for (const AirOptics::Part& part : optics.parts) moments_of_parts.push_back(part.phase.legendre_moments(multiples));
    const Bruneton2008Settings& texels = made.texels;
    for (int first = 0; first < optics.wavelength_count; first += gpu_wavelengths) {
        made.groups.push_back(
            {gpu::Buffer(airlight_block(medium.air, first)), gpu::Texture({sizes.transmittance_mu, air.transmittance_axis.size()}),
             gpu::Texture({sizes.sun, sizes.altitude}),
             gpu::Texture({texels.sun * texels.nu, texels.view, texels.altitude * (1 + block.scatterers)}), phases_of(phases, first)});
        inputs.push_back({gpu::Buffer(airlight_block(for_sunlight.air, first)), soft_phases(moments_of_parts, made.parts, first),
                          buffer_of(factors_of(optics, air, moments_of_parts, first))});
        plan(made.groups.size() - 1);
    }
}

void Bruneton2008Bake::State::bind(std::size_t group, const gpu::Buffer& air, const gpu::Texture& light_source) const {
    air.bind_uniform(air_binding);
    block_buffer.bind_uniform(bake_binding);
    made.densities.bind_sampler(densities_at);
    made.groups[group].transmittance.bind_sampler(transmittance_at);
    light_source.bind_sampler(source_at);
    delta_irradiance.bind_sampler(diffuse_at);
    inputs[group].soft_phases.bind_sampler(soft_phases_at);
}

void Bruneton2008Bake::State::run(const char* pass, int threads) {
    block_buffer.write(std::as_bytes(std::span(&block, 1)));
    programs->at(pass).dispatch(groups_for(threads));
}

void Bruneton2008Bake::State::ways(const gpu::Buffer& of, int directions, int altitude) {
    block.first = altitude;
    of.bind_storage(ways_at);
    way_nodes.bind_storage(way_nodes_at);
    (&of == &points ? point_count : table_count).bind_storage(third_at);
    run("ways", directions);
}

// The light of order n around the points of an altitude.
void Bruneton2008Bake::State::order(std::size_t group, int n, int altitude) {
    bind(group, n == 1 ? inputs[group].air_for_sunlight : made.groups[group].air, delta_density);
    block.order = n;
    ways(points, block.angles, altitude);
    radiances.bind_storage(third_at);
    run("radiance", sizes.sun * block.angles * azimuths);
}

// What becomes of the light of order n around all points.
void Bruneton2008Bake::State::scatter(std::size_t group, int n) {
    bind(group, made.groups[group].air, delta_density);
    block.order = n;
    const int all = sizes.altitude * sizes.sun;
    radiances.bind_storage(third_at), turns.bind_storage(fourth_at), weights_of_turns.bind_storage(fifth_at);
    run("turns", all * block.angles * multiples);
    angles.bind_storage(sixth_at), irradiance_sums.bind_storage(seventh_at);
    delta_irradiance.bind_image(0), made.groups[group].irradiance.bind_image(1);
    run("irradiance", all);
    if (n == orders) return;  // what would be scattered beyond the last order is not wanted
    weighted_legendres.bind_storage(fifth_at), inputs[group].factors.bind_storage(sixth_at), moments.bind_storage(seventh_at);
    run("moments", all * harmonics);
    view_legendres.bind_storage(fifth_at), azimuth_cosines.bind_storage(sixth_at), density_sums.bind_storage(fourth_at);
    delta_density.bind_image(0), density.bind_image(1);
    run("density", all * sizes.view * sizes.azimuth);
}

void Bruneton2008Bake::State::plan(std::size_t group) {
    const auto add = [&](const char* pass, auto work) {
        slices.push_back([pass, work](gpu::PassTimers& timers) {
            const auto timed = timers.time(pass);
            work();
        });
    };
    add("transmittance", [this, group] {
        bind(group, made.groups[group].air, delta_density);
        altitudes.bind_storage(third_at);
        const gpu::Texture& depths = made.groups[group].transmittance;
        depths.bind_image(0);
        run("transmittance", depths.size().width * depths.size().height);
    });
    for (int n = 1; n <= orders; ++n) {
        for (int k = 0; k < sizes.altitude; ++k)
            add(n == 1 ? "single scattering around points" : "multiple scattering around points",
                [this, group, n, k] { order(group, n, k); });
        add("irradiance and scattering density", [this, group, n] { scatter(group, n); });
    }
    const int texels = made.texels.view * made.texels.sun * made.texels.nu;
    for (int k = 0; k < made.texels.altitude; ++k) {
        add("table of single scattering", [this, group, k, texels] {
            bind(group, inputs[group].air_for_sunlight, density);
            ways(tables, made.texels.view, k);
            made.groups[group].scattering.bind_image(0);
            run("single", texels);
        });
        add("table of multiple scattering", [this, group, k, texels] {
            bind(group, made.groups[group].air, density);
            ways(tables, made.texels.view, k);
            made.groups[group].scattering.bind_image(0);
            run("multiple", texels);
        });
    }
}

Result<std::shared_ptr<const Bruneton2008Programs>> bruneton2008_programs() {
    auto programs = std::make_shared<Bruneton2008Programs>();
    for (const std::string pass : pass_names) {
        const std::string name = "bruneton2008_" + pass + ".comp";
        Result<gpu::Program> made = compute_program(name);
        if (!made) return made.error();
        made->bind_block("AirlightBlock", air_binding);
        programs->emplace(pass, *std::move(made));
    }
    return std::shared_ptr<const Bruneton2008Programs>(std::move(programs));
}

Bruneton2008Bake::Bruneton2008Bake(std::shared_ptr<const Bruneton2008Programs> programs, const Atmosphere& atmosphere,
                                   std::span<const Wavelength> wavelengths, const Bruneton2008Settings& texels,
                                   const BakeSettings& around_points) {
    assert(!wavelengths.empty() && !texels.four_channels && !texels.eight_bits && around_points.orders >= 1);
    for (const std::vector<Wavelength>& pack : packs(wavelengths)) {
        const AirOptics optics = air_optics(atmosphere, pack);
        const PackAir air = pack_air(optics, around_points.sizes);
        if (!state_) {
            std::vector<std::size_t> parts;
            for (std::size_t p = 0; p < optics.parts.size(); ++p)
                if (optics.parts[p].scatters) parts.push_back(p);
            state_ = std::make_unique<State>(std::move(programs), air, around(air), texels, around_points,
                                             airlight_medium(air, around_points.sizes, nodes_for_source), std::move(parts));
        }
        state_->add_groups(optics, air);
    }
}

Bruneton2008Bake::Bruneton2008Bake(Bruneton2008Bake&&) noexcept = default;
Bruneton2008Bake& Bruneton2008Bake::operator=(Bruneton2008Bake&&) noexcept = default;
Bruneton2008Bake::~Bruneton2008Bake() = default;

std::size_t Bruneton2008Bake::slices() const { return state_->slices.size(); }
std::size_t Bruneton2008Bake::done() const { return state_->done; }

void Bruneton2008Bake::advance(gpu::PassTimers& timers) {
    assert(state_->done < state_->slices.size());
    state_->slices[state_->done++](timers);
}

Bruneton2008Textures Bruneton2008Bake::take() && {
    assert(state_->done == state_->slices.size());
    return std::move(state_->made);
}

}  // namespace airlight::render
