// Images with their light and its meaning: OpenEXR files.
// The header says what the numbers are: unit, scale, primaries, white luminance; docs/conventions.md lists it.
// Uses images and the spaces of spectrum/colour.h.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "image/image.h"
#include "spectrum/colour.h"
#include "units/units.h"

namespace airlight {

inline constexpr std::string_view unit_luminance = "cd m-2";
inline constexpr std::string_view unit_spectral_radiance = "W m-2 sr-1 nm-1";

// What an image's numbers mean.
struct ImageMeaning {
    std::vector<std::string> channel_names;                  // one a channel: rgb_channels(), or spectral_channels()
    std::string unit;                                        // "cd m-2" or "W m-2 sr-1 nm-1"
    std::optional<Primaries> primaries;                      // of R, G, B; none for spectra
    std::vector<std::pair<std::string, std::string>> notes;  // more to keep in the header: place, time, model...

    static ImageMeaning rgb(RgbSpace space);                                // R, G, B in cd m-2: (1, 1, 1) is white of 1 cd m-2
    static ImageMeaning spectral(std::span<const Wavelength> wavelengths);  // W m-2 sr-1 nm-1
};

// "S0.550nm": the name of a wavelength's channel in the layout of spectral OpenEXR files [Fichet2021]; a decimal point is
// written as a comma, since a point separates layers. And back; none for other names.
std::string spectral_channel_name(Wavelength wavelength);
std::optional<Wavelength> spectral_channel_wavelength(std::string_view name);

// How numbers are stored. Half has 11 bits and ends at 65504: the file's values are then the image's divided by the
// smallest power of two that brings all of them below (the sun's disk needs 32768), and the header tells the scale.
enum class ExrPixels { float32, float16 };

struct MeantImage {
    Image image;
    ImageMeaning meaning;
};

// Writes an image, all or nothing (core/files.h). Fails, naming the path and the pixel, if a value is not finite or is
// negative; naming the path, if it cannot be written.
Result<Done> write_exr(const std::filesystem::path& path, const Image& image, const ImageMeaning& meaning,
                       ExrPixels pixels = ExrPixels::float32);

// Reads what write_exr() wrote, with its scale undone, and other scan-line or tiled files: all channels, R, G, B and
// spectral channels in their order first, others by name. Meaning that a file does not tell is left empty.
// Fails, naming the path, if it is no such file, is damaged or is larger than images may be.
Result<MeantImage> read_exr(const std::filesystem::path& path);

}  // namespace airlight
