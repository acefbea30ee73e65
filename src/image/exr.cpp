#include "image/exr.h"

#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>
#include <fmt/format.h>
#include <half.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>
#include <thread>

#include "core/files.h"
#include "units/text.h"

namespace airlight {

namespace {

constexpr const char* unit_attribute = "airlight:unit";
constexpr const char* scale_attribute = "airlight:scale";
constexpr std::string_view note_prefix = "airlight:note:";
constexpr float largest_half = 65504.0f;

// A file being written, in memory, so that write_file() sees every byte and every failure.
class MemoryOutput : public Imf::OStream {
public:
    MemoryOutput() : Imf::OStream("memory") {}
    void write(const char* bytes, int count) override {
        const auto size = static_cast<std::size_t>(count);
        if (position_ + size > bytes_.size()) bytes_.resize(position_ + size);
        std::memcpy(bytes_.data() + position_, bytes, size);
        position_ += size;
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; }
    const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
    std::size_t position_ = 0;
};

// A file read whole.
class MemoryInput : public Imf::IStream {
public:
    explicit MemoryInput(const std::string& bytes) : Imf::IStream("memory"), bytes_(bytes) {}
    bool read(char* out, int count) override {
        const auto size = static_cast<std::size_t>(count);
        if (position_ > bytes_.size() || size > bytes_.size() - position_) throw std::runtime_error("the file ends too early");
        std::memcpy(out, bytes_.data() + position_, size);
        position_ += size;
        return position_ < bytes_.size();
    }
    std::uint64_t tellg() override { return position_; }
    void seekg(std::uint64_t position) override { position_ = position; }

private:
    const std::string& bytes_;
    std::size_t position_ = 0;
};

void use_all_cores() {
    if (Imf::globalThreadCount() == 0) Imf::setGlobalThreadCount(static_cast<int>(std::thread::hardware_concurrency()));
}

// 1, or the power of two that brings the largest value between 1 and what half can hold.
double half_scale(const Image& image) {
    const float largest = *std::max_element(image.values.begin(), image.values.end());
    if (largest == 0.0f || (largest >= 1.0f && largest <= largest_half)) return 1.0;
    const double quotient = static_cast<double>(largest) / (largest < 1.0f ? 1.0 : static_cast<double>(largest_half));
    return std::exp2(largest < 1.0f ? std::floor(std::log2(quotient)) : std::ceil(std::log2(quotient)));
}

bool is_spectral(const ImageMeaning& meaning) {
    return std::any_of(meaning.channel_names.begin(), meaning.channel_names.end(),
                       [](const std::string& name) { return spectral_channel_wavelength(name).has_value(); });
}

void add_meaning(Imf::Header& header, const ImageMeaning& meaning, double scale) {
    header.insert(unit_attribute, Imf::StringAttribute(meaning.unit));
    header.insert(scale_attribute, Imf::FloatAttribute(static_cast<float>(scale)));
    if (const auto& p = meaning.primaries) {
        const auto v2f = [](Chromaticity c) { return Imath::V2f(static_cast<float>(c.x), static_cast<float>(c.y)); };
        Imf::addChromaticities(header, {v2f(p->red), v2f(p->green), v2f(p->blue), v2f(p->white)});
        if (meaning.unit == unit_luminance) Imf::addWhiteLuminance(header, static_cast<float>(scale));
    }
    if (is_spectral(meaning)) {
        header.insert("spectralLayoutVersion", Imf::StringAttribute("1.0"));
        header.insert("emissiveUnits", Imf::StringAttribute("W.m^-2.sr^-1.nm^-1"));
    }
    for (const auto& [name, text] : meaning.notes) header.insert(std::string(note_prefix) + name, Imf::StringAttribute(text));
}

// One slice a channel, over interleaved pixels whose first is that of column `left` and row `top`.
template <class T>
Imf::FrameBuffer frame_buffer(Imf::PixelType type, T* pixels, const std::vector<std::string>& names, int width, int left, int top) {
    const std::size_t across = names.size() * sizeof(T), down = across * static_cast<std::size_t>(width);
    Imf::FrameBuffer buffer;
    for (std::size_t c = 0; c < names.size(); ++c) {
        char* origin =
            reinterpret_cast<char*>(pixels + c) - static_cast<std::ptrdiff_t>(across) * left - static_cast<std::ptrdiff_t>(down) * top;
        buffer.insert(names[c], Imf::Slice(type, origin, across, down));
    }
    return buffer;
}

std::string encoded(const Image& image, const ImageMeaning& meaning, ExrPixels pixels) {
    use_all_cores();
    const bool small = pixels == ExrPixels::float16;
    const double scale = small ? half_scale(image) : 1.0;
    Imf::Header header(image.width, image.height);
    header.compression() = small ? Imf::PIZ_COMPRESSION : Imf::ZIP_COMPRESSION;  // the faster of the two for each
    header.zipCompressionLevel() = 1;
    add_meaning(header, meaning, scale);
    for (const std::string& name : meaning.channel_names) header.channels().insert(name, Imf::Channel(small ? Imf::HALF : Imf::FLOAT));

    std::vector<half> halves;
    if (small)
        for (const float value : image.values) halves.emplace_back(static_cast<float>(value / scale));
    MemoryOutput output;
    {
        Imf::OutputFile file(output, header, Imf::globalThreadCount());
        file.setFrameBuffer(
            small ? frame_buffer(Imf::HALF, halves.data(), meaning.channel_names, image.width, 0, 0)
                  : frame_buffer(Imf::FLOAT, const_cast<float*>(image.values.data()), meaning.channel_names, image.width, 0, 0));
        file.writePixels(image.height);
    }
    return output.bytes();
}

// R, G, B, A first, then wavelengths as they rise, then all others by name.
std::vector<std::string> ordered_channels(const Imf::ChannelList& channels) {
    std::vector<std::pair<double, std::string>> ranked;
    for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
        const std::string name = channel.name();
        const std::size_t rgba = std::string("RGBA").find(name);
        const auto wavelength = spectral_channel_wavelength(name);
        const bool is_rgba = name.size() == 1 && rgba != std::string::npos;
        ranked.emplace_back(is_rgba      ? -4.0 + static_cast<double>(rgba)
                            : wavelength ? wavelength->in(nm)
                                         : std::numeric_limits<double>::infinity(),
                            name);
    }
    std::sort(ranked.begin(), ranked.end());
    std::vector<std::string> names;
    for (auto& [rank, name] : ranked) names.push_back(std::move(name));
    return names;
}

std::string text_attribute(const Imf::Header& header, const char* name) {
    const auto* attribute = header.findTypedAttribute<Imf::StringAttribute>(name);
    return attribute ? attribute->value() : std::string();
}

ImageMeaning meaning_of(const Imf::Header& header) {
    ImageMeaning meaning{ordered_channels(header.channels()), text_attribute(header, unit_attribute), std::nullopt, {}};
    if (Imf::hasChromaticities(header)) {
        const Imf::Chromaticities& c = Imf::chromaticities(header);
        const auto chromaticity = [](const Imath::V2f& v) { return Chromaticity{v.x, v.y}; };
        meaning.primaries = Primaries{chromaticity(c.red), chromaticity(c.green), chromaticity(c.blue), chromaticity(c.white)};
    }
    for (auto attribute = header.begin(); attribute != header.end(); ++attribute)
        if (const std::string name = attribute.name(); name.starts_with(note_prefix))
            meaning.notes.emplace_back(name.substr(note_prefix.size()), text_attribute(header, name.c_str()));
    return meaning;
}

Result<MeantImage> decoded(const std::string& bytes) {
    use_all_cores();
    MemoryInput input(bytes);
    Imf::InputFile file(input, Imf::globalThreadCount());
    const Imath::Box2i window = file.header().dataWindow();
    const auto width = static_cast<std::int64_t>(window.max.x) - window.min.x + 1,
               height = static_cast<std::int64_t>(window.max.y) - window.min.y + 1;
    if (width > Image::max_side || height > Image::max_side)
        return Error{"", fmt::format("holds {} x {} pixels: each side has at most {}", width, height, Image::max_side), ""};
    if (!file.isComplete()) return Error{"", "is not complete: it ends before the last pixel", "Write or fetch it anew."};
    ImageMeaning meaning = meaning_of(file.header());
    for (auto channel = file.header().channels().begin(); channel != file.header().channels().end(); ++channel)
        if (channel.channel().xSampling != 1 || channel.channel().ySampling != 1)
            return Error{"", fmt::format("stores channel {} for some pixels only, which is not read here", channel.name()),
                         "Convert it to R, G and B."};
    const Result<Done> in_bounds =
        Image::check_size(static_cast<int>(width), static_cast<int>(height), static_cast<int>(meaning.channel_names.size()));
    if (!in_bounds) return in_bounds.error();

    Image image(static_cast<int>(width), static_cast<int>(height), static_cast<int>(meaning.channel_names.size()));
    file.setFrameBuffer(frame_buffer(Imf::FLOAT, image.values.data(), meaning.channel_names, image.width, window.min.x, window.min.y));
    file.readPixels(window.min.y, window.max.y);
    if (const auto* scale = file.header().findTypedAttribute<Imf::FloatAttribute>(scale_attribute))
        for (float& value : image.values) value *= scale->value();
    return MeantImage{std::move(image), std::move(meaning)};
}

}  // namespace

