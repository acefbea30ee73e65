#include "image/png.h"

#include <fmt/format.h>
#include <png.h>

#include <array>
#include <cassert>
#include <cmath>
#include <csetjmp>
#include <cstring>

#include "core/files.h"
#include "core/parallel.h"
#include "spectrum/colour.h"

namespace airlight {

namespace {

// Thresholds in [0, 1) that are spread evenly over every neighbourhood: multiples of the plastic number's inverse powers,
// modulo one (Roberts 2018, sequence R2). Channels are shifted so that their patterns differ.
double threshold(int column, int row, int channel) {
    const double t = 0.5 + 0.7548776662466927 * column + 0.5698402909980532 * row + channel / 3.0;
    return t - std::floor(t);
}

// Level of an encoded value in [0, 1], rounded up with a chance of its fraction. 0 and 1 have no fraction.
int dithered(double encoded, int highest, double threshold) { return std::min(highest, static_cast<int>(encoded * highest + threshold)); }

// Rows of levels as PNG stores them: one byte each, or two, high byte first.
std::vector<std::uint8_t> stored_levels(const Image& display, PngBits bits) {
    const std::size_t bytes = bits == PngBits::sixteen ? 2 : 1;
    const int highest = bits == PngBits::sixteen ? 65535 : 255;
    std::vector<std::uint8_t> stored(display.values.size() * bytes);
    const std::size_t row_size = static_cast<std::size_t>(display.width) * static_cast<std::size_t>(display.channels);
    parallel_for(static_cast<std::size_t>(display.height), [&](std::size_t row) {
        for (std::size_t i = 0; i < row_size; ++i) {
            const int column = static_cast<int>(i) / display.channels, channel = static_cast<int>(i) % display.channels;
            const double encoded = srgb_encoded(static_cast<double>(display.values[row * row_size + i]));
            const int level = dithered(encoded, highest, threshold(column, static_cast<int>(row), channel));
            std::uint8_t* at = stored.data() + (row * row_size + i) * bytes;
            if (bytes == 2) *at++ = static_cast<std::uint8_t>(level >> 8);
            *at = static_cast<std::uint8_t>(level & 255);
        }
    });
    return stored;
}

// What libpng says when it fails, and the way back: its functions never return from an error.
struct Failure {
    std::jmp_buf way_back;
    char message[200] = "";
};
[[noreturn]] void fail(png_structp png, png_const_charp message) {
    auto* failure = static_cast<Failure*>(png_get_error_ptr(png));
    std::strncpy(failure->message, message, sizeof failure->message - 1);
    std::longjmp(failure->way_back, 1);
}
void ignore_warning(png_structp, png_const_charp) {}

void append(png_structp png, png_bytep bytes, std::size_t count) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}
void no_flush(png_structp) {}

void take(png_structp png, png_bytep out, std::size_t count) {
    auto* rest = static_cast<std::string_view*>(png_get_io_ptr(png));
    if (rest->size() < count) png_error(png, "the file ends too early");
    std::memcpy(out, rest->data(), count);
    rest->remove_prefix(count);
}

// Below, no object with a destructor is made between setjmp() and the last call of libpng: longjmp() would skip it.

struct Size {
    int width, height, channels, bits;
};

bool encode(png_structp png, png_infop info, Failure& failure, const Size& size, std::span<const std::uint8_t> stored, std::string& file) {
    if (setjmp(failure.way_back) != 0) return false;
    png_set_write_fn(png, &file, append, no_flush);
    png_set_compression_level(png, 1);
    png_set_IHDR(png, info, static_cast<png_uint_32>(size.width), static_cast<png_uint_32>(size.height), size.bits,
                 size.channels == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(png, info);
    const std::size_t row_bytes = stored.size() / static_cast<std::size_t>(size.height);
    for (int row = 0; row < size.height; ++row) png_write_row(png, stored.data() + static_cast<std::size_t>(row) * row_bytes);
    png_write_end(png, info);
    return true;
}

bool decode_header(png_structp png, png_infop info, Failure& failure, std::string_view& rest, PngLevels& levels) {
    if (setjmp(failure.way_back) != 0) return false;
    png_set_read_fn(png, &rest, take);
    png_read_info(png, info);
    if (png_get_interlace_type(png, info) != PNG_INTERLACE_NONE) png_error(png, "interlaced files are not read here");
    png_set_expand(png);  // palettes to R, G, B; fewer bits than eight to eight
    png_read_update_info(png, info);
    levels.width = static_cast<int>(png_get_image_width(png, info));
    levels.height = static_cast<int>(png_get_image_height(png, info));
    levels.channels = png_get_channels(png, info);
    levels.bits = png_get_bit_depth(png, info);
    return true;
}

bool decode_row(png_structp png, Failure& failure, std::vector<std::uint8_t>& row) {
    if (setjmp(failure.way_back) != 0) return false;
    png_read_row(png, row.data(), nullptr);
    return true;
}

// libpng's two structures, freed together.
struct Reader {
    explicit Reader(Failure& failure)
        : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &failure, fail, ignore_warning)), info(png_create_info_struct(png)) {}
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
    png_structp png;
    png_infop info;
};
struct Writer {
    explicit Writer(Failure& failure)
        : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, &failure, fail, ignore_warning)), info(png_create_info_struct(png)) {}
    ~Writer() { png_destroy_write_struct(&png, &info); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    png_structp png;
    png_infop info;
};

