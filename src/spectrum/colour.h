// From colour as the eye sees it to the numbers of a display or a file, and back.
// Theory: docs/theory.md, section 6.
// Uses cie.h and the sun's spectrum; knows nothing of images.
#pragma once

#include <optional>
#include <string_view>

#include <glm/mat3x3.hpp>

#include "spectrum/cie.h"

namespace airlight {

// Linear amounts of three primaries. (1, 1, 1) is the white point at the luminance of 1 cd m-2 (or lux).
struct Rgb {
    double r, g, b;
};

// Which primaries. Each space has a white of its own: D65 for sRGB and Rec.2020, D60 (ACES) for ACEScg.
enum class RgbSpace { srgb, rec2020, acescg };

// Which light looks white (equal amounts of the primaries). `sun` is the sun above the atmosphere.
enum class WhitePoint { d65, d60, e, sun };

struct Primaries {
    Chromaticity red, green, blue, white;
};
Primaries primaries(RgbSpace space);
Chromaticity white_chromaticity(WhitePoint white);

// "srgb", "rec2020", "acescg"; "D65", "D60", "E", "sun": as users write them. None if there is no such name.
std::optional<RgbSpace> rgb_space_named(std::string_view name);
std::optional<WhitePoint> white_point_named(std::string_view name);
std::string_view name_of(RgbSpace space);
std::string_view name_of(WhitePoint white);
inline constexpr std::string_view rgb_space_names = "srgb rec2020 acescg";
inline constexpr std::string_view white_point_names = "D65 D60 E sun";

// Turns the colour `from` into what looks the same to an eye adapted to `to` (Bradford's cone responses scaled, [Lam1985]).
glm::dmat3 adaptation(Chromaticity from, Chromaticity to);

// Between absolute colour and linear amounts of a space's primaries, so that light of the chosen white point becomes
// r = g = b = y. With the space's own white this is the plain matrix; with another, colours are adapted first.
// Colours outside of the triangle of primaries give negative amounts: kept, unless into_gamut() is asked.
class RgbConverter {
public:
    explicit RgbConverter(RgbSpace space, WhitePoint white);

    Rgb to_rgb(Xyz colour) const;
    Xyz to_xyz(Rgb colour) const;

    // y of a colour as the space's own white sees it: for a foreign white, that of the adapted colour.
    double luminance(Rgb colour) const;

    // The nearest colour towards grey of the same luminance that has no negative amount; unchanged if it has none.
    // Of negative luminance: black. Hue in the chromaticity diagram and luminance are kept, saturation gives way.
    Rgb into_gamut(Rgb colour) const;

private:
    glm::dmat3 to_rgb_, to_xyz_;
    glm::dvec3 luminance_;
};

// sRGB's transfer function between linear light and the encoded value, both in [0, 1] (IEC 61966-2-1).
double srgb_encoded(double linear);
double srgb_linear(double encoded);

}  // namespace airlight