ImageMeaning ImageMeaning::rgb(RgbSpace space) { return {{"R", "G", "B"}, std::string(unit_luminance), airlight::primaries(space), {}}; }

ImageMeaning ImageMeaning::spectral(std::span<const Wavelength> wavelengths) {
    ImageMeaning meaning{{}, std::string(unit_spectral_radiance), std::nullopt, {}};
    for (const Wavelength w : wavelengths) meaning.channel_names.push_back(spectral_channel_name(w));
    return meaning;
}

std::string spectral_channel_name(Wavelength wavelength) {
    std::string number = fmt::format("{}", wavelength.in(nm));
    std::replace(number.begin(), number.end(), '.', ',');
    return "S0." + number + "nm";
}

std::optional<Wavelength> spectral_channel_wavelength(std::string_view name) {
    if (!name.starts_with("S0.") || !name.ends_with("nm") || name.size() < 6) return std::nullopt;
    std::string number(name.substr(3, name.size() - 5));
    std::replace(number.begin(), number.end(), ',', '.');
    const Result<double> wavelength = parse_number(number);
    return wavelength ? std::optional(*wavelength * nm) : std::nullopt;
}

Result<Done> write_exr(const std::filesystem::path& path, const Image& image, const ImageMeaning& meaning, ExrPixels pixels) {
    assert(meaning.channel_names.size() == static_cast<std::size_t>(image.channels));
    const Result<Done> checked =
        check_values(image, meaning.channel_names, 0.0f, std::numeric_limits<float>::max(), "light is finite and not negative");
    if (!checked) return at(path.string(), checked.error());
    try {
        return write_file(path, encoded(image, meaning, pixels));
    } catch (const std::exception& failure) {
        return Error{path.string(), fmt::format("cannot be written as OpenEXR: {}", failure.what()), ""};
    }
}

Result<MeantImage> read_exr(const std::filesystem::path& path) {
    const Result<std::string> bytes = read_file(path, std::size_t{8} << 30);
    if (!bytes) return bytes.error();
    try {
        Result<MeantImage> image = decoded(*bytes);
        if (!image) return at(path.string(), image.error());
        return image;
    } catch (const std::exception& failure) {
        return Error{path.string(), fmt::format("is not a readable OpenEXR image: {}", failure.what()),
                     "Check that it is one, and complete."};
    }
}

}  // namespace airlight
