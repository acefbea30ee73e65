// What the files of tests/corpus/cache are of: one wavelength and the smallest tables, under a key that never changes.
#pragma once

#include "transport/table_file.h"

namespace airlight::fuzz {

inline TableOrigin cache_origin() {
    return {.key = {0x0123456789abcdef, 0xfedcba9876543210},
            .name = "corpus",
            .wavelengths = {550.0 * nm},
            .settings = {.sizes = {.transmittance_mu = 2, .transmittance_altitude = 2, .sun = 2, .azimuth = 2, .view = 2, .altitude = 2},
                         .orders = 3,
                         .extrapolate = true}};
}

}  // namespace airlight::fuzz
