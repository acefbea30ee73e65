// Clouds.

#include <fmt/format.h>

#include <array>

#include "core/scanner.h"
#include "weather/metar_groups.h"

namespace airlight::metar_group {

namespace {

constexpr Length foot = 0.3048 * m;

constexpr const char* cloud_form = "Write it as FEW020, SCT035CB, BKN040TCU, OVC///, VV002, NSC or CLR.";

struct CoverWord {
    std::string_view word;
    Cover cover;
};
constexpr std::array cover_words = {CoverWord{"FEW", Cover::few},         CoverWord{"SCT", Cover::scattered},
                                    CoverWord{"BKN", Cover::broken},      CoverWord{"OVC", Cover::overcast},
                                    CoverWord{"VV", Cover::sky_obscured}, CoverWord{"///", Cover::not_measured}};

bool looks_like_cloud(std::string_view group) {
    return is_any(group, {"SKC", "CLR", "NSC", "NCD"}) || starts_with_any(group, {"FEW", "SCT", "BKN", "OVC", "VV", "///"});
}

Result<Done> read_cloud(std::string_view group, Metar& metar) {
    if (is_any(group, {"SKC", "CLR", "NSC", "NCD"})) {
        metar.no_cloud = group;
        return Done{};
    }
    ReportedCloud cloud;
    Scanner scanner(group);
    for (const CoverWord& c : cover_words)
        if (scanner.skip(c.word)) {
            cloud.cover = c.cover;
            break;
        }
    if (const auto hundreds_of_feet = scanner.digits(3)) cloud.base = *hundreds_of_feet * 100.0 * foot;
    else if (!scanner.skip("///")) return Error{"", "is not a cloud layer: after the cover comes its height in three digits", cloud_form};
    if (!scanner.empty() && !only_slashes(scanner.rest())) {
        if (!is_any(scanner.rest(), {"CB", "TCU"}))
            return Error{"", "is not a cloud layer: after the height only CB or TCU may stand", cloud_form};
        cloud.kind = scanner.rest();
    }
    metar.clouds.push_back(cloud);
    return Done{};
}

}  // namespace

constinit const GroupKind cloud{looks_like_cloud, read_cloud};

}  // namespace airlight::metar_group
