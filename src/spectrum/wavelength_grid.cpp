#include "spectrum/wavelength_grid.h"

#include <fmt/format.h>

#include <cmath>

#include "units/text.h"

namespace airlight {

namespace {

constexpr Wavelength shortest = 1.0 * nm;
constexpr Wavelength longest = 1e6 * nm;
constexpr const char* forms =
    "Write wavelengths in nm: first, last and count (\"360:830:16\"), a rising list (\"450,550,650\"), or \"standard\".";

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

// The numbers of a text; none of a wrong part is read.
Result<std::vector<double>> parse_numbers(std::string_view text, char separator) {
    std::vector<double> numbers;
    for (const std::string_view part : split(text, separator)) {
        if (numbers.size() == WavelengthGrid::max_size)
            return Error{"", fmt::format("the list has more than {} wavelengths", WavelengthGrid::max_size), forms};
        const Result<double> number = parse_number(part);
        if (!number) return Error{"", fmt::format("\"{}\" is not a wavelength in nm", part), forms};
        numbers.push_back(*number);
    }
    return numbers;
}

Result<WavelengthGrid> parse_uniform(std::string_view text) {
    const Result<std::vector<double>> numbers = parse_numbers(text, ':');
    if (!numbers) return numbers.error();
    if (numbers->size() != 3) return Error{"", fmt::format("\"{}\" does not have first, last and count", text), forms};
    const double count = (*numbers)[2];
    if (!(count >= 1.0 && count <= WavelengthGrid::max_size && count == std::floor(count)))
        return Error{
            "", fmt::format("{} wavelengths are asked for: the count is a whole number from 1 to {}", count, WavelengthGrid::max_size), ""};
    return WavelengthGrid::uniform((*numbers)[0] * nm, (*numbers)[1] * nm, static_cast<int>(count));
}

}  // namespace

Result<WavelengthGrid> WavelengthGrid::of(std::vector<Wavelength> wavelengths) {
    if (wavelengths.empty()) return Error{"", "a wavelength grid needs at least one wavelength", ""};
    if (wavelengths.size() > max_size)
        return Error{"", fmt::format("{} wavelengths are more than {}", wavelengths.size(), max_size), "Take fewer."};
    for (std::size_t i = 0; i < wavelengths.size(); ++i) {
        const Wavelength w = wavelengths[i];
        if (!(w >= shortest && w <= longest))
            return Error{"", fmt::format("{} nm is no wavelength of light: it must lie between 1 nm and 1 mm", w.in(nm)), ""};
        if (i > 0 && !(wavelengths[i - 1] < w))
            return Error{"", fmt::format("{} nm does not lie above the wavelength before it, {} nm", w.in(nm), wavelengths[i - 1].in(nm)),
                         "Sort the wavelengths and remove doubles."};
    }
    return WavelengthGrid(std::move(wavelengths));
}

Result<WavelengthGrid> WavelengthGrid::uniform(Wavelength first, Wavelength last, int count) {
    if (count < 1 || count > max_size)
        return Error{"", fmt::format("{} wavelengths are asked for: the count is a whole number from 1 to {}", count, max_size), ""};
    if (count == 1 && first != last)
        return Error{"", fmt::format("one wavelength cannot reach from {} to {} nm", first.in(nm), last.in(nm)),
                     "Ask for two or more, or for one alone."};
    std::vector<Wavelength> wavelengths;
    for (int i = 0; i < count; ++i) wavelengths.push_back(i + 1 == count ? last : first + (last - first) * (double(i) / (count - 1)));
    return of(std::move(wavelengths));
}

WavelengthGrid WavelengthGrid::standard() {
    std::vector<Wavelength> wavelengths;
    for (const double w : {360, 400, 430, 450, 465, 500, 525, 545, 565, 585, 600, 625, 660, 690, 710, 830}) wavelengths.push_back(w * nm);
    return WavelengthGrid(std::move(wavelengths));
}

Result<WavelengthGrid> parse_wavelength_grid(std::string_view text) {
    if (text == "standard") return WavelengthGrid::standard();
    if (text.find(':') != std::string_view::npos) return parse_uniform(text);
    const Result<std::vector<double>> numbers = parse_numbers(text, ',');
    if (!numbers) return numbers.error();
    std::vector<Wavelength> wavelengths;
    for (const double number : *numbers) wavelengths.push_back(number * nm);
    return WavelengthGrid::of(std::move(wavelengths));
}

std::string wavelength_grid_text(const WavelengthGrid& grid) {
    if (grid == WavelengthGrid::standard()) return "standard";
    if (grid.size() > 4) {
        const Result<WavelengthGrid> uniform = WavelengthGrid::uniform(grid.first(), grid.last(), grid.size());
        if (uniform && *uniform == grid) return fmt::format("{}:{}:{}", grid.first().in(nm), grid.last().in(nm), grid.size());
    }
    std::string text;
    for (const Wavelength w : grid) text += fmt::format("{}{}", text.empty() ? "" : ",", w.in(nm));
    return text;
}

}  // namespace airlight
