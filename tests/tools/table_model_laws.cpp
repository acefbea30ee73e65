#include <random>

#include "physics/models/f32.h"
#include "physics/models/f64.h"
#include "tools/domain.h"
#include "tools/model_laws.h"

// Look-ups in tables. A texture's coordinate is worth its size in texels, so a rounding of it is counted as one of the argument;
// the blend of texels adds three roundings a dimension. Software fuses x * (b - a) + a, and so differs by roundings of the texels.

namespace airlight::test {

namespace {

// A table of values between 1 and 2 without any order.
LawTable rough_table(int width, int height, int depth) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> value(1.0f, 2.0f);
    LawTable table{width, height, depth, {}};
    for (int i = 0; i < 4 * width * height * std::max(1, depth); ++i) table.texels.push_back(value(random));
    return table;
}

// Inside, on centres and edges of texels, and beyond the table.
std::vector<double> places() {
    std::vector<double> all = {-1.0, -0.1, 0.0, 0.5, 1.0, 1.1, 3.0};
    for (int i = 0; i < 40; ++i) all.push_back((i + 0.37) / 41.0);
    for (const int n : {3, 5, 7, 16})
        for (int i = 0; i < 2 * n; ++i) all.push_back(0.5 * i / n);
    return all;
}

}  // namespace

std::vector<PointLaw> table_model_laws() {
    const std::vector<LawTable> one = {rough_table(1, 1, 0)}, small = {rough_table(5, 3, 0)}, wide = {rough_table(256, 64, 0)},
                                deep = {rough_table(7, 5, 3)};
    return {
        TABLE_LAW("look_up in a texel", one, 2, look_up(t2[0], TexCoord2(x[0], x[1]))[0], combinations({places(), places()}), 1, 0),
        TABLE_LAW("look_up in 5 x 3 texels", small, 2, look_up(t2[0], TexCoord2(x[0], x[1]))[0], combinations({places(), places()}), 2, 2),
        TABLE_LAW("look_up in 256 x 64 texels", wide, 2, look_up(t2[0], TexCoord2(x[0], x[1]))[0], combinations({places(), places()}), 2,
                  2),
        TABLE_LAW("look_up in 7 x 5 x 3 texels", deep, 3, look_up(t3[0], TexCoord3(x[0], x[1], x[2]))[0],
                  combinations({places(), {-0.1, 0.0, 0.11, 0.5, 0.77, 1.0}, {0.0, 0.17, 0.3, 0.9, 1.0}}), 3, 2),
    };
}

}  // namespace airlight::test
