// How finely bruneton2008 fills its tables, and in which of the published forms it keeps them. What they mean: bruneton2008.cpp.
#pragma once

namespace airlight {

struct Bruneton2008Settings {
    // Texels of the scattering tables [BrunetonNeyret2008, section 4]; `view` is even and at least 4, the others are at least 2.
    int altitude = 32;
    int view = 128;
    int sun = 32;
    int nu = 8;
    // The sun's texels crowd around twilight and go on to 120 degrees from the zenith, as those of the source; not as in the paper.
    bool twilight = false;
    // Single Mie scattering at one wavelength alone, its colour by the rule of proportion.
    bool four_channels = false;
    // Scattering tables of 256 levels. [Sperlhofer2011, section 5.2.2]
    bool eight_bits = false;
};

}  // namespace airlight
