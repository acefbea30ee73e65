#include "models/dobashi1997_data.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "models/axis.h"
#include "models/coefficient_table.h"
#include "physics/models/f64.h"
#include "units/text.h"

namespace airlight {

namespace {

constexpr std::string_view basis_names[] = {"cosines", "samples", "harmonics"};  // in the order of SkyBasis
constexpr std::string_view columns[] = {"wavelength_nm", "sun_zenith_deg", "band", "factors"};
constexpr std::string_view stated[] = {"basis", stated_altitude};

double between(double first, double second, double weight) { return f64::dobashi1997_between(first, second, weight).value; }

double cosines_at(const std::vector<double>& factors, double azimuth) {
    f64::CosineSum sum = f64::cosine_sum(azimuth);
    for (std::size_t i = factors.size(); i-- > 1;) sum = f64::cosine_term(sum, factors[i]);
    return f64::cosine_series(sum, factors.empty() ? 0.0 : factors[0]).value;
}

double samples_at(const std::vector<double>& values, double azimuth) {
    const double step = std::clamp(azimuth / pi, 0.0, 1.0) * static_cast<double>(values.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(step), values.size() - 2);
    return between(values[low], values[low + 1], step - static_cast<double>(low));
}

Result<std::vector<double>> factors_of(const CoefficientTable& table, std::size_t row) {
    std::vector<double> factors;
    const std::string& cell = table.word(row, 3);
    if (cell.empty()) return factors;
    for (std::size_t first = 0; first <= cell.size();) {
        const std::size_t end = std::min(cell.find(' ', first), cell.size());
        const Result<double> factor = parse_number(std::string_view(cell).substr(first, end - first));
        if (!factor) return table.error(row, fmt::format("factors: \"{}\" is not a finite number", cell.substr(first, end - first)));
        factors.push_back(*factor);
        first = end + 1;
    }
    return factors;
}

// Bands of harmonics are the orders 0, 1, 2...; samples are of as many azimuths in every band, two at least.
Result<Done> check_band(const CoefficientTable& table, std::size_t row, const Dobashi1997Data& data, std::size_t factors) {
    const std::size_t band = row % data.bands.size(), most = (data.bands.size() - 1 - band) / 2 + 1;
    if (data.basis == SkyBasis::harmonics && factors > most)
        return table.error(row, fmt::format("has {} factors: order {} of degree {} has {}", factors, band, data.bands.size() - 1, most));
    if (data.basis == SkyBasis::harmonics && data.bands[band] != static_cast<double>(band))
        return table.error(row, fmt::format("band = {:g} is out of order: it must be {}", data.bands[band], band));
    if (data.basis != SkyBasis::samples) return Done{};
    const std::size_t first = row == 0 ? factors : (band == 0 ? data.skies.front() : data.skies.back()).front().size();
    if (factors != first || factors < 2)
        return table.error(row, fmt::format("has {} samples: it must have {}", factors, std::max<std::size_t>(2, first)));
    return Done{};
}

Result<Done> read_row(const CoefficientTable& table, std::size_t row, Dobashi1997Data& data) {
    const std::size_t bands = data.bands.size(), suns = data.sun_zeniths_deg.size();
    const double expected[] = {data.wavelengths_nm[row / bands / suns], data.sun_zeniths_deg[row / bands % suns], data.bands[row % bands]};
    for (std::size_t column = 0; column < 3; ++column)
        if (const Result<Done> ok = table.expect(row, column, expected[column]); !ok) return ok.error();
    Result<std::vector<double>> factors = factors_of(table, row);
    if (!factors) return factors.error();
    if (const Result<Done> ok = check_band(table, row, data, factors->size()); !ok) return ok.error();
    if (row % bands == 0) data.skies.emplace_back();
    data.skies.back().push_back(std::move(*factors));
    return Done{};
}

}  // namespace

std::string_view name_of(SkyBasis basis) { return basis_names[static_cast<std::size_t>(basis)]; }

Result<SkyBasis> sky_basis_named(std::string_view name) {
    const auto found = std::find(std::begin(basis_names), std::end(basis_names), name);
    if (found != std::end(basis_names)) return static_cast<SkyBasis>(found - std::begin(basis_names));
    return Error{"", fmt::format("\"{}\" is no basis: they are {}", name, fmt::join(basis_names, ", ")), ""};
}

std::vector<double> legendre_functions(int order, int degree, double mu) {
    std::vector<double> functions;
    if (degree < order) return functions;
    f64::Legendre p = f64::legendre_first(order, mu);
    functions.push_back(p.here.value);
    for (int l = order + 1; l <= degree; ++l) {
        p = f64::legendre_next(p, l, order, mu);
        if ((l - order) % 2 == 0) functions.push_back(p.here.value);
    }
    return functions;
}

SeriesPlace::SeriesPlace(SkyBasis basis, std::span<const double> bands, const Direction& direction)
    : basis_(basis), azimuth_(std::abs(std::remainder(direction.relative_azimuth, 2.0 * pi))) {
    if (basis == SkyBasis::harmonics) {
        const int most = static_cast<int>(bands.size()) - 1;
        for (int order = 0; order <= most; ++order) functions_.push_back(legendre_functions(order, most, std::cos(direction.view_zenith)));
        return;
    }
    const AxisPlace band = place_on(bands, direction.view_zenith / deg);
    low_ = band.low, high_ = band.high, weight_ = band.weight;
}

double SeriesPlace::at(const std::vector<double>& band) const {
    return basis_ == SkyBasis::cosines ? cosines_at(band, azimuth_) : samples_at(band, azimuth_);
}

double SeriesPlace::radiance(const BandSeries& series) const {
    if (basis_ != SkyBasis::harmonics) return weight_ == 0.0 ? at(series[low_]) : between(at(series[low_]), at(series[high_]), weight_);
    std::vector<double> orders(series.size());
    for (std::size_t order = 0; order < orders.size(); ++order)
        orders[order] = std::inner_product(series[order].begin(), series[order].end(), functions_[order].begin(), 0.0);
    return cosines_at(orders, azimuth_);
}

double Dobashi1997Data::radiance(std::size_t wavelength, const View& view) const {
    const AxisPlace sun = place_on(sun_zeniths_deg, view.sun_zenith / deg);
    const SeriesPlace direction(basis, bands, {view.view_zenith, view.relative_azimuth});
    const auto of = [&](std::size_t s) { return direction.radiance(at(wavelength, s)); };
    return sun.weight == 0.0 ? of(sun.low) : between(of(sun.low), of(sun.high), sun.weight);
}

BandSeries Dobashi1997Data::between_suns(std::size_t wavelength, double sun_zenith) const {
    const AxisPlace sun = place_on(sun_zeniths_deg, sun_zenith / deg);
    const BandSeries &low = at(wavelength, sun.low), &high = at(wavelength, sun.high);
    BandSeries mixed(bands.size());
    for (std::size_t b = 0; b < mixed.size(); ++b) {
        const auto factor = [b](const BandSeries& series, std::size_t i) { return i < series[b].size() ? series[b][i] : 0.0; };
        for (std::size_t i = 0; i < std::max(low[b].size(), high[b].size()); ++i)
            mixed[b].push_back(between(factor(low, i), factor(high, i), sun.weight));
    }
    return mixed;
}

Result<Dobashi1997Data> parse_dobashi1997(std::string_view text, std::string_view where) {
    const Result<CoefficientTable> table = CoefficientTable::parse(text, where, columns, stated);
    if (!table) return table.error();
    const Result<SkyBasis> basis = sky_basis_named(table->stated("basis").value_or(""));
    if (!basis) return at(std::string(where), basis.error());
    const Result<double> altitude = altitude_m_of(*table);
    if (!altitude) return altitude.error();
    if (table->size() == 0) return table->error(0, "has no series");
    const auto bands = table->axis(2, 1, 0.0, *basis == SkyBasis::harmonics ? 1000.0 : 90.0);
    if (!bands) return bands.error();
    const auto suns = table->axis(1, bands->size(), 0.0, 90.0);
    if (!suns) return suns.error();
    const auto wavelengths = table->axis(0, bands->size() * suns->size(), 1.0, 1e6);
    if (!wavelengths) return wavelengths.error();
    Dobashi1997Data data{*basis, *altitude, *wavelengths, *suns, *bands, {}};
    const std::size_t needed = wavelengths->size() * suns->size() * bands->size();
    for (std::size_t row = 0; row < std::min(needed, table->size()); ++row)
        if (const Result<Done> ok = read_row(*table, row, data); !ok) return ok.error();
    if (table->size() != needed)
        return table->error(table->size(), fmt::format("has {} rows for {} wavelengths, {} suns and {} bands: it must have {}",
                                                       table->size(), wavelengths->size(), suns->size(), bands->size(), needed));
    return data;
}

std::string dobashi1997_csv(const Dobashi1997Data& data, std::string_view comment) {
    std::string text =
        fmt::format("{}\nbasis = {}\n{}{}\n", comment, name_of(data.basis), altitude_line(data.altitude_m), fmt::join(columns, ","));
    for (std::size_t w = 0; w < data.wavelengths_nm.size(); ++w)
        for (std::size_t s = 0; s < data.sun_zeniths_deg.size(); ++s)
            for (std::size_t b = 0; b < data.bands.size(); ++b)
                text += fmt::format("{},{},{},{:.6g}\n", data.wavelengths_nm[w], data.sun_zeniths_deg[s], data.bands[b],
                                    fmt::join(data.at(w, s)[b], " "));
    return text;
}

}  // namespace airlight
