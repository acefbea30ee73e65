// Present weather (WMO code table 4678) and the figures of the remarks.

#include <algorithm>
#include <array>

#include "core/scanner.h"
#include "weather/metar_groups.h"

namespace airlight {

namespace {

struct Code {
    std::string_view letters;
    std::string_view meaning;
};

constexpr std::array descriptors = {Code{"MI", "shallow"}, Code{"BC", "patches"}, Code{"PR", "partial"},      Code{"DR", "low drifting"},
                                    Code{"BL", "blowing"}, Code{"SH", "shower"},  Code{"TS", "thunderstorm"}, Code{"FZ", "freezing"}};
constexpr std::array phenomena = {Code{"DZ", "drizzle"},      Code{"RA", "rain"},         Code{"SN", "snow"},
                                  Code{"SG", "snow grains"},  Code{"IC", "ice crystals"}, Code{"PL", "ice pellets"},
                                  Code{"GR", "hail"},         Code{"GS", "small hail"},   Code{"UP", "unknown precipitation"},
                                  Code{"BR", "mist"},         Code{"FG", "fog"},          Code{"FU", "smoke"},
                                  Code{"VA", "volcanic ash"}, Code{"DU", "dust"},         Code{"SA", "sand"},
                                  Code{"HZ", "haze"},         Code{"PY", "spray"},        Code{"PO", "dust whirls"},
                                  Code{"SQ", "squalls"},      Code{"FC", "funnel cloud"}, Code{"SS", "sandstorm"},
                                  Code{"DS", "duststorm"}};

template <std::size_t N>
const Code* find(const std::array<Code, N>& codes, std::string_view letters) {
    const auto found = std::find_if(codes.begin(), codes.end(), [&](const Code& code) { return code.letters == letters; });
    return found == codes.end() ? nullptr : &*found;
}

// "SLP132": 1013.2 hPa; "SLP987": 998.7 hPa.
void read_sea_level_pressure(std::string_view group, Metar& metar) {
    Scanner scanner(group);
    if (!scanner.skip("SLP")) return;
    const auto tenths = scanner.digits(3);
    if (tenths && scanner.empty()) metar.sea_level_pressure_hpa = (*tenths < 500 ? 1000.0 : 900.0) + *tenths / 10.0;
}

// "T00561017": 5.6 and -1.7 deg C; a 1 before the three digits is a minus.
void read_exact_temperature(std::string_view group, Metar& metar) {
    Scanner scanner(group);
    if (group.size() != 9 || !scanner.skip("T")) return;
    std::array<double, 2> celsius{};
    for (double& c : celsius) {
        const auto sign = scanner.digits(1);
        const auto tenths = scanner.digits(3);
        if (!sign || *sign > 1 || !tenths) return;
        c = (*sign == 1 ? -1 : 1) * *tenths / 10.0;
    }
    metar.temperature_c = celsius[0];
    metar.dew_point_c = celsius[1];
}

}  // namespace

std::string_view weather_meaning(std::string_view letters) {
    const Code* code = find(descriptors, letters);
    if (code == nullptr) code = find(phenomena, letters);
    return code == nullptr ? std::string_view() : code->meaning;
}

bool PresentWeather::has(std::string_view phenomenon) const {
    return std::find(phenomena.begin(), phenomena.end(), phenomenon) != phenomena.end();
}

std::optional<PresentWeather> read_weather(std::string_view group) {
    Scanner scanner(group);
    PresentWeather weather;
    if (scanner.skip("-")) weather.intensity = Intensity::light;
    else if (scanner.skip("+")) weather.intensity = Intensity::heavy;
    else if (scanner.skip("VC")) weather.intensity = Intensity::vicinity;
    if (const Code* descriptor = find(descriptors, scanner.rest().substr(0, 2)); descriptor && scanner.skip(descriptor->letters))
        weather.descriptor = std::string(descriptor->letters);
    while (!scanner.empty()) {
        const auto letters = scanner.take(2);
        if (!letters || !find(phenomena, *letters) || weather.phenomena.size() == 3) return {};
        weather.phenomena.emplace_back(*letters);
    }
    // A descriptor stands alone only for a storm without rain on the field, or a shower in the vicinity.
    if (weather.phenomena.empty() && weather.descriptor != "TS" && weather.descriptor != "SH") return {};
    return weather;
}

void read_remarks(std::string_view remarks, Metar& metar) {
    while (!remarks.empty()) {
        const std::string_view group = remarks.substr(0, remarks.find(' '));
        read_sea_level_pressure(group, metar);
        read_exact_temperature(group, metar);
        remarks.remove_prefix(std::min(group.size() + 1, remarks.size()));
    }
}

}  // namespace airlight
