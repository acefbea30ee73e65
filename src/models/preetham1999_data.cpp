#include "models/preetham1999_data.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "models/coefficient_table.h"
#include "units/units.h"

namespace airlight {

namespace {

constexpr std::string_view columns[] = {"quantity", "coefficient", "t2", "t1", "t0"};
constexpr std::string_view stated[] = {"lowest_turbidity", "highest_turbidity", stated_altitude};

double at_turbidity(const TurbidityPolynomial& p, double t) { return (p[0] * t + p[1]) * t + p[2]; }

PreethamQuantity quantity_at(const Preetham1999Data& data, std::size_t first, std::size_t count, double turbidity) {
    std::array<double, 9> k{};
    for (std::size_t i = 0; i < count; ++i) k[i] = at_turbidity(data.coefficients[first + i], turbidity);
    return {{k[0], k[1], k[2], k[3], k[4]}, {k[5], k[6], k[7], k[8]}};
}

// Over the range of turbidities: a polynomial of the second degree has its extremes at the ends or where it is level.
Result<Done> check_range(const CoefficientTable& table, std::size_t row, const Preetham1999Data& data, double low, double high) {
    const TurbidityPolynomial& p = data.coefficients[row];
    const double level = p[0] != 0.0 ? -0.5 * p[1] / p[0] : data.lowest_turbidity;
    for (const double t : {data.lowest_turbidity, data.highest_turbidity, level}) {
        if (!(t >= data.lowest_turbidity && t <= data.highest_turbidity)) continue;
        const double value = at_turbidity(p, t);
        if (!(value >= low && value <= high))
            return table.error(row, fmt::format("{} is {:g} at turbidity {:g}, out of range: it must be {:g} to {:g}",
                                                preetham1999_coefficients[row].name, value, t, low, high));
    }
    return Done{};
}

Result<Done> read_row(const CoefficientTable& table, std::size_t row, Preetham1999Data& data) {
    const PreethamCoefficient& expected = preetham1999_coefficients[row];
    if (table.word(row, 0) != expected.quantity || table.word(row, 1) != expected.name)
        return table.error(row, fmt::format("{},{} is out of order: it must be {},{}", table.word(row, 0), table.word(row, 1),
                                            expected.quantity, expected.name));
    for (std::size_t i = 0; i < 3; ++i) {
        const Result<double> value = table.number(row, 2 + i);
        if (!value) return value.error();
        data.coefficients[row][i] = *value;
    }
    if (expected.name == "b") return check_range(table, row, data, -1e9, 0.0);
    if (expected.name == "chi") return check_range(table, row, data, 0.0, 0.4999);
    return Done{};
}

}  // namespace

double preetham_zenith_luminance(const PreethamQuantity& q, double sun_zenith) {
    return 1000.0 * (q.zenith[1] * std::tan(q.zenith[0] * (pi - 2.0 * sun_zenith)) + q.zenith[2]);
}

double preetham_zenith_chromaticity(const PreethamQuantity& q, double sun_zenith) {
    return ((q.zenith[0] * sun_zenith + q.zenith[1]) * sun_zenith + q.zenith[2]) * sun_zenith + q.zenith[3];
}

f64::Preetham1999 in_text(const Preetham1999Data& data, double turbidity, double sun_zenith) {
    const PreethamQuantity luminance = quantity_at(data, 0, 8, turbidity), x = quantity_at(data, 8, 9, turbidity),
                           y = quantity_at(data, 17, 9, turbidity);
    const auto straight_up = [&](const PreethamQuantity& q) { return f64::perez(q.k, 1.0, std::cos(sun_zenith), sun_zenith); };
    return {luminance.k,
            x.k,
            y.k,
            {preetham_zenith_luminance(luminance, sun_zenith) / straight_up(luminance),
             preetham_zenith_chromaticity(x, sun_zenith) / straight_up(x), preetham_zenith_chromaticity(y, sun_zenith) / straight_up(y)}};
}

Result<Preetham1999Data> parse_preetham1999(std::string_view text, std::string_view where) {
    const Result<CoefficientTable> table = CoefficientTable::parse(text, where, columns, stated);
    if (!table) return table.error();
    const Result<double> altitude = altitude_m_of(*table), low = table->stated_number("lowest_turbidity", 0.0, 1.0, 1000.0);
    if (!altitude) return altitude.error();
    if (!low) return low.error();
    const Result<double> high = table->stated_number("highest_turbidity", 0.0, *low, 1000.0);
    if (!high) return high.error();
    if (*low == 0.0 || *high == 0.0)
        return Error{std::string(where), "does not state lowest_turbidity and highest_turbidity, its range", ""};
    if (table->size() != std::size(preetham1999_coefficients))
        return table->error(table->size(),
                            fmt::format("has {} rows: it must have {}", table->size(), std::size(preetham1999_coefficients)));
    Preetham1999Data data{*low, *high, *altitude, {}};
    for (std::size_t row = 0; row < table->size(); ++row)
        if (const Result<Done> ok = read_row(*table, row, data); !ok) return ok.error();
    return data;
}

std::string preetham1999_csv(const Preetham1999Data& data, std::string_view comment) {
    std::string text = fmt::format("{}\nlowest_turbidity = {}\nhighest_turbidity = {}\n{}{}\n", comment, data.lowest_turbidity,
                                   data.highest_turbidity, altitude_line(data.altitude_m), fmt::join(columns, ","));
    for (std::size_t i = 0; i < data.coefficients.size(); ++i)
        text += fmt::format("{},{},{}\n", preetham1999_coefficients[i].quantity, preetham1999_coefficients[i].name,
                            fmt::join(data.coefficients[i], ","));
    return text;
}

}  // namespace airlight
