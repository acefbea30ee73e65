#include "optics/particles.h"

#include <algorithm>
#include <cassert>
#include <span>

namespace airlight {

namespace {

struct SizeRow {
    AerosolComponent component;
    double relative_humidity;
    double mode_radius_um;
    double sigma;
    double radius_min_um;
    double radius_max_um;
};

constexpr SizeRow size_rows[] = {
#include "aerosol_sizes.inc"
};

struct IndexRow {
    AerosolComponent component;
    double relative_humidity;
    double wavelength_nm;
    double n;
    double k;
};

constexpr IndexRow index_rows[] = {
#include "aerosol_refractive_indices.inc"
};

constexpr std::string_view names[aerosol_component_count] = {
    "insoluble",          "water_soluble",        "soot",           "sea_salt_accumulation", "sea_salt_coarse",
    "mineral_nucleation", "mineral_accumulation", "mineral_coarse", "mineral_transported",   "sulfate"};

// The rows that a predicate picks; they stand together.
template <class Row, class Predicate>
std::span<const Row> block(std::span<const Row> rows, Predicate belongs) {
    const auto first = std::find_if(rows.begin(), rows.end(), belongs);
    return {first, std::find_if_not(first, rows.end(), belongs)};
}

// value(row) at x, linear between the rows' own x; that of the nearest row beyond them.
template <class Row, class X, class Value>
double interpolated(std::span<const Row> rows, X x_of, double x, Value value) {
    assert(!rows.empty());
    const auto above = std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return x_of(row) >= x; });
    if (above == rows.begin()) return value(rows.front());
    if (above == rows.end()) return value(rows.back());
    const auto below = above - 1;
    const double t = (x - x_of(*below)) / (x_of(*above) - x_of(*below));
    return value(*below) * (1.0 - t) + value(*above) * t;
}

std::span<const SizeRow> sizes_rows_of(AerosolComponent component) {
    return block(std::span<const SizeRow>(size_rows), [&](const SizeRow& row) { return row.component == component; });
}

}  // namespace

std::string_view name(AerosolComponent component) { return names[static_cast<int>(component)]; }

LognormalSizes sizes_of(AerosolComponent component, double relative_humidity) {
    assert(relative_humidity >= 0.0 && relative_humidity <= greatest_relative_humidity);
    const auto at_humidity = [&](double SizeRow::*column) {
        return interpolated(
            sizes_rows_of(component), [](const SizeRow& row) { return row.relative_humidity; }, relative_humidity,
            [&](const SizeRow& row) { return row.*column; });
    };
    return {.mode_radius = at_humidity(&SizeRow::mode_radius_um) * um,
            .sigma = at_humidity(&SizeRow::sigma),
            .radius_min = at_humidity(&SizeRow::radius_min_um) * um,
            .radius_max = at_humidity(&SizeRow::radius_max_um) * um};
}

RefractiveIndex refractive_index_of(AerosolComponent component, double relative_humidity, Wavelength wavelength) {
    assert(relative_humidity >= 0.0 && relative_humidity <= greatest_relative_humidity);
    assert(first_aerosol_wavelength <= wavelength && wavelength <= last_aerosol_wavelength);
    // The humidities at which sizes are tabulated are those of the indices.
    const auto at_wavelength = [&](double humidity, double IndexRow::*column) {
        const auto rows = block(std::span<const IndexRow>(index_rows),
                                [&](const IndexRow& row) { return row.component == component && row.relative_humidity == humidity; });
        return interpolated(
            rows, [](const IndexRow& row) { return row.wavelength_nm; }, wavelength.in(nm),
            [&](const IndexRow& row) { return row.*column; });
    };
    const auto at_humidity = [&](double IndexRow::*column) {
        return interpolated(
            sizes_rows_of(component), [](const SizeRow& row) { return row.relative_humidity; }, relative_humidity,
            [&](const SizeRow& row) { return at_wavelength(row.relative_humidity, column); });
    };
    return {at_humidity(&IndexRow::n), at_humidity(&IndexRow::k)};
}

}  // namespace airlight
