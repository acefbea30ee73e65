#include "render/rgb_block.h"

#include "spectrum/colour.h"

namespace airlight::render {

std::array<float, 4> luminance_of_rgb() {
    const RgbConverter converter(RgbSpace::srgb, WhitePoint::d65);
    const auto share = [&](Rgb primary) { return static_cast<float>(converter.luminance(primary)); };
    return {share({1.0, 0.0, 0.0}), share({0.0, 1.0, 0.0}), share({0.0, 0.0, 1.0}), 0.0f};
}

}  // namespace airlight::render
