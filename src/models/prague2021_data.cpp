#include "models/prague2021_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <optional>

namespace airlight {

namespace {

static_assert(std::endian::native == std::endian::little);

constexpr int most_of_an_axis = 4096;

// Reads piece by piece; the first fault is kept, and nothing is read after it.
class Reader {
public:
    explicit Reader(const std::filesystem::path& path) : path_(path), file_(path, std::ios::binary) {
        if (!file_) fail("cannot be read");
        std::error_code failed;
        size_ = std::filesystem::file_size(path, failed);
        if (failed) fail("cannot be read");
    }

    bool failed() const { return error_.has_value(); }
    const Error& error() const { return *error_; }

    void fail(std::string what) {
        if (!error_)
            error_ = Error{path_.string(), std::move(what), "The data set of the Prague sky model is wanted, as its authors publish it."};
    }

    template <class T>
    std::vector<T> values(std::size_t count, const char* what) {
        // Never more than the file has, whatever a damaged count says.
        if (!failed() && count > (size_ - position()) / sizeof(T)) fail(fmt::format("ends within {}, which is of {} values", what, count));
        if (failed()) return {};
        std::vector<T> all(count);
        file_.read(reinterpret_cast<char*>(all.data()), static_cast<std::streamsize>(count * sizeof(T)));
        if (!file_) fail(fmt::format("cannot be read at {}", what));
        return all;
    }

    int count(const char* what, int least, int most = most_of_an_axis) {
        const std::vector<std::int32_t> value = values<std::int32_t>(1, what);
        if (!failed() && !(value[0] >= least && value[0] <= most))
            fail(fmt::format("has {} {}: it must have {} to {}", value[0], what, least, most));
        return failed() ? least : value[0];
    }

    double number(const char* what) {
        const std::vector<double> value = values<double>(1, what);
        if (!failed() && !std::isfinite(value[0])) fail(fmt::format("{} is not finite", what));
        return failed() ? 0.0 : value[0];
    }

    std::vector<double> axis(const char* what, int least) {
        return increasing(values<double>(static_cast<std::size_t>(count(what, least)), what), what);
    }

    std::vector<double> increasing(std::vector<double> all, const char* what) {
        for (std::size_t i = 0; i < all.size(); ++i)
            if (!std::isfinite(all[i]) || (i > 0 && !(all[i] > all[i - 1])))
                fail(fmt::format("{} do not increase: {:g} at place {}", what, all[i], i + 1));
        return all;
    }

    void skip(std::size_t bytes, const char* what) {
        if (!failed() && bytes > size_ - position()) fail(fmt::format("ends within {}", what));
        if (!failed()) file_.seekg(static_cast<std::streamoff>(bytes), std::ios::cur);
    }

private:
    std::size_t position() { return static_cast<std::size_t>(file_.tellg()); }

