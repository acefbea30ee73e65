// The wavelengths at which light is computed, chosen by the user.
// Theory: docs/theory.md, section 6.
// Uses units; knows nothing of sun, air or eye.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "units/units.h"

namespace airlight {

// Wavelengths that strictly increase; at least one, at most max_size, each between 1 nm and 1 mm.
class WavelengthGrid {
public:
    static constexpr int max_size = 4096;

    // Fails, naming the wavelength, if the invariant above does not hold.
    static Result<WavelengthGrid> of(std::vector<Wavelength> wavelengths);

    // `count` wavelengths at equal distances, ends included; a single one if first == last.
    static Result<WavelengthGrid> uniform(Wavelength first, Wavelength last, int count);

    // The sixteen wavelengths that carry the colour of skies best: from 360 to 830 nm, dense where the eye sees.
    static WavelengthGrid standard();

    int size() const { return static_cast<int>(wavelengths_.size()); }
    Wavelength operator[](int i) const { return wavelengths_[static_cast<std::size_t>(i)]; }
    auto begin() const { return wavelengths_.begin(); }
    auto end() const { return wavelengths_.end(); }
    Wavelength first() const { return wavelengths_.front(); }
    Wavelength last() const { return wavelengths_.back(); }

    friend bool operator==(const WavelengthGrid&, const WavelengthGrid&) = default;

private:
    explicit WavelengthGrid(std::vector<Wavelength> wavelengths) : wavelengths_(std::move(wavelengths)) {}
    std::vector<Wavelength> wavelengths_;
};

// A grid as people write it, in nm: "360:830:16" (first, last, count), "450,550,650" (each), or "standard".
Result<WavelengthGrid> parse_wavelength_grid(std::string_view text);

// One of these that reads back to the same grid: a name, a uniform grid of five or more, or a list.
std::string wavelength_grid_text(const WavelengthGrid& grid);

}  // namespace airlight
