#include "transport/bake_settings.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <optional>
#include <vector>

namespace airlight {

namespace {

constexpr int max_size = 4096;
constexpr std::int64_t max_texels = std::int64_t{1} << 25;
constexpr int max_orders = 100;
constexpr std::string_view form =
    "Write sun x azimuth x view x altitude, as in 64x16x32x32; the transmittance's angle x altitude may follow: 64x16x32x32,256x128.";

// The whole numbers of "64x16x32": none if the text has another form.
std::optional<std::vector<int>> numbers_between_x(std::string_view text) {
    std::vector<int> numbers;
    const char* at = text.data();
    const char* const end = text.data() + text.size();
    for (;;) {
        int number = 0;
        const auto [next, code] = std::from_chars(at, end, number);
        if (code != std::errc{}) return {};
        numbers.push_back(number);
        if (next == end) return numbers;
        if (*next != 'x') return {};
        at = next + 1;
    }
}

}  // namespace

Result<BakeSettings> validated(BakeSettings settings) {
    const TableSizes& s = settings.sizes;
    for (const int size : {s.transmittance_mu, s.transmittance_altitude, s.sun, s.azimuth, s.view, s.altitude})
        if (size < 2 || size > max_size)
            return Error{"table sizes", fmt::format("{} texels are out of range: it must be 2 to {} in each direction", size, max_size),
                         ""};
    // At most 2^48 each time, so that the product cannot wrap.
    const std::int64_t texels = std::int64_t{s.sun} * s.azimuth * s.view * s.altitude;
    if (texels > max_texels)
        return Error{"table sizes", fmt::format("{} texels in all are too many: it must be {} at most", texels, max_texels), ""};
    if (settings.orders < 1 || settings.orders > max_orders)
        return Error{"orders", fmt::format("{} is out of range: it must be 1 to {}", settings.orders, max_orders), ""};
    return settings;
}

Result<TableSizes> parse_table_sizes(std::string_view text) {
    const std::size_t comma = text.find(',');
    const auto source = numbers_between_x(text.substr(0, comma));
    const auto transmittance = comma == text.npos ? std::vector<int>{TableSizes{}.transmittance_mu, TableSizes{}.transmittance_altitude}
                                                  : numbers_between_x(text.substr(comma + 1));
    if (!source || source->size() != 4 || !transmittance || transmittance->size() != 2)
        return Error{"", fmt::format("\"{}\" are not table sizes", text), std::string(form)};
    const TableSizes sizes{(*transmittance)[0], (*transmittance)[1], (*source)[0], (*source)[1], (*source)[2], (*source)[3]};
    const Result<BakeSettings> right = validated(BakeSettings{.sizes = sizes});
    if (!right) return right.error();
    return sizes;
}

std::string table_sizes_text(const TableSizes& s) {
    return fmt::format("{}x{}x{}x{},{}x{}", s.sun, s.azimuth, s.view, s.altitude, s.transmittance_mu, s.transmittance_altitude);
}

}  // namespace airlight
