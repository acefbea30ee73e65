#include "terrain/raster.h"

#include <cpl_conv.h>
#include <fmt/format.h>
#include <gdal.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <mutex>
#include <optional>
#include <shared_mutex>

namespace airlight {

namespace {

constexpr int block_side = 256;
constexpr int cell_side = 16;  // of the parts whose extremes are known
constexpr std::int64_t most_scanned = std::int64_t{1} << 28;
constexpr Interval highest_and_deepest = {-12'000.0, 9'000.0};  // of the Earth, rounded out: heights of larger files are held within
constexpr double edge_pixels = 8.0;

// The sum of the weights' magnitudes in the middle between pixels, 10/8 along each axis: so far may heights overshoot.
constexpr double overshoot = 1.5625;

struct CloseDataset {
    void operator()(GDALDatasetH dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<std::remove_pointer_t<GDALDatasetH>, CloseDataset>;

// GDAL's own messages, kept from stderr, while it lives.
class Quiet {
public:
    Quiet() { CPLPushErrorHandler(CPLQuietErrorHandler), CPLErrorReset(); }
    ~Quiet() { CPLPopErrorHandler(); }
    std::string message() const { return CPLGetLastErrorMsg(); }
};

// Where the centre of pixel (0, 0) is, and the steps from there; all in radians, rows from north to south.
struct Grid {
    double west, north, column_step, row_step;
    int columns, rows;
    bool round;  // goes round the planet
};

Error not_placed(const std::string& path) {
    return {path, "it does not say where on the planet it lies.",
            "Say so with: gdal_translate -a_srs EPSG:4326 -a_ullr <west> <north> <east> <south> in.tif out.tif (in degrees)."};
}

Result<Grid> grid_of(GDALDatasetH dataset, const std::string& path) {
    double g[6];
    if (GDALGetGeoTransform(dataset, g) != CE_None) return not_placed(path);
    const OGRSpatialReferenceH system = GDALGetSpatialRef(dataset);
    const Error warp{path, "it is not in latitude and longitude with north up.",
                     "Make it so with: gdalwarp -t_srs EPSG:4326 in.tif out.tif."};
    if (system && !OSRIsGeographic(system)) return warp;
    if (g[2] != 0.0 || g[4] != 0.0 || g[1] <= 0.0 || g[5] >= 0.0) return warp;
    Grid grid{g[0], g[3], g[1], -g[5], GDALGetRasterXSize(dataset), GDALGetRasterYSize(dataset), false};
    const double width = grid.column_step * grid.columns, height = grid.row_step * grid.rows;
    // Pixels of a grid from pole to pole may reach beyond them by a half.
    if (grid.north > 90.0 + grid.row_step || grid.north - height < -90.0 - grid.row_step || width > 360.0 + grid.column_step)
        return not_placed(path);
    grid.round = width > 360.0 - 0.5 * grid.column_step;
    if (grid.round) grid.column_step = 360.0 / grid.columns;  // steps that a file gives in float do not close
    grid.west = (grid.west + 0.5 * grid.column_step) * deg, grid.north = (grid.north - 0.5 * grid.row_step) * deg;
    grid.column_step *= deg, grid.row_step *= deg;
    return grid;
}

// The column of a longitude. Outside of a raster that does not go round: beyond the nearer edge, below 0 or above columns - 1.
double column_of(const Grid& g, double longitude) {
    const double round = 2.0 * pi / g.column_step, east = (longitude - g.west) / g.column_step;
    const double column = east - std::floor(east / round) * round;
    if (g.round || column <= g.columns - 1.0) return std::min(column, g.round ? std::nextafter(double(g.columns), 0.0) : column);
    return column - (g.columns - 1.0) < round - column ? column : column - round;
}

std::array<double, 4> weights(double t) {
    return {0.5 * t * (t * (2.0 - t) - 1.0), 0.5 * (t * t * (3.0 * t - 5.0) + 2.0), 0.5 * t * (t * (4.0 - 3.0 * t) + 1.0),
            0.5 * t * t * (t - 1.0)};
}

}  // namespace

struct Raster::Content {
    struct Block {
        std::vector<float> heights_m;  // block_side a row
        std::atomic<std::uint64_t> used = 0;
    };

    std::string path;
    Dataset dataset;
    Grid grid;
    std::optional<double> absent;  // the value that stands for no height
    double scale, offset;
    std::size_t most_blocks;
    int across;                   // blocks
    std::vector<Interval> cells;  // empty if not scanned
    int cells_across = 0;

    mutable std::shared_mutex mutex;  // guards what follows
    mutable std::vector<std::shared_ptr<Block>> blocks;
    mutable std::vector<std::size_t> present;
    mutable std::atomic<std::uint64_t> clock = 0;
    mutable std::mutex reading;  // GDAL reads a dataset from one thread at a time
    mutable std::optional<Error> failure;

    float cleaned(float value) const {
        if (!std::isfinite(value) || (absent && static_cast<double>(value) == *absent)) return 0.0f;
        const double height = value * scale + offset;
        return static_cast<float>(cells.empty() && !scanning ? std::clamp(height, highest_and_deepest.low, highest_and_deepest.high)
                                                             : height);
    }
    bool scanning = false;

