#include "models/hosek2012_data.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <tuple>

#include "models/axis.h"
#include "models/coefficient_table.h"

namespace airlight {

namespace {

constexpr std::string_view columns[] = {"wavelength_nm", "ground_albedo", "turbidity", "coefficient", "p0", "p1", "p2", "p3", "p4", "p5"};

constexpr std::string_view stated[] = {stated_altitude};

// A row of the file, and where its points go.
struct Entry {
    double wavelength_nm, albedo, turbidity;
    std::size_t coefficient;
    std::array<double, 6> points;

    auto key() const { return std::tie(wavelength_nm, albedo, turbidity, coefficient); }
};

Result<double> in_range(const CoefficientTable& table, std::size_t row, std::size_t column, double low, double high) {
    const Result<double> value = table.number(row, column);
    if (value && !(*value >= low && *value <= high))
        return table.error(row, fmt::format("{} = {:g} is out of range: it must be {:g} to {:g}", columns[column], *value, low, high));
    return value;
}

Result<Entry> entry(const CoefficientTable& table, std::size_t row) {
    const Result<double> wavelength = in_range(table, row, 0, 1.0, 1e6), albedo = in_range(table, row, 1, 0.0, 1.0),
                         turbidity = in_range(table, row, 2, 1.0, 1000.0);
    for (const Result<double>* value : {&wavelength, &albedo, &turbidity})
        if (!*value) return value->error();
    const auto name = std::find(std::begin(hosek2012_coefficients), std::end(hosek2012_coefficients), table.word(row, 3));
    if (name == std::end(hosek2012_coefficients))
        return table.error(row, fmt::format("\"{}\" is no coefficient: they are A to I and radiance", table.word(row, 3)));
    Entry e{*wavelength, *albedo, *turbidity, static_cast<std::size_t>(name - std::begin(hosek2012_coefficients)), {}};
    for (std::size_t p = 0; p < 6; ++p) {
        const Result<double> point = table.number(row, 4 + p);
        if (!point) return point.error();
        e.points[p] = *point;
    }
    return e;
}

Result<std::vector<Entry>> entries(const CoefficientTable& table) {
    std::vector<Entry> all;
    std::map<std::tuple<double, double, double, std::size_t>, std::size_t> seen;
    for (std::size_t row = 0; row < table.size(); ++row) {
        Result<Entry> e = entry(table, row);
        if (!e) return e.error();
        if (!seen.emplace(e->key(), row).second)
            return table.error(row, fmt::format("{} nm, albedo {}, turbidity {}, {} is there twice", e->wavelength_nm, e->albedo,
                                                e->turbidity, table.word(row, 3)));
        all.push_back(*e);
    }
    return all;
}

std::vector<double> values(const std::vector<Entry>& entries, double Entry::*of) {
    std::vector<double> all;
    for (const Entry& e : entries) all.push_back(e.*of);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

std::size_t place(const std::vector<double>& axis, double x) {
    return static_cast<std::size_t>(std::lower_bound(axis.begin(), axis.end(), x) - axis.begin());
}

// The first combination that no row has.
std::string first_missing(const Hosek2012Data& data, const std::vector<std::array<bool, 10>>& there) {
    const auto hole =
        std::find_if(there.begin(), there.end(), [](const auto& c) { return !std::all_of(c.begin(), c.end(), std::identity{}); });
    const auto i = static_cast<std::size_t>(hole - there.begin());
    const std::size_t t = data.turbidities.size(), a = data.albedos.size();
    const auto coefficient = static_cast<std::size_t>(std::find(hole->begin(), hole->end(), false) - hole->begin());
    return fmt::format("{} nm, albedo {}, turbidity {}, {}", data.wavelengths_nm[i / t / a], data.albedos[i / t % a],
                       data.turbidities[i % t], hosek2012_coefficients[coefficient]);
}

}  // namespace

Hosek2012Points Hosek2012Data::between(std::size_t wavelength, double albedo, double turbidity) const {
    const AxisPlace a = place_on(albedos, albedo), t = place_on(turbidities, turbidity);
    const Hosek2012Points *p00 = &points[index(wavelength, a.low, t.low)], *p01 = &points[index(wavelength, a.low, t.high)],
                          *p10 = &points[index(wavelength, a.high, t.low)], *p11 = &points[index(wavelength, a.high, t.high)];
    Hosek2012Points mixed;
    for (std::size_t c = 0; c < mixed.size(); ++c)
        for (std::size_t p = 0; p < 6; ++p)
            mixed[c][p] = (1.0 - a.weight) * ((1.0 - t.weight) * (*p00)[c][p] + t.weight * (*p01)[c][p]) +
                          a.weight * ((1.0 - t.weight) * (*p10)[c][p] + t.weight * (*p11)[c][p]);
    return mixed;
}

Result<Hosek2012Data> parse_hosek2012(std::string_view text, std::string_view where) {
    const Result<CoefficientTable> table = CoefficientTable::parse(text, where, columns, stated);
    if (!table) return table.error();
    const Result<double> altitude = altitude_m_of(*table);
    if (!altitude) return altitude.error();
    if (table->size() == 0) return table->error(0, "has no coefficients");
    const Result<std::vector<Entry>> all = entries(*table);
    if (!all) return all.error();
    Hosek2012Data data{values(*all, &Entry::wavelength_nm), values(*all, &Entry::albedo), values(*all, &Entry::turbidity), {}, *altitude};
    // Each row is a combination of its own, so that fewer combinations than rows tells of a hole before memory is taken for it.
    const std::size_t combinations = data.wavelengths_nm.size() * data.albedos.size() * data.turbidities.size();
    if (combinations > all->size())
        return table->error(table->size(),
                            fmt::format("has {} rows for {} wavelengths, {} albedos and {} turbidities: {} are needed", all->size(),
                                        data.wavelengths_nm.size(), data.albedos.size(), data.turbidities.size(), combinations * 10));
    data.points.resize(combinations);
    std::vector<std::array<bool, 10>> there(combinations);
    for (const Entry& e : *all) {
        const std::size_t i =
            data.index(place(data.wavelengths_nm, e.wavelength_nm), place(data.albedos, e.albedo), place(data.turbidities, e.turbidity));
        data.points[i][e.coefficient] = e.points;
        there[i][e.coefficient] = true;
    }
    if (all->size() < combinations * 10)
        return table->error(table->size(), fmt::format("has no row of {}", first_missing(data, there)), "Every combination is needed.");
    return data;
}

std::string hosek2012_csv(const Hosek2012Data& data, std::string_view comment) {
    std::string text = fmt::format("{}\n{}{}\n", comment, altitude_line(data.altitude_m), fmt::join(columns, ","));
    for (std::size_t w = 0; w < data.wavelengths_nm.size(); ++w)
        for (std::size_t a = 0; a < data.albedos.size(); ++a)
            for (std::size_t t = 0; t < data.turbidities.size(); ++t)
                for (std::size_t c = 0; c < 10; ++c)
                    text += fmt::format("{},{},{},{},{}\n", data.wavelengths_nm[w], data.albedos[a], data.turbidities[t],
                                        hosek2012_coefficients[c], fmt::join(data.points[data.index(w, a, t)][c], ","));
    return text;
}

}  // namespace airlight
