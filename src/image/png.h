// Pictures for the screen: PNG files in sRGB.
// Theory: docs/theory.md, section 9.
// Uses images; tone.h makes what is written here.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "image/image.h"

namespace airlight {

enum class PngBits { eight = 8, sixteen = 16 };

// Writes linear display values in [0, 1], of one channel (grey) or three (R, G, B of sRGB), encoded with sRGB's transfer
// function and marked so (chunks sRGB and gAMA), all or nothing (core/files.h).
// Values are dithered: rounded up or down so that neighbours share the error, always in the same way, and a smooth sky
// has no bands. 0 and 1 stay exact.
// Fails, naming the path and the pixel, if a value is not within [0, 1]; naming the path, if it cannot be written.
Result<Done> write_png(const std::filesystem::path& path, const Image& display, PngBits bits = PngBits::eight);

// The bytes of that file, for those who put it elsewhere than in a folder.
Result<std::string> png_bytes(const Image& display, PngBits bits = PngBits::eight);

// The levels of a PNG file as stored, shape [height][width][channels]: encoded values, not light.
struct PngLevels {
    int width, height, channels, bits;
    std::vector<std::uint16_t> levels;
};

// Writes levels of 8 bits as they are, grey or R, G, B, marked as sRGB: what a display shows already.
// Fails, naming the path, if it cannot be written.
Result<Done> write_png(const std::filesystem::path& path, const PngLevels& shown);

// Fails, naming the path, if it is no PNG file, is damaged or is larger than images may be.
Result<PngLevels> read_png(const std::filesystem::path& path);

}  // namespace airlight
