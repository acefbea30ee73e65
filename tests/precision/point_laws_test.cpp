// Float against double: how much of the truth the GPU's arithmetic keeps, over the whole domain.

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tools/point_laws.h"

namespace airlight::f64 {
#include "precision/textbook.inc"
}
namespace airlight::f32 {
#include "precision/textbook.inc"
}

using namespace airlight::test;

namespace {

Loss print(const PointLaw& law) {
    const Loss loss = measure(law);
    fmt::print("{:<28} {:>7} points: relative {:8.2e}, absolute {:8.2e}, roundings {:8.3g} of {:2.0f}\n", law.name, law.rows.size(),
               loss.relative, loss.absolute, loss.roundings, law.roundings);
    return loss;
}

// Prints the largest errors of each law and holds them against its derived bound.
void check_each(const std::vector<PointLaw>& laws) {
    for (const PointLaw& law : laws) {
        const Loss loss = print(law);
        CAPTURE(law.name);
        CAPTURE(fmt::format("{}", fmt::join(loss.worst, ", ")));
        CHECK(loss.roundings <= law.roundings);
        CHECK(law.rows.size() > 10);
    }
}

}  // namespace

TEST_CASE("float keeps rays in shells within the roundings of their formulas") { check_each(shell_laws()); }
TEST_CASE("float keeps densities within the roundings of their formulas") { check_each(density_laws()); }
TEST_CASE("float keeps phase functions within the roundings of their formulas") { check_each(phase_laws()); }
TEST_CASE("float keeps the maps of tables within the roundings of their formulas") { check_each(map_laws()); }
TEST_CASE("float keeps the models of the sky within the roundings of their formulas") { check_each(model_laws()); }

// The measure can fail. On the same points, the forms that cancel lose ten times more than any bound above.
TEST_CASE("the forms of textbooks lose what the forms with altitudes keep") {
    const std::vector<PointLaw> ours = shell_laws();
    for (const PointLaw& law :
         {POINT_LAW(textbook_distance_to_top, ours[0].rows, 10, 0), POINT_LAW(textbook_meets_ground, ours[1].rows, 8, 0),
          POINT_LAW(textbook_distance_to_ground, ours[3].rows, 9, 0), POINT_LAW(textbook_altitude_at, ours[4].rows, 13, 0)}) {
        const Loss loss = print(law);
        CAPTURE(law.name);
        CHECK(loss.roundings > 10.0 * law.roundings);
    }
}

TEST_CASE("the short form of Henyey and Greenstein's phase function loses its peak in float") {
    const PointLaw ours = phase_laws()[3];
    const Loss kept = print(ours);
    const Loss lost = print(POINT_LAW(textbook_henyey_greenstein, ours.rows, 15, 0));
    CHECK(kept.relative < 15 * 0x1p-24);
    CHECK(lost.relative > 1000.0 * kept.relative);
}