    std::filesystem::path path_;
    std::ifstream file_;
    std::uintmax_t size_ = 0;
    std::optional<Error> error_;
};

// IEEE 754 binary16.
float from_half(std::uint16_t bits) {
    const int exponent = (bits >> 10) & 31, fraction = bits & 1023;
    const float size =
        exponent == 0 ? std::ldexp(static_cast<float>(fraction), -24) : std::ldexp(static_cast<float>(1024 + fraction), exponent - 25);
    return (bits & 0x8000) != 0 ? -size : size;
}

void append_halves(Reader& reader, std::size_t count, double scale, std::vector<float>& to) {
    for (const std::uint16_t half : reader.values<std::uint16_t>(count, "its radiance"))
        to.push_back(static_cast<float>(from_half(half) / scale));
}

void read_configuration(Reader& reader, Prague2021Radiance& r) {
    for (int i = 0; i < r.rank && !reader.failed(); ++i) {
        append_halves(reader, r.sun_breaks.size(), 1.0, r.data);
        const double scale = reader.number("a scale of its radiance");
        if (scale == 0.0) return reader.fail("a scale of its radiance is 0");
        append_halves(reader, r.zenith_breaks.size(), scale, r.data);
    }
    append_halves(reader, r.emphasis_breaks.size(), 1.0, r.data);
}

void read_header(Reader& reader, Prague2021Radiance& r) {
    r.visibilities_km = reader.axis("visibilities", 1);
    r.albedos = reader.axis("ground albedos", 1);
    r.altitudes_m = reader.axis("altitudes", 1);
    r.elevations_deg = reader.axis("sun elevations", 1);
    r.channels = reader.count("channels", 1);
    r.first_nm = reader.number("its first wavelength");
    r.width_nm = reader.number("the width of its channels");
    if (!(r.first_nm > 0.0 && r.width_nm > 0.0)) reader.fail("has no wavelengths above 0");
    r.rank = reader.count("products a channel", 1);
    r.sun_breaks = reader.axis("breaks of the angle from the sun", 2);
    r.zenith_breaks = reader.axis("breaks of the zenith angle", 2);
    r.emphasis_breaks = reader.axis("breaks of the emphasis", 2);
}

// Keeps the visibilities around one, and reads their data.
void read_radiance(Reader& reader, Prague2021Radiance& r, double visibility_km) {
    read_header(reader, r);
    if (reader.failed()) return;
    const std::vector<double> all = r.visibilities_km;
    constexpr double hair = 1e-9;  // of rounding
    if (!(visibility_km >= all.front() * (1.0 - hair) && visibility_km <= all.back() * (1.0 + hair)))
        return reader.fail(fmt::format("does not answer a visibility of {:.3g} km: its data is for {:g} to {:g} km", visibility_km,
                                       all.front(), all.back()));
    const double held = std::clamp(visibility_km, all.front(), all.back());
    const auto above = static_cast<std::size_t>(std::lower_bound(all.begin(), all.end(), held) - all.begin());
    const std::size_t first = all[above] == held ? above : above - 1;
    r.visibilities_km.assign(all.begin() + static_cast<std::ptrdiff_t>(first), all.begin() + static_cast<std::ptrdiff_t>(above) + 1);
    const std::size_t bytes =
        r.configurations() * (2 * r.coefficients() + sizeof(double) * static_cast<std::size_t>(r.rank));  // of a visibility
    reader.skip(first * bytes, "its radiance");
    for (std::size_t i = 0; i < r.visibilities_km.size() * r.configurations() && !reader.failed(); ++i) read_configuration(reader, r);
    reader.skip((all.size() - above - 1) * bytes, "its radiance");
}

void read_transmittance(Reader& reader, Prague2021Transmittance& t, int channels) {
    t.distances = reader.count("distances of its transmittance", 2);
    t.grid_altitudes = reader.count("altitudes of the grid of its transmittance", 2);
    const auto visibilities = static_cast<std::size_t>(reader.count("visibilities of its transmittance", 1));
    const auto altitudes = static_cast<std::size_t>(reader.count("altitudes of its transmittance", 1));
    t.rank = reader.count("products of its transmittance", 1);
    const std::vector<float> h = reader.values<float>(altitudes, "altitudes of its transmittance"),
                             v = reader.values<float>(visibilities, "visibilities of its transmittance");
    t.altitudes_m = reader.increasing({h.begin(), h.end()}, "altitudes of its transmittance");
    t.visibilities_km = reader.increasing({v.begin(), v.end()}, "visibilities of its transmittance");
    const auto rank = static_cast<std::size_t>(t.rank);
    t.u = reader.values<float>(static_cast<std::size_t>(t.distances) * static_cast<std::size_t>(t.grid_altitudes) * rank * altitudes,
                               "its transmittance");
    t.v = reader.values<float>(visibilities * altitudes * static_cast<std::size_t>(channels) * rank, "its transmittance");
}

}  // namespace

Result<Prague2021Data> read_prague2021(const std::filesystem::path& path, double visibility_km) {
    Reader reader(path);
    Prague2021Data data{};
    if (!reader.failed()) read_radiance(reader, data.radiance, visibility_km);
    if (!reader.failed()) read_transmittance(reader, data.transmittance, data.radiance.channels);
    if (reader.failed()) return reader.error();
    return data;
}

}  // namespace airlight
