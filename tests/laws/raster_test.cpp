// Heights from files: what GDAL's rasters hold is where it belongs, within a bound of memory; bad files are one clear message; and the
// ground made of them keeps the laws of the procedural one.

#include <cpl_conv.h>
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <gdal.h>
#include <ogr_srs_api.h>

#include <cmath>
#include <fstream>
#include <random>
#include <thread>

#include "core/files.h"
#include "terrain/raster_relief.h"
#include "terrain/surface_image.h"
#include "terrain/tile_store.h"
#include "tools/temporary_folder.h"

using namespace airlight;
using namespace airlight::test;

namespace {

struct Written {
    int columns = 64, rows = 32;
    double west = -180.0, north = 90.0, step = 360.0 / 64.0;
    bool placed = true;
    int epsg = 4326;
    double absent = -9999.0;
};

// A GeoTIFF whose pixel (column, row) is height(column, row).
template <class Height>
std::filesystem::path write_raster(const TemporaryFolder& folder, const Written& w, Height height, const char* name = "heights.tif") {
    GDALAllRegister();
    const std::filesystem::path path = folder.path / name;
    char tiled[] = "TILED=YES";
    char* options[] = {tiled, nullptr};
    GDALDatasetH made = GDALCreate(GDALGetDriverByName("GTiff"), path.c_str(), w.columns, w.rows, 1, GDT_Float32, options);
    REQUIRE(made);
    double transform[] = {w.west, w.step, 0.0, w.north, 0.0, -w.step};
    if (w.placed) GDALSetGeoTransform(made, transform);
    if (w.epsg) {
        OGRSpatialReferenceH system = OSRNewSpatialReference(nullptr);
        OSRImportFromEPSG(system, w.epsg);
        GDALSetSpatialRef(made, system);
        OSRDestroySpatialReference(system);
    }
    GDALRasterBandH band = GDALGetRasterBand(made, 1);
    GDALSetRasterNoDataValue(band, w.absent);
    std::vector<float> row(static_cast<std::size_t>(w.columns));
    for (int y = 0; y < w.rows; ++y) {
        for (int x = 0; x < w.columns; ++x) row[static_cast<std::size_t>(x)] = static_cast<float>(height(x, y));
        REQUIRE(GDALRasterIO(band, GF_Write, 0, y, w.columns, 1, row.data(), w.columns, 1, GDT_Float32, 0, 0) == CE_None);
    }
    GDALClose(made);
    return path;
}

// An image whose colours are those of a palette.
std::filesystem::path write_palette(const TemporaryFolder& folder, int columns, int rows) {
    GDALAllRegister();
    const std::filesystem::path path = folder.path / "palette.tif";
    GDALDatasetH made = GDALCreate(GDALGetDriverByName("GTiff"), path.c_str(), columns, rows, 1, GDT_Byte, nullptr);
    REQUIRE(made);
    GDALColorTableH colours = GDALCreateColorTable(GPI_RGB);
    const GDALColorEntry red{255, 0, 0, 255};
    GDALSetColorEntry(colours, 0, &red);
    GDALSetRasterColorTable(GDALGetRasterBand(made, 1), colours);
    GDALDestroyColorTable(colours);
    GDALClose(made);
    return path;
}

double bumps(int x, int y) { return 500.0 * std::sin(0.7 * x) * std::cos(0.5 * y) + 3.0 * y; }

std::string error_of(const std::filesystem::path& path) {
    const auto raster = Raster::open(path);
    REQUIRE(!raster);
    return raster.error().message();
}

bool says(const std::string& message, std::string_view words) { return message.find(words) != std::string::npos; }

Vec3 random_direction(std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(Vec3(normal(random), normal(random), normal(random)));
}

}  // namespace

TEST_CASE("a raster's heights stand at its pixels' centres, and go round the planet without an edge") {
    const TemporaryFolder folder;
    const Written w;
    const auto raster = *Raster::open(write_raster(folder, w, bumps));
    for (int y = 0; y < w.rows; ++y)
        for (int x = 0; x < w.columns; ++x) {
            const double latitude = (w.north - (y + 0.5) * w.step) * deg, longitude = (w.west + (x + 0.5) * w.step) * deg;
            // Rounding of a float's height, and of an angle times the steepest slope, 350 m a pixel.
            CHECK(raster->height_m(latitude, longitude) == doctest::Approx(bumps(x, y)).epsilon(1e-6).scale(100.0));
            CHECK(raster->height_m(latitude, longitude + 2.0 * pi) == doctest::Approx(bumps(x, y)).epsilon(1e-6).scale(100.0));
            CHECK(raster->presence(latitude, longitude) == 1.0);
        }
    const double before = raster->height_m(0.3, pi - 1e-9), beyond = raster->height_m(0.3, -pi + 1e-9);
    CHECK(before == doctest::Approx(beyond).epsilon(1e-5));
}

