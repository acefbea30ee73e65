#include "eval/drawn.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "image/png.h"
#include "image/tone.h"
#include "spectrum/colour.h"
#include "units/units.h"

namespace airlight {

namespace {

Result<std::string> png_uri(const Image& display) {
    const Result<std::string> bytes = png_bytes(display);
    if (!bytes) return bytes.error();
    return "data:image/png;base64," + base64(*bytes);
}

// Of a plot: pixels of the SVG's own.
constexpr double plot_width = 300.0, plot_height = 150.0, left = 34.0, bottom = 30.0, margin = 6.0;

// Whole powers of ten around the values.
struct Decades {
    double low = 0.0, high = 1.0;
};
Decades decades(const ProfilePlot& plot) {
    double least = 1e300, most = 0.0;
    for (const std::span<const double> values : {plot.truth, plot.model})
        for (const double v : values)
            if (v > 0.0) least = std::min(least, v), most = std::max(most, v);
    if (most == 0.0) return {};
    const double high = std::ceil(std::log10(most) + 1e-9);
    return {std::max(std::floor(std::log10(least)), high - 6.0), high};  // six decades are enough to see what is wrong
}

// A path along the values, broken where there is none.
std::string path(const ProfilePlot& plot, std::span<const double> values, Decades d, std::string_view kind) {
    const double span = std::max(1e-9, plot.at.back() - plot.at.front());
    std::string commands;
    bool pen_down = false;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double height = values[i] > 0.0 ? (std::log10(values[i]) - d.low) / (d.high - d.low) : -1.0;
        if (height >= 0.0)
            commands += fmt::format("{}{:.1f} {:.1f}", pen_down ? "L" : "M",
                                    left + (plot.at[i] - plot.at.front()) / span * (plot_width - left - margin),
                                    margin + (1.0 - height) * (plot_height - margin - bottom));
        pen_down = height >= 0.0;
    }
    return fmt::format("<path class=\"{}\" d=\"{}\"/>", kind, commands);
}

}  // namespace

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned block = 0;
        for (std::size_t j = 0; j < 3; ++j) block = block << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0u);
        for (std::size_t j = 0; j < 4; ++j) text += i + j <= bytes.size() ? digits[block >> (18 - 6 * j) & 63] : '=';
    }
    return text;
}

Result<std::string> picture_uri(const Image& linear, double exposure) { return png_uri(developed(linear, exposure, ToneCurve::filmic)); }

MapColour deviation_colour(double deviation) {
    // The root lets small deviations show; steps make contours, and files small.
    const double t = std::clamp(deviation / 0.5, -1.0, 1.0), s = std::round(16.0 * std::sqrt(std::abs(t))) / 16.0;
    const MapColour end = t < 0.0 ? MapColour{0.02, 0.19, 0.58} : MapColour{0.62, 0.02, 0.10};
    return {1.0 + s * (end.r - 1.0), 1.0 + s * (end.g - 1.0), 1.0 + s * (end.b - 1.0)};
}

std::string hex(MapColour c) {
    const auto level = [](double x) { return static_cast<int>(std::lround(255.0 * x)); };
    return fmt::format("#{:02x}{:02x}{:02x}", level(c.r), level(c.g), level(c.b));
}

Result<std::string> map_uri(int width, int height, std::span<const std::optional<double>> deviations) {
    Image image(width, height, 3);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const std::optional<double> deviation = deviations[static_cast<std::size_t>(row * width + column)];
            const MapColour c = deviation ? deviation_colour(*deviation) : MapColour{0.5, 0.5, 0.5};
            const std::span<float> pixel = image.pixel(column, row);
            pixel[0] = static_cast<float>(srgb_linear(c.r));
            pixel[1] = static_cast<float>(srgb_linear(c.g));
            pixel[2] = static_cast<float>(srgb_linear(c.b));
        }
    return png_uri(image);
}

std::string dots_svg(std::span<const SkyDot> dots, int size) {
    std::string svg = fmt::format(
        "<svg class=\"map\" viewBox=\"-100 -100 200 200\" width=\"{0}\" height=\"{0}\"><circle r=\"99\" fill=\"#808080\"/>", size);
    for (const SkyDot& dot : dots) {
        const double r = 92.0 * dot.zenith / (0.5 * pi);
        svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"7\" fill=\"{}\"/>", -r * std::sin(dot.azimuth),
                           -r * std::cos(dot.azimuth), dot.deviation ? hex(deviation_colour(*dot.deviation)) : "#606060");
    }
    return svg + "</svg>";
}

std::string profile_svg(const ProfilePlot& plot) {
    const Decades d = decades(plot);
    std::string svg = fmt::format("<svg class=\"plot\" viewBox=\"0 0 {:g} {:g}\">", plot_width, plot_height);
    const int step = d.high - d.low > 3.0 ? 2 : 1;
    for (int decade = static_cast<int>(d.low); decade <= static_cast<int>(d.high); decade += step) {
        const double y = margin + (d.high - decade) / (d.high - d.low) * (plot_height - margin - bottom);
        svg += fmt::format("<path class=\"grid\" d=\"M{:g} {:.1f}H{:g}\"/><text x=\"{:g}\" y=\"{:.1f}\" text-anchor=\"end\">1e{}</text>",
                           left, y, plot_width - margin, left - 3.0, y + 3.0, decade);
    }
    svg += path(plot, plot.truth, d, "truth") + path(plot, plot.model, d, "model");
    svg += fmt::format("<text x=\"{:g}\" y=\"{:g}\">{:.0f}</text><text x=\"{:g}\" y=\"{:g}\" text-anchor=\"end\">{:.0f}</text>", left,
                       plot_height - 18.0, plot.at.front(), plot_width - margin, plot_height - 18.0, plot.at.back());
    svg += fmt::format("<text x=\"{:g}\" y=\"{:g}\" text-anchor=\"middle\">cd m⁻² over {}</text></svg>", 0.5 * (left + plot_width),
                       plot_height - 4.0, html_text(plot.axis));
    return svg;
}

std::string html_text(std::string_view text) {
    std::string escaped;
    for (const char c : text) switch (c) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            case '\'':
                escaped += "&#39;";
                break;
            default:
                escaped += c;
        }
    return escaped;
}

}  // namespace airlight
