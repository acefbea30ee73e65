#include "models/perez1993_data.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "models/axis.h"
#include "models/coefficient_table.h"

namespace airlight {

namespace {

constexpr std::string_view columns[] = {"wavelength_nm", "sun_zenith_deg", "a", "b", "c", "d", "e", "scale"};
constexpr std::string_view stated[] = {stated_altitude};

Result<PerezForm> form_of(const CoefficientTable& table, std::size_t row) {
    std::array<double, 6> x;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Result<double> value = table.number(row, 2 + i);
        if (!value) return value.error();
        x[i] = *value;
    }
    if (!(x[1] <= 0.0)) return table.error(row, fmt::format("b = {:g} is out of range: it must be 0 or less", x[1]));
    return PerezForm{{x[0], x[1], x[2], x[3], x[4]}, x[5]};
}

}  // namespace

double Perez1993Data::radiance(std::size_t wavelength, const View& view) const {
    const double mu = std::max(0.0, std::cos(view.view_zenith)), nu = std::clamp(view_sun_cosine(view), -1.0, 1.0);
    const auto of = [&](std::size_t sun) { return forms[wavelength * sun_zeniths_deg.size() + sun].value(mu, nu); };
    return std::max(0.0, place_on(sun_zeniths_deg, view.sun_zenith / deg).between(of));
}

Result<Perez1993Data> parse_perez1993(std::string_view text, std::string_view where) {
    const Result<CoefficientTable> table = CoefficientTable::parse(text, where, columns, stated);
    if (!table) return table.error();
    const Result<double> altitude = altitude_m_of(*table);
    if (!altitude) return altitude.error();
    if (table->size() == 0) return table->error(0, "has no coefficients");
    const Result<std::vector<double>> suns = table->axis(1, 1, 0.0, 90.0);
    if (!suns) return suns.error();
    const Result<std::vector<double>> wavelengths = table->axis(0, suns->size(), 1.0, 1e6);
    if (!wavelengths) return wavelengths.error();
    Perez1993Data data{*altitude, *wavelengths, *suns, {}};
    if (table->size() != suns->size() * wavelengths->size())
        return table->error(table->size(), fmt::format("has {} rows for {} wavelengths and {} suns: it must have {}", table->size(),
                                                       wavelengths->size(), suns->size(), suns->size() * wavelengths->size()));
    for (std::size_t row = 0; row < table->size(); ++row) {
        if (const auto ok = table->expect(row, 0, (*wavelengths)[row / suns->size()]); !ok) return ok.error();
        if (const auto ok = table->expect(row, 1, (*suns)[row % suns->size()]); !ok) return ok.error();
        const Result<PerezForm> form = form_of(*table, row);
        if (!form) return form.error();
        data.forms.push_back(*form);
    }
    return data;
}

std::string perez1993_csv(const Perez1993Data& data, std::string_view comment) {
    std::string text = fmt::format("{}\n{}{}\n", comment, altitude_line(data.altitude_m), fmt::join(columns, ","));
    for (std::size_t i = 0; i < data.forms.size(); ++i) {
        const PerezForm& f = data.forms[i];
        const double numbers[] = {f.k.a.value, f.k.b.value, f.k.c.value, f.k.d.value, f.k.e.value, f.scale};
        text += fmt::format("{},{},{:.7g}\n", data.wavelengths_nm[i / data.sun_zeniths_deg.size()],
                            data.sun_zeniths_deg[i % data.sun_zeniths_deg.size()], fmt::join(numbers, ","));
    }
    return text;
}

}  // namespace airlight