    // `rows` rows from `row` on, of `columns` pixels from `column` on.
    Result<std::vector<float>> read(int column, int row, int columns, int rows, int stride) const {
        std::vector<float> values(static_cast<std::size_t>(stride) * static_cast<std::size_t>(rows), 0.0f);
        const std::lock_guard lock(reading);
        const Quiet quiet;
        const GDALRasterBandH band = GDALGetRasterBand(dataset.get(), 1);
        const CPLErr error = GDALRasterIO(band, GF_Read, column, row, columns, rows, values.data(), columns, rows, GDT_Float32, 0,
                                          static_cast<int>(sizeof(float)) * stride);
        if (error != CE_None) return Error{path, "it is damaged: " + quiet.message() + '.', "Fetch or make the file again."};
        for (float& v : values) v = cleaned(v);
        return values;
    }

    Result<Done> scan();
    std::vector<bool> cell_columns(Interval longitudes) const;
    std::shared_ptr<Block> block(int bx, int by) const;
    std::shared_ptr<Block> load(std::size_t index, int bx, int by) const;
};

// Between which heights each cell lies, in one pass over the file.
Result<Done> Raster::Content::scan() {
    if (std::int64_t{grid.columns} * grid.rows > most_scanned) return Done{};
    scanning = true;
    cells_across = (grid.columns + cell_side - 1) / cell_side;
    for (int row = 0; row < grid.rows; row += cell_side) {
        const int rows = std::min(cell_side, grid.rows - row);
        const Result<std::vector<float>> strip = read(0, row, grid.columns, rows, grid.columns);
        if (!strip) return strip.error();
        const std::size_t first = cells.size();
        cells.resize(first + static_cast<std::size_t>(cells_across), {1e300, -1e300});
        for (std::size_t i = 0; i < strip->size(); ++i) {
            Interval& cell = cells[first + i % static_cast<std::size_t>(grid.columns) / cell_side];
            cell.low = std::min<double>(cell.low, (*strip)[i]), cell.high = std::max<double>(cell.high, (*strip)[i]);
        }
    }
    scanning = false;
    return Done{};
}

// Which columns of cells lie between two longitudes, with what interpolation reads beside them.
std::vector<bool> Raster::Content::cell_columns(Interval longitudes) const {
    const double beside = 2.0 * grid.column_step, step = 0.5 * cell_side * grid.column_step;
    const bool all = longitudes.high - longitudes.low >= 2.0 * pi - 2.0 * beside - 2.0 * step;
    std::vector<bool> wanted(static_cast<std::size_t>(cells_across), all);
    for (double at = longitudes.low - beside; !all; at += step) {
        const double column = std::clamp(column_of(grid, std::min(at, longitudes.high + beside)), 0.0, grid.columns - 1.0);
        wanted[static_cast<std::size_t>(column) / cell_side] = true;
        if (at >= longitudes.high + beside) break;
    }
    return wanted;
}

std::shared_ptr<Raster::Content::Block> Raster::Content::block(int bx, int by) const {
    const auto index = static_cast<std::size_t>(by) * static_cast<std::size_t>(across) + static_cast<std::size_t>(bx);
    {
        const std::shared_lock lock(mutex);
        if (const std::shared_ptr<Block>& found = blocks[index]) {
            found->used = ++clock;
            return found;
        }
    }
    return load(index, bx, by);
}

std::shared_ptr<Raster::Content::Block> Raster::Content::load(std::size_t index, int bx, int by) const {
    const int column = bx * block_side, row = by * block_side;
    auto made = std::make_shared<Block>();
    Result<std::vector<float>> heights =
        read(column, row, std::min(block_side, grid.columns - column), std::min(block_side, grid.rows - row), block_side);
    const std::unique_lock lock(mutex);
    if (!heights && !failure) failure = heights.error();
    made->heights_m = heights ? std::move(*heights) : std::vector<float>(std::size_t{block_side} * block_side, 0.0f);
    made->used = ++clock;
    if (blocks[index]) return blocks[index];  // another thread was first
    if (present.size() >= most_blocks) {
        const auto oldest = std::min_element(present.begin(), present.end(),
                                             [&](std::size_t a, std::size_t b) { return blocks[a]->used < blocks[b]->used; });
        blocks[*oldest].reset();
        present.erase(oldest);
    }
    present.push_back(index);
    return blocks[index] = std::move(made);
}

Raster::Raster(std::unique_ptr<Content> content) : content_(std::move(content)) {}
Raster::~Raster() = default;

Result<std::shared_ptr<const Raster>> Raster::open(const std::filesystem::path& path, std::size_t most_bytes) {
    static std::once_flag registered;
    std::call_once(registered, GDALAllRegister);
    const std::string name = path.string();
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored))
        return Error{name, "there is no such file.", "Name an elevation raster, such as a GeoTIFF."};
    const Quiet quiet;
    auto content = std::make_unique<Content>();
    content->path = name;
    content->dataset.reset(GDALOpenEx(name.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr));
    if (!content->dataset || GDALGetRasterCount(content->dataset.get()) == 0)
        return Error{name, "it is no raster that GDAL can read" + (quiet.message().empty() ? std::string() : ": " + quiet.message()) + '.',
                     "gdalinfo tells more about a file."};
    const GDALRasterBandH band = GDALGetRasterBand(content->dataset.get(), 1);
    if (GDALDataTypeIsComplex(GDALGetRasterDataType(band))) return Error{name, "its heights are complex numbers; they must be real.", ""};
    const Result<Grid> grid = grid_of(content->dataset.get(), name);
    if (!grid) return grid.error();
    content->grid = *grid;
    int has = 0;
    const double absent = GDALGetRasterNoDataValue(band, &has);
    if (has) content->absent = static_cast<double>(static_cast<float>(absent));
    content->scale = GDALGetRasterScale(band, nullptr), content->offset = GDALGetRasterOffset(band, nullptr);
    content->most_blocks = std::max<std::size_t>(1, most_bytes / (sizeof(float) * block_side * block_side));
    content->across = (grid->columns + block_side - 1) / block_side;
    content->blocks.resize(static_cast<std::size_t>(content->across) *
                           static_cast<std::size_t>((grid->rows + block_side - 1) / block_side));
    if (const Result<Done> scanned = content->scan(); !scanned) return scanned.error();
    return std::shared_ptr<const Raster>(new Raster(std::move(content)));
}

double Raster::height_m(double latitude, double longitude) const {
    const Grid& g = content_->grid;
    const double row = std::clamp((g.north - latitude) / g.row_step, 0.0, g.rows - 1.0);
    double column = column_of(g, longitude);
    if (!g.round) column = std::clamp(column, 0.0, g.columns - 1.0);
    const int row0 = static_cast<int>(row), column0 = static_cast<int>(column);
    const std::array<double, 4> wy = weights(row - row0), wx = weights(column - column0);
    std::shared_ptr<Content::Block> block;
    int block_x = -1, block_y = -1;
    double sum = 0.0;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
            const int y = std::clamp(row0 + j - 1, 0, g.rows - 1);
            const int x = g.round ? (column0 + i - 1 + g.columns) % g.columns : std::clamp(column0 + i - 1, 0, g.columns - 1);
            if (x / block_side != block_x || y / block_side != block_y) {
                block_x = x / block_side, block_y = y / block_side;
                block = content_->block(block_x, block_y);
            }
            sum += wy[static_cast<std::size_t>(j)] * wx[static_cast<std::size_t>(i)] *
                   block->heights_m[static_cast<std::size_t>(y % block_side * block_side + x % block_side)];
        }
    return sum;
}

