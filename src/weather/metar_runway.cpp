// Runway visual range; the state of a runway is kept as text.

#include <fmt/format.h>

#include "core/scanner.h"
#include "weather/metar_groups.h"

namespace airlight::metar_group {

namespace {

constexpr Length foot = 0.3048 * m;

Error runway_error(std::string what) {
    return {"", std::move(what), "Write a runway visual range as R06/1500, R06L/P1500N, R24/0400V1200U or R28/2600FT."};
}

std::optional<ReportedDistance> read_range(Scanner& scanner) {
    const Bound bound = scanner.skip("P") ? Bound::at_least : scanner.skip("M") ? Bound::less_than : Bound::exact;
    const auto figure = scanner.digits(4);
    if (!figure) return {};
    return ReportedDistance{*figure * m, bound};
}

bool is_runway_state(std::string_view text) {
    return starts_with_any(text, {"CLRD", "SNOCLO"}) ||
           (text.size() == 6 && text.find_first_not_of("0123456789/") == std::string_view::npos);
}

bool looks_like_runway(std::string_view group) { return group.starts_with('R') && (digit_at(group, 1) || group.starts_with("R/")); }

bool is_runway(std::string_view name) {
    Scanner scanner(name);
    const auto number = scanner.digits(2);
    return number && *number >= 1 && *number <= 36 && is_any(scanner.rest(), {"", "L", "C", "R", "LL", "RR"});
}

// "1500", "0400V1200", either in feet; "////" leaves it unset.
Result<Done> read_ranges(Scanner& scanner, RunwayVisualRange& range) {
    if (scanner.skip("////")) return Done{};
    range.least = read_range(scanner);
    if (!range.least) return runway_error("is not a runway visual range: after '/' comes a range of four digits");
    if (scanner.skip("V") && !(range.most = read_range(scanner)))
        return runway_error("is not a runway visual range: after V comes a range of four digits");
    if (!scanner.skip("FT")) return Done{};
    range.least->distance = range.least->distance.in(m)*foot;
    if (range.most) range.most->distance = range.most->distance.in(m)*foot;
    return Done{};
}

Result<Done> read_runway(std::string_view group, Metar& metar) {
    const std::size_t slash = std::min(group.find('/'), group.size());
    const std::string_view value = group.substr(std::min(slash + 1, group.size()));
    if (is_runway_state(value)) {
        metar.supplementary.emplace_back(group);
        return Done{};
    }
    RunwayVisualRange range;
    range.runway = group.substr(1, slash - 1);
    if (!is_runway(range.runway)) return runway_error("does not name a runway: 01 to 36, and L, C or R");
    Scanner scanner(value);
    if (const auto read = read_ranges(scanner, range); !read) return read.error();
    scanner.skip("/");
    for (const char tendency : {'U', 'D', 'N'})
        if (scanner.skip(std::string_view(&tendency, 1))) range.tendency = tendency;
    if (!scanner.empty()) return runway_error(fmt::format("is not a runway visual range: \"{}\" is left over", scanner.rest()));
    metar.runway_visual_range.push_back(range);
    return Done{};
}

}  // namespace

constinit const GroupKind runway{looks_like_runway, read_runway};

}  // namespace airlight::metar_group
