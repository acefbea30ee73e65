// Preetham's sky in linear sRGB, as it was published, for pictures: no wavelengths, many directions at once.
// What it is and leaves out: preetham1999.cpp. The loop runs over directions in the vector unit. [Preetham1999]
#pragma once

#include <span>

#include "models/direction_batch.h"

namespace airlight {

// The sky of one sun. Turbidity 1.7 to 10; the sun at 0 to pi / 2 from the zenith.
class Preetham1999Rgb {
public:
    Preetham1999Rgb(double turbidity, double sun_zenith);

    // Linear amounts of the primaries of sRGB, [directions][3]: (1, 1, 1) is its white at 1 cd m-2. Black below the horizon;
    // colours outside of the triangle of primaries keep their negative amounts.
    void radiances(std::span<const Direction> directions, std::span<float> rgb) const;

private:
    BatchSun sun_;
    batch::Preetham1999 sky_;
};

}  // namespace airlight
