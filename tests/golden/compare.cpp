// golden_compare <picture.png> <golden.png> <difference.png>: exits 1 and says so if the picture looks other than the golden one; then
// `difference.png` has CIEDE2000 of each pixel, white from 10 on.

#include <fmt/format.h>

#include <algorithm>

#include "eval/picture_difference.h"
#include "image/png.h"

using namespace airlight;

namespace {

// 1 is just seen where two colours meet. Another driver's rounding moves edges of a few pixels, and no area: docs/decisions/0018.
constexpr double most_mean = 0.3, most_high = 2.0;

Image shown(const Image& difference) {
    Image grey = difference;
    for (float& value : grey.values) value = std::min(1.0f, value / 10.0f);
    return grey;
}

Result<bool> looks_the_same(const char* picture, const char* golden, const char* seen) {
    const Result<PngLevels> one = read_png(picture), other = read_png(golden);
    if (!one) return one.error();
    if (!other) return other.error();
    const Result<PictureDifference> difference = picture_difference(*one, *other);
    if (!difference) return difference.error();
    fmt::print("CIEDE2000: mean {:.3f} (at most {}), 99 of 100 pixels within {:.3f} (at most {})\n", difference->mean, most_mean,
               difference->high, most_high);
    if (difference->mean <= most_mean && difference->high <= most_high) return true;
    if (const Result<Done> written = write_png(seen, shown(difference->pixels)); !written) return written.error();
    fmt::print("the picture is not the golden one:\n  {}\n  {}\n  {} (their difference)\n", picture, golden, seen);
    fmt::print("  If it should look so, `make golden` makes it golden.\n");
    return false;
}

}  // namespace

int main(int count, char** words) {
    if (count != 4) {
        fmt::print(stderr, "usage: golden_compare <picture.png> <golden.png> <difference.png>\n");
        return 2;
    }
    const Result<bool> same = looks_the_same(words[1], words[2], words[3]);
    if (!same) fmt::print(stderr, "{}\n", same.error().message());
    return same && *same ? 0 : 1;
}
