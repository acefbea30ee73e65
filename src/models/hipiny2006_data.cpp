#include "models/hipiny2006_data.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "models/axis.h"
#include "models/coefficient_table.h"

namespace airlight {

namespace {

constexpr std::string_view columns[] = {"altitude_m", "turbidity", "sun_zenith_deg", "quantity", "a", "b", "c", "d", "e", "zenith"};
constexpr std::string_view quantities[] = {"Y", "x", "y"};

Hipiny2006Fit& fit_of(Hipiny2006Patch& patch, std::size_t quantity) {
    return quantity == 0 ? patch.luminance : (quantity == 1 ? patch.x : patch.y);
}
const Hipiny2006Fit& fit_of(const Hipiny2006Patch& patch, std::size_t quantity) {
    return quantity == 0 ? patch.luminance : (quantity == 1 ? patch.x : patch.y);
}

struct Entry {
    std::array<double, 3> at;  // altitude, turbidity, sun
    std::size_t quantity;
    Hipiny2006Fit fit;
};

struct Range {
    double low, high;
};
constexpr Range ranges[] = {{0.0, 1e9}, {1.0, 1000.0}, {0.0, 90.0}};

Result<Entry> entry(const CoefficientTable& table, std::size_t row) {
    std::array<double, 9> n{};
    for (std::size_t i = 0, column = 0; column < 10; ++column) {
        if (column == 3) continue;
        const Result<double> value = table.number(row, column);
        if (!value) return value.error();
        if (column < 3 && !(*value >= ranges[column].low && *value <= ranges[column].high))
            return table.error(row, fmt::format("{} = {:g} is out of range: it must be {:g} to {:g}", columns[column], *value,
                                                ranges[column].low, ranges[column].high));
        n[i++] = *value;
    }
    if (!(n[4] <= 0.0)) return table.error(row, fmt::format("b = {:g} is out of range: it must be 0 or less", n[4]));
    const auto name = std::find(std::begin(quantities), std::end(quantities), table.word(row, 3));
    if (name == std::end(quantities))
        return table.error(row, fmt::format("\"{}\" is no quantity: they are Y, x and y", table.word(row, 3)));
    return Entry{{n[0], n[1], n[2]}, static_cast<std::size_t>(name - std::begin(quantities)), {n[3], n[4], n[5], n[6], n[7], n[8]}};
}

std::vector<double> axis(const std::vector<Entry>& entries, std::size_t which) {
    std::vector<double> all;
    for (const Entry& e : entries) all.push_back(e.at[which]);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

std::size_t place(const std::vector<double>& on, double x) {
    return static_cast<std::size_t>(std::lower_bound(on.begin(), on.end(), x) - on.begin());
}

Result<std::vector<Entry>> entries(const CoefficientTable& table) {
    std::vector<Entry> all;
    std::map<std::tuple<std::array<double, 3>, std::size_t>, bool> seen;
    for (std::size_t row = 0; row < table.size(); ++row) {
        const Result<Entry> e = entry(table, row);
        if (!e) return e.error();
        if (!seen.emplace(std::tuple(e->at, e->quantity), true).second)
            return table.error(row, fmt::format("{:g} m, turbidity {:g}, sun {:g} deg, {} is there twice", e->at[0], e->at[1], e->at[2],
                                                quantities[e->quantity]));
        all.push_back(*e);
    }
    return all;
}

}  // namespace

Result<Hipiny2006Data> parse_hipiny2006(std::string_view text, std::string_view where) {
    const Result<CoefficientTable> table = CoefficientTable::parse(text, where, columns);
    if (!table) return table.error();
    if (table->size() == 0) return table->error(0, "has no coefficients");
    const Result<std::vector<Entry>> all = entries(*table);
    if (!all) return all.error();
    Hipiny2006Data data{axis(*all, 0), axis(*all, 1), axis(*all, 2), {}};
    // Each row is a combination of its own: as many rows as combinations is all of them.
    const std::size_t combinations = data.altitudes_m.size() * data.turbidities.size() * data.sun_zeniths_deg.size();
    if (all->size() != combinations * 3)
        return table->error(table->size(),
                            fmt::format("has {} rows for {} altitudes, {} turbidities and {} suns: {} are needed", all->size(),
                                        data.altitudes_m.size(), data.turbidities.size(), data.sun_zeniths_deg.size(), combinations * 3),
                            "Every combination is needed, for Y, x and y.");
    data.patches.resize(combinations);
    for (const Entry& e : *all)
        fit_of(data.patches[data.index(place(data.altitudes_m, e.at[0]), place(data.turbidities, e.at[1]),
                                       place(data.sun_zeniths_deg, e.at[2]))],
               e.quantity) = e.fit;
    return data;
}

std::string hipiny2006_csv(const Hipiny2006Data& data, std::string_view comment) {
    std::string text = fmt::format("{}\n{}\n", comment, fmt::join(columns, ","));
    for (std::size_t h = 0; h < data.altitudes_m.size(); ++h)
        for (std::size_t t = 0; t < data.turbidities.size(); ++t)
            for (std::size_t s = 0; s < data.sun_zeniths_deg.size(); ++s)
                for (std::size_t q = 0; q < 3; ++q) {
                    const Hipiny2006Fit& f = fit_of(data.patches[data.index(h, t, s)], q);
                    text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", data.altitudes_m[h], data.turbidities[t],
                                        data.sun_zeniths_deg[s], quantities[q], f.a, f.b, f.c, f.d, f.e, f.zenith);
                }
    return text;
}

f64::ColourYxy hipiny2006_colour(const Hipiny2006Data& data, std::size_t altitude, std::size_t turbidity, double sun_zenith, double mu,
                                 double nu) {
    const AxisPlace suns = place_on(data.sun_zeniths_deg, sun_zenith / deg);
    const f64::Number gamma = f64::angle_of_cosine(nu);
    const auto of = [&](std::size_t sun) {
        return f64::hipiny2006_patch(in_text(data.patches[data.index(altitude, turbidity, sun)], sun_zenith), mu, nu, gamma);
    };
    return suns.low == suns.high ? of(suns.low) : f64::mix_colours(of(suns.low), of(suns.high), suns.weight);
}

f64::Preetham1999 in_text(const Hipiny2006Patch& patch, double sun_zenith) {
    const auto k = [](const Hipiny2006Fit& f) { return f64::PerezCoefficients{f.a, f.b, f.c, f.d, f.e}; };
    const auto scale = [&](const Hipiny2006Fit& f) { return f.zenith / f64::perez(k(f), 1.0, std::cos(sun_zenith), sun_zenith); };
    return {k(patch.luminance), k(patch.x), k(patch.y), {scale(patch.luminance), scale(patch.x), scale(patch.y)}};
}

}  // namespace airlight
