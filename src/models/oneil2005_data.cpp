#include "models/oneil2005_data.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "models/coefficient_table.h"

namespace airlight {

namespace {

constexpr std::string_view columns[] = {"constituent", "scale_height_m", "c0", "c1", "c2", "c3", "c4"};
constexpr std::string_view stated[] = {"bottom_radius_m"};

Result<ONeilScale> scale_of(const CoefficientTable& table, std::size_t row, std::string_view constituent) {
    if (row >= table.size()) return table.error(row, fmt::format("has no row of {}", constituent));
    if (table.word(row, 0) != constituent)
        return table.error(row, fmt::format("constituent = \"{}\" is out of order: it must be {}", table.word(row, 0), constituent));
    const Result<double> height = table.number(row, 1);
    if (!height) return height.error();
    if (!(*height > 0.0 && *height <= 1e7))
        return table.error(row, fmt::format("scale_height_m = {:g} is out of range: it must be above 0 and at most 1e7", *height));
    ONeilScale scale{*height, {}};
    for (std::size_t i = 0; i < 5; ++i) {
        const Result<double> c = table.number(row, 2 + i);
        if (!c) return c.error();
        scale.coefficients[i] = *c;
    }
    return scale;
}

}  // namespace

Result<ONeil2005Data> parse_oneil2005(std::string_view text, std::string_view where) {
    const Result<CoefficientTable> table = CoefficientTable::parse(text, where, columns, stated);
    if (!table) return table.error();
    const Result<double> radius = table->stated_number("bottom_radius_m", 0.0, 1.0, 1e12);
    if (!radius) return radius.error();
    if (*radius == 0.0) return Error{std::string(where), "does not state bottom_radius_m, the radius of its planet", ""};
    const Result<ONeilScale> air = scale_of(*table, 0, "air"), aerosol = scale_of(*table, 1, "aerosol");
    if (!air) return air.error();
    if (!aerosol) return aerosol.error();
    if (table->size() > 2) return table->error(2, "is one row too many: there is one of air and one of aerosol");
    return ONeil2005Data{*radius, *air, *aerosol};
}

std::string oneil2005_csv(const ONeil2005Data& data, std::string_view comment) {
    return fmt::format("{}\nbottom_radius_m = {}\n{}\nair,{},{}\naerosol,{},{}\n", comment, data.bottom_radius_m, fmt::join(columns, ","),
                       data.air.scale_height_m, fmt::join(data.air.coefficients, ","), data.aerosol.scale_height_m,
                       fmt::join(data.aerosol.coefficients, ","));
}

}  // namespace airlight