double Raster::presence(double latitude, double longitude) const {
    const Grid& g = content_->grid;
    const double row = (g.north - latitude) / g.row_step, column = column_of(g, longitude);
    double inside = 1e300;
    if (!g.round) inside = std::min(column, g.columns - 1.0 - column);
    if (g.north < 90.0 * deg - g.row_step) inside = std::min(inside, row);
    if (g.north - (g.rows - 1) * g.row_step > -90.0 * deg + g.row_step) inside = std::min(inside, g.rows - 1.0 - row);
    const double t = std::clamp(inside / edge_pixels, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

Interval Raster::range(Interval latitudes, Interval longitudes) const {
    const Content& c = *content_;
    const Grid& g = c.grid;
    Interval extremes{1e300, -1e300};
    if (c.cells.empty()) extremes = highest_and_deepest;
    else {
        const auto cell_row = [&](double latitude, int beyond) {
            return std::clamp(static_cast<int>(std::clamp((g.north - latitude) / g.row_step, -2.0, g.rows + 2.0)) + beyond, 0, g.rows - 1) /
                   cell_side;
        };
        const std::vector<bool> wanted = c.cell_columns(longitudes);
        for (int y = cell_row(latitudes.high, -2); y <= cell_row(latitudes.low, 2); ++y)
            for (int x = 0; x < c.cells_across; ++x) {
                if (!wanted[static_cast<std::size_t>(x)]) continue;
                const Interval& cell =
                    c.cells[static_cast<std::size_t>(y) * static_cast<std::size_t>(c.cells_across) + static_cast<std::size_t>(x)];
                extremes = {std::min(extremes.low, cell.low), std::max(extremes.high, cell.high)};
            }
    }
    const double middle = 0.5 * (extremes.low + extremes.high), half = overshoot * 0.5 * (extremes.high - extremes.low);
    return {middle - half, middle + half};
}

double Raster::pixel() const { return content_->grid.row_step; }

double Raster::narrowest_pixel(double latitude) const {
    const Grid& g = content_->grid;
    return std::min(g.row_step, g.column_step * std::max(std::cos(latitude), 0.0));
}

std::size_t Raster::bytes() const {
    const std::shared_lock lock(content_->mutex);
    return content_->present.size() * sizeof(float) * block_side * block_side;
}

Result<Done> Raster::check() const {
    const std::shared_lock lock(content_->mutex);
    if (content_->failure) return *content_->failure;
    return Done{};
}

}  // namespace airlight
