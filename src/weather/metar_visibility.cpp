// The prevailing visibility, and the visibility towards one side.

#include <fmt/format.h>

#include "core/scanner.h"
#include "weather/metar_groups.h"

namespace airlight::metar_group {

namespace {

constexpr Length mile = 1609.344 * m;
constexpr ReportedDistance ten_km_or_more{10.0 * km, Bound::at_least};

Error visibility_error(std::string what) {
    return {"", std::move(what), "Write it as 4000, 9999, 2000NE, CAVOK, 3SM, 1 1/2SM, M1/4SM or P6SM."};
}

Result<Done> keep_visibility(ReportedDistance visibility, Metar& metar) {
    if (metar.visibility) return visibility_error("is a second visibility");
    metar.visibility = visibility;
    return Done{};
}

bool looks_like_cavok(std::string_view group) { return group == "CAVOK"; }

Result<Done> read_cavok(std::string_view, Metar& metar) {
    metar.cavok = true;
    return keep_visibility(ten_km_or_more, metar);
}

// 9999 is 10 km or more, 0000 less than 50 m; the rest is what it says.
ReportedDistance metres(int figure) {
    if (figure == 9999) return ten_km_or_more;
    if (figure == 0) return {50.0 * m, Bound::less_than};
    return {figure * m, Bound::exact};
}

bool looks_like_metres(std::string_view group) { return digit_at(group, 0) && group.find('/') == std::string_view::npos; }

Result<Done> read_metres(std::string_view group, Metar& metar) {
    Scanner scanner(group);
    const auto figure = scanner.digits(4);
    if (!figure || scanner.at_digit()) return visibility_error("is not a visibility: in metres it has four digits");
    if (scanner.empty() && metar.visibility) {
        metar.directional_visibility.push_back({metres(*figure), ""});
        return Done{};
    }
    if (scanner.empty() || scanner.rest() == "NDV") return keep_visibility(metres(*figure), metar);
    if (!is_any(scanner.rest(), {"N", "NE", "E", "SE", "S", "SW", "W", "NW"}))
        return visibility_error("is not a visibility: after the metres stands NDV or a direction such as NE");
    metar.directional_visibility.push_back({metres(*figure), std::string(scanner.rest())});
    return Done{};
}

// "3", "1/2" or "1 1/2".
std::optional<double> read_mixed_number(Scanner& scanner) {
    const auto first = scanner.digits(1, 3);
    if (!first) return {};
    double whole = 0.0;
    std::optional<int> numerator = first;
    if (scanner.skip(" ")) {
        whole = *first;
        numerator = scanner.digits(1, 2);
    }
    if (!scanner.skip("/")) return whole == 0.0 && numerator ? std::optional<double>(*numerator) : std::nullopt;
    const auto denominator = scanner.digits(1, 2);
    if (!numerator || !denominator || *numerator >= *denominator) return {};
    return whole + static_cast<double>(*numerator) / *denominator;
}

bool looks_like_miles(std::string_view group) { return group.ends_with("SM"); }

Result<Done> read_miles(std::string_view group, Metar& metar) {
    if (group == "////SM") return Done{};
    Scanner scanner(group);
    const bool less = scanner.skip("M");
    const bool more = !less && scanner.skip("P");
    const auto miles = read_mixed_number(scanner);
    if (!miles || scanner.rest() != "SM" || *miles > 100.0) return visibility_error("is not a visibility in statute miles");
    const Bound bound = less ? Bound::less_than : (more || *miles >= 10.0) ? Bound::at_least : Bound::exact;
    return keep_visibility({*miles * mile, bound}, metar);
}

bool looks_like_kilometres(std::string_view group) { return digit_at(group, 0) && group.ends_with("KM"); }

Result<Done> read_kilometres(std::string_view group, Metar& metar) {
    Scanner scanner(group);
    const auto figure = scanner.digits(1, 2);
    if (!figure || scanner.rest() != "KM") return visibility_error("is not a visibility in kilometres");
    return keep_visibility({*figure * km, *figure >= 10 ? Bound::at_least : Bound::exact}, metar);
}

}  // namespace

constinit const GroupKind cavok{looks_like_cavok, read_cavok};
constinit const GroupKind miles{looks_like_miles, read_miles};
constinit const GroupKind kilometres{looks_like_kilometres, read_kilometres};
constinit const GroupKind metres{looks_like_metres, read_metres};

}  // namespace airlight::metar_group
