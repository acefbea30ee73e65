#include "spectrum/colour.h"

#include <algorithm>
#include <array>
#include <glm/matrix.hpp>

#include "spectrum/solar.h"

namespace airlight {

namespace {

glm::dvec3 vector(Xyz c) { return {c.x, c.y, c.z}; }

// Chromaticities of CIE 015:2018 (D65), SMPTE ST 2065-1 (the white of ACES, near D60) and equal energy.
constexpr Chromaticity d65{0.3127, 0.3290};
constexpr Chromaticity d60{0.32168, 0.33767};
constexpr Chromaticity equal_energy{1.0 / 3.0, 1.0 / 3.0};

// Columns are the primaries, scaled so that (1, 1, 1) is the white of luminance 1.
glm::dmat3 rgb_to_xyz(const Primaries& p) {
    const glm::dmat3 unscaled(vector(with_luminance(p.red, 1.0)), vector(with_luminance(p.green, 1.0)),
                              vector(with_luminance(p.blue, 1.0)));
    const glm::dvec3 scale = glm::inverse(unscaled) * vector(with_luminance(p.white, 1.0));
    return {unscaled[0] * scale.x, unscaled[1] * scale.y, unscaled[2] * scale.z};
}

template <class E, std::size_t N>
std::optional<E> named(const std::array<std::pair<std::string_view, E>, N>& names, std::string_view name) {
    for (const auto& [candidate, value] : names)
        if (candidate == name) return value;
    return std::nullopt;
}
template <class E, std::size_t N>
std::string_view name_in(const std::array<std::pair<std::string_view, E>, N>& names, E value) {
    for (const auto& [name, candidate] : names)
        if (candidate == value) return name;
    return {};
}
constexpr std::array<std::pair<std::string_view, RgbSpace>, 3> space_names{
    {{"srgb", RgbSpace::srgb}, {"rec2020", RgbSpace::rec2020}, {"acescg", RgbSpace::acescg}}};
constexpr std::array<std::pair<std::string_view, WhitePoint>, 4> white_names{
    {{"D65", WhitePoint::d65}, {"D60", WhitePoint::d60}, {"E", WhitePoint::e}, {"sun", WhitePoint::sun}}};

}  // namespace

// IEC 61966-2-1; ITU-R BT.2020-2; AMPAS S-2014-004 (primaries AP1).
Primaries primaries(RgbSpace space) {
    if (space == RgbSpace::srgb) return {{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, d65};
    if (space == RgbSpace::rec2020) return {{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, d65};
    return {{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, d60};
}

Chromaticity white_chromaticity(WhitePoint white) {
    if (white == WhitePoint::d65) return d65;
    if (white == WhitePoint::d60) return d60;
    if (white == WhitePoint::e) return equal_energy;
    return chromaticity(to_xyz(solar_irradiance()));
}

std::optional<RgbSpace> rgb_space_named(std::string_view name) { return named(space_names, name); }
std::optional<WhitePoint> white_point_named(std::string_view name) { return named(white_names, name); }
std::string_view name_of(RgbSpace space) { return name_in(space_names, space); }
std::string_view name_of(WhitePoint white) { return name_in(white_names, white); }

glm::dmat3 adaptation(Chromaticity from, Chromaticity to) {
    // Rows of the cone responses of [Lam1985]; glm's constructor takes columns.
    const glm::dmat3 cones(0.8951, -0.7502, 0.0389,  //
                           0.2664, 1.7135, -0.0685,  //
                           -0.1614, 0.0367, 1.0296);
    const glm::dvec3 gain = (cones * vector(with_luminance(to, 1.0))) / (cones * vector(with_luminance(from, 1.0)));
    return glm::inverse(cones) * glm::dmat3(gain.x, 0, 0, 0, gain.y, 0, 0, 0, gain.z) * cones;
}

RgbConverter::RgbConverter(RgbSpace space, WhitePoint white) {
    const Primaries p = primaries(space);
    const glm::dmat3 own = rgb_to_xyz(p);
    to_xyz_ = adaptation(p.white, white_chromaticity(white)) * own;
    to_rgb_ = glm::inverse(to_xyz_);
    luminance_ = {own[0].y, own[1].y, own[2].y};
}

Rgb RgbConverter::to_rgb(Xyz colour) const {
    const glm::dvec3 rgb = to_rgb_ * vector(colour);
    return {rgb.x, rgb.y, rgb.z};
}

Xyz RgbConverter::to_xyz(Rgb colour) const {
    const glm::dvec3 xyz = to_xyz_ * glm::dvec3(colour.r, colour.g, colour.b);
    return {xyz.x, xyz.y, xyz.z};
}

double RgbConverter::luminance(Rgb c) const { return luminance_.x * c.r + luminance_.y * c.g + luminance_.z * c.b; }

Rgb RgbConverter::into_gamut(Rgb c) const {
    const double lowest = std::min({c.r, c.g, c.b});
    if (lowest >= 0.0) return c;
    const double grey = luminance(c);
    if (grey <= 0.0) return {0.0, 0.0, 0.0};
    const double kept = grey / (grey - lowest);  // grey + kept (lowest - grey) = 0
    const auto towards_grey = [&](double amount) { return std::max(0.0, grey + kept * (amount - grey)); };
    return {towards_grey(c.r), towards_grey(c.g), towards_grey(c.b)};
}

// 1.055 x^(1/2.4) - 0.055, written so that 1 stays 1 to the last bit.
double srgb_encoded(double linear) { return linear <= 0.0031308 ? 12.92 * linear : 1.0 + 1.055 * (std::pow(linear, 1.0 / 2.4) - 1.0); }
double srgb_linear(double encoded) { return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4); }

}  // namespace airlight