TEST_CASE("between pixels a raster is smooth, and no height is outside of what it says of a part") {
    const TemporaryFolder folder;
    const auto raster = *Raster::open(write_raster(folder, {.columns = 128, .rows = 64, .step = 360.0 / 128.0}, bumps));
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> one(-1.0, 1.0);
    for (int n = 0; n < 300; ++n) {
        const Cap cap{random_direction(random), std::exp(-8.0 * std::abs(one(random)))};
        const GeographicRange at = geographic_range(cap);
        const Interval range = raster->range(at.latitudes, at.longitudes);
        for (int k = 0; k < 40; ++k) {
            const double latitude = glm::mix(at.latitudes.low, at.latitudes.high, 0.5 + 0.5 * one(random));
            const double longitude = glm::mix(at.longitudes.low, at.longitudes.high, 0.5 + 0.5 * one(random));
            const double height = raster->height_m(latitude, longitude);
            CHECK((height >= range.low && height <= range.high));
            const auto slope = [&](double x, double step) {
                return (raster->height_m(latitude, x + step) - raster->height_m(latitude, x - step)) / (2.0 * step);
            };
            CHECK(std::abs(slope(longitude - 1e-6, 1e-6) - slope(longitude + 1e-6, 1e-6)) < 2.0);  // metres a radian: no kink
        }
    }
}

TEST_CASE("a cap's latitudes and longitudes hold all of it, at the poles as well") {
    std::mt19937_64 random(6);
    for (int n = 0; n < 2000; ++n) {
        const Vec3 centre = n % 10 ? random_direction(random) : glm::normalize(Vec3(1e-3, 2e-3, n % 20 ? 1.0 : -1.0));
        const Cap cap{centre, std::exp(-6.0 * (random() % 1000) / 1000.0)};
        const Vec3 d = random_direction(random);
        const Vec3 inside = glm::normalize(centre + glm::normalize(glm::cross(centre, d)) * std::tan(std::min(1.5, 0.999 * cap.angle)));
        const GeographicRange at = geographic_range(cap);
        const double latitude = std::asin(inside.z), longitude = std::atan2(inside.y, inside.x);
        const double turn = std::remainder(longitude - 0.5 * (at.longitudes.low + at.longitudes.high), 2.0 * pi);
        CHECK((latitude >= at.latitudes.low - 1e-12 && latitude <= at.latitudes.high + 1e-12));
        CHECK(std::abs(turn) <= 0.5 * (at.longitudes.high - at.longitudes.low) + 1e-12);
    }
}

TEST_CASE("a large raster is read block by block within its bound, from many threads, and gives the same heights") {
    const TemporaryFolder folder;
    const Written w{.columns = 2048, .rows = 1024, .step = 360.0 / 2048.0};
    const std::filesystem::path path = write_raster(folder, w, bumps);
    constexpr std::size_t bound = 4 * 256 * 256 * sizeof(float);
    const auto little = *Raster::open(path, bound), all = *Raster::open(path);
    std::vector<std::jthread> threads;
    std::atomic<int> wrong = 0, over = 0;
    for (unsigned t = 0; t < 3; ++t)
        threads.emplace_back([&, t] {
            std::mt19937_64 random(t);
            std::uniform_real_distribution<double> one(-1.0, 1.0);
            for (int n = 0; n < 3000; ++n) {
                const double latitude = 1.5 * one(random), longitude = 3.1 * one(random);
                wrong += little->height_m(latitude, longitude) != all->height_m(latitude, longitude);
                over += little->bytes() > bound;
            }
        });
    threads.clear();
    CHECK(wrong == 0);
    CHECK(over == 0);
    CHECK(all->bytes() == 8 * 4 * 256 * 256 * sizeof(float));
    CHECK(little->check());
}

TEST_CASE("a pixel without a height is at 0 m") {
    const TemporaryFolder folder;
    const auto raster = *Raster::open(write_raster(folder, {}, [](int x, int y) { return x == 10 && y == 10 ? -9999.0 : 100.0; }));
    const double step = 360.0 / 64.0;
    CHECK(raster->height_m((90.0 - 10.5 * step) * deg, (-180.0 + 10.5 * step) * deg) == doctest::Approx(0.0).scale(1.0));
    CHECK(raster->height_m((90.0 - 13.5 * step) * deg, (-180.0 + 10.5 * step) * deg) == doctest::Approx(100.0));
}

