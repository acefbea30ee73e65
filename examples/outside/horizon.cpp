// How far away the horizon of the Earth is for an eye at a height: horizon "2 m" prints 5.048 km.

#include <cstdio>

#include "physics/f64.h"
#include "units/text.h"
#include "units/units.h"

using namespace airlight;

int main(int argc, char** argv) {
    const Result<Length> height = parse_length(argc > 1 ? argv[1] : "");
    if (!height || *height < 0.0 * m) {
        const char* usage = "usage: horizon \"<height>\"";
        std::fprintf(stderr, "%s\n%s\n", usage, height ? "The height must be at least 0 m." : height.error().message().c_str());
        return 1;
    }
    const Length earth = 6371.0 * km;
    const Number towards_horizon = f64::horizon_cosine(*height, earth);
    std::printf("%.4g km\n", f64::distance_to_ground(*height, towards_horizon, earth).in(km));
}