Error unreadable(const std::filesystem::path& path, const Failure& failure) {
    return {path.string(), fmt::format("is not a readable PNG image: {}", failure.message), "Check that it is one, and complete."};
}

// The file of rows of levels.
Result<std::string> encoded(const Size& size, std::span<const std::uint8_t> stored) {
    std::string file;
    Failure failure;
    const Writer writer(failure);
    if (!encode(writer.png, writer.info, failure, size, stored, file))
        return Error{"", fmt::format("cannot be written as PNG: {}", failure.message), ""};
    return file;
}

}  // namespace

Result<std::string> png_bytes(const Image& display, PngBits bits) {
    assert(display.channels == 1 || display.channels == 3);
    const std::vector<std::string> names =
        display.channels == 3 ? std::vector<std::string>{"R", "G", "B"} : std::vector<std::string>{"grey"};
    const Result<Done> checked = check_values(display, names, 0.0f, 1.0f, "a display value lies between 0 and 1");
    if (!checked) return checked.error();
    return encoded({display.width, display.height, display.channels, static_cast<int>(bits)}, stored_levels(display, bits));
}

Result<Done> write_png(const std::filesystem::path& path, const Image& display, PngBits bits) {
    const Result<std::string> file = png_bytes(display, bits);
    if (!file) return at(path.string(), file.error());
    return write_file(path, *file);
}

Result<Done> write_png(const std::filesystem::path& path, const PngLevels& shown) {
    assert(shown.bits == 8 && (shown.channels == 1 || shown.channels == 3));
    const std::vector<std::uint8_t> stored(shown.levels.begin(), shown.levels.end());
    const Result<std::string> file = encoded({shown.width, shown.height, shown.channels, shown.bits}, stored);
    if (!file) return at(path.string(), file.error());
    return write_file(path, *file);
}

Result<PngLevels> read_png(const std::filesystem::path& path) {
    const Result<std::string> bytes = read_file(path);
    if (!bytes) return bytes.error();
    std::string_view rest = *bytes;
    PngLevels read{};
    Failure failure;
    const Reader reader(failure);
    if (!decode_header(reader.png, reader.info, failure, rest, read)) return unreadable(path, failure);
    if (const Result<Done> in_bounds = Image::check_size(read.width, read.height, read.channels); !in_bounds)
        return at(path.string(), in_bounds.error());

    const std::size_t row_size = static_cast<std::size_t>(read.width) * static_cast<std::size_t>(read.channels);
    std::vector<std::uint8_t> row(row_size * static_cast<std::size_t>(read.bits / 8));
    for (int y = 0; y < read.height; ++y) {
        if (!decode_row(reader.png, failure, row)) return unreadable(path, failure);
        for (std::size_t i = 0; i < row_size; ++i)
            read.levels.push_back(read.bits == 16 ? static_cast<std::uint16_t>(row[2 * i] << 8 | row[2 * i + 1]) : row[i]);
    }
    return read;
}

}  // namespace airlight