TEST_CASE("bad elevation files are one clear message with the path and what to do") {
    const TemporaryFolder folder;
    CHECK(says(error_of(folder.path / "none.tif"), "there is no such file"));
    REQUIRE(write_file(folder.path / "text.tif", "this is no raster\n"));
    CHECK(says(error_of(folder.path / "text.tif"), "no raster that GDAL can read"));
    CHECK(says(error_of(folder.path / "text.tif"), "text.tif"));

    const std::string nowhere = error_of(write_raster(folder, {.placed = false, .epsg = 0}, bumps, "nowhere.tif"));
    CHECK(says(nowhere, "nowhere.tif: it does not say where on the planet it lies"));
    CHECK(says(nowhere, "gdal_translate"));
    const std::string beyond =
        error_of(write_raster(folder, {.west = 500'000.0, .north = 4'000'000.0, .step = 30.0, .epsg = 0}, bumps, "metres.tif"));
    CHECK(says(beyond, "where on the planet"));
    const std::string projected =
        error_of(write_raster(folder, {.west = 500'000.0, .north = 4'000'000.0, .step = 30.0, .epsg = 32633}, bumps, "utm.tif"));
    CHECK(says(projected, "not in latitude and longitude"));
    CHECK(says(projected, "gdalwarp -t_srs EPSG:4326"));

    const std::filesystem::path whole = write_raster(folder, {.columns = 600, .rows = 300, .step = 0.6}, bumps, "cut.tif");
    std::filesystem::resize_file(whole, std::filesystem::file_size(whole) / 2);
    const std::string cut = error_of(whole);
    CHECK(says(cut, "cut.tif"));
    CHECK((says(cut, "damaged") || says(cut, "no raster")));
}

TEST_CASE("a ground of a raster: its slope is the difference quotient of its height, and its heights keep their bounds") {
    const TemporaryFolder folder;
    const auto raster = *Raster::open(
        write_raster(folder, {.columns = 256, .rows = 128, .step = 360.0 / 256.0}, [](int x, int y) { return 800.0 + 2.0 * bumps(x, y); }));
    const HeightField field = raster_height(raster, {.detail_narrowest_m = 500.0}, level_height(6'371'000.0));
    std::mt19937_64 random(9);
    constexpr double step_m = 1.0, width_m = 2.0;
    for (int n = 0; n < 200; ++n) {
        const Vec3 d = random_direction(random), e = glm::normalize(glm::cross(d, random_direction(random)));
        const HeightSample s = field.sample(d, width_m);
        const auto height = [&](double way) { return field.sample(glm::normalize(d + e * (way / field.radius_m)), width_m).height_m; };
        // Features of 500 m: (2 pi / 500)^2 / 6 of a slope of about 1.
        CHECK(std::abs((height(step_m) - height(-step_m)) / (2.0 * step_m) - glm::dot(s.slope, e)) < 1e-4);
        CHECK(glm::length(field.sample(d, 5000.0).coarse_slope - field.sample(d, 10'000.0).slope) < 1e-12);
        const Node node = node_of(d, n % 21);
        const NodeBounds bounds = bounds_of(node, field);
        // Far below a pixel (156 km) and the narrowest octave, they are as near as slopes allow, but close to the poles.
        if (node.level > 16 && std::abs(d.z) < 0.9)
            CHECK(bounds.radii_m.high - bounds.radii_m.low < 20.0 * side_m(node.level, field.radius_m));
        for (const TileVertex& v : build_tile(node, field).vertices) {
            const double r = glm::length(Vec3(v.position_m[0], v.position_m[1], v.position_m[2]));
            CHECK((r >= bounds.radii_m.low - 1e-8 && r <= bounds.radii_m.high + 1e-8));
        }
    }
}

TEST_CASE("a raster of a part of the planet goes over into the ground outside at its edge, without a step") {
    const TemporaryFolder folder;
    const auto raster = *Raster::open(
        write_raster(folder, {.columns = 100, .rows = 100, .west = 10.0, .north = 50.0, .step = 0.1}, [](int, int) { return 2000.0; }));
    const HeightField field = raster_height(raster, {.detail_share = 0.0}, level_height(6'371'000.0));
    const auto height = [&](double latitude_deg, double longitude_deg) {
        const double a = latitude_deg * deg, o = longitude_deg * deg;
        return field.sample({std::cos(a) * std::cos(o), std::cos(a) * std::sin(o), std::sin(a)}, 100.0).height_m;
    };
    CHECK(height(45.0, 15.0) == doctest::Approx(2000.0));
    CHECK(height(45.0, 9.9) == 0.0);
    CHECK(height(45.0, -170.0) == 0.0);
    CHECK(height(50.2, 15.0) == 0.0);
    double last = height(45.0, 9.5), largest = 0.0;
    for (double x = 9.5; x < 20.5; x += 0.001) {
        largest = std::max(largest, std::abs(height(45.0, x) - last));
        last = height(45.0, x);
    }
    CHECK(largest < 1.5 * 2000.0 * 0.001 / 0.8 *
                        1.01);  // a smooth step over eight pixels of 0.1 degrees is at most 1.5 times as steep as a straight one
}

TEST_CASE("tiles are kept within their bound, built ahead in the background, and the same whichever way they came") {
    const HeightField field = level_height(6e6);
    constexpr std::size_t bound = 10 * tile_bytes;
    TileStore store(field, bound);
    std::vector<Node> nodes;
    for (std::uint32_t x = 0; x < 8; ++x) nodes.push_back({2, 3, x, 1});
    store.prefetch(nodes);
    for (int wait = 0; wait < 500 && store.built() < 8; ++wait) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    CHECK(store.built() == 8);
    const auto tiles = store.get(nodes);
    CHECK(store.built() == 8);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        CHECK(tiles[i]->node == nodes[i]);
        CHECK(tiles[i]->vertices[7].position_m == build_tile(nodes[i], field).vertices[7].position_m);
    }
    for (std::uint32_t x = 0; x < 40; ++x) {
        const Node other{1, 6, x, 3};
        CHECK(store.get({&other, 1}).front()->node == other);
        CHECK(store.bytes() <= bound);
    }
    store.get(nodes);
    CHECK(store.built() == 8 + 40 + 8);
}

TEST_CASE("an image of the planet is read pixel by pixel, a wrong one is told") {
    const TemporaryFolder folder;
    const auto path = write_raster(
        folder, {.columns = 16, .rows = 8, .placed = false, .epsg = 0}, [](int x, int y) { return 10.0 * x + y; }, "surface.tif");
    const Result<GroundColour> colour = surface_image(path);
    if (!colour) FAIL(colour.error().message());
    const SurfaceImage& image = *colour->image;
    CHECK(image.width == 16);
    CHECK(image.height == 8);
    REQUIRE(image.levels.size() == std::size_t{4 * 16 * 8});
    for (std::size_t y = 0; y < 8; ++y)
        for (std::size_t x = 0; x < 16; ++x) {
            for (std::size_t c = 0; c < 3; ++c) CHECK(image.levels[4 * (16 * y + x) + c] == 10 * x + y);
            CHECK(image.levels[4 * (16 * y + x) + 3] == 255);
        }
    const auto fails = [](const std::filesystem::path& file) {
        const Result<GroundColour> made = surface_image(file);
        REQUIRE(!made);
        return made.error().message();
    };
    CHECK(says(fails(folder.path / "none.png"), "none.png: there is no such file"));
    CHECK(says(fails(write_raster(folder, {.columns = 9, .rows = 8}, bumps, "square.tif")),
               "9 x 8 pixels: an image of the whole planet is twice as wide as high"));
    CHECK(says(fails(write_palette(folder, 16, 8)), "its colours are those of a palette"));
}

TEST_CASE("the whole Earth's elevation stands where it should") {
    const std::filesystem::path earth = "/usr/share/ferret-vis/data/etopo5.cdf";
    if (!std::filesystem::exists(earth)) {
        MESSAGE("[skipped] " << earth.string() << " is not installed (Debian: ferret-datasets)");
        return;
    }
    const auto opened = Raster::open(earth);
    if (!opened) FAIL(opened.error().message());
    const Raster& raster = **opened;
    const auto highest = [&](double latitude, double longitude, double about) {
        double most = -1e9;
        for (double y = -about; y <= about; y += 0.02)
            for (double x = -about; x <= about; x += 0.02)
                most = std::max(most, raster.height_m((latitude + y) * deg, (longitude + x) * deg));
        return most;
    };
    CHECK(highest(27.99, 86.93, 0.3) > 6000.0);           // Himalaya: means of 9 km are below the peak's 8849 m
    CHECK(highest(45.83, 6.86, 0.3) > 2500.0);            // Mont Blanc
    CHECK(highest(11.35, 142.2, 0.3) < -5000.0);          // near the Challenger Deep
    CHECK(std::abs(raster.height_m(0.0, 0.0)) > 4000.0);  // the Gulf of Guinea
    CHECK(raster.height_m(-85.0 * deg, 0.0) > 2000.0);    // Antarctica
    const Interval whole = raster.range({-pi / 2, pi / 2}, {-pi, pi});
    CHECK(whole.low < -10'000.0);
    CHECK(whole.high > 7800.0);
}
