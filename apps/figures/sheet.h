// A sheet of pictures in rows and columns, each of one sky through one camera, and the luminance in one direction of each.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "atmosphere/atmosphere.h"
#include "figure.h"
#include "image/projection.h"
#include "sky/sky.h"
#include "sky/sky_image.h"

namespace airlight::figures {

// A sky at the standard wavelengths, with what turns its light into luminance.
struct ShownSky {
    Atmosphere atmosphere;
    std::shared_ptr<const Sky> sky;
};

// By a model of this project. `orders` is for `tables`: 1 is single scattering alone.
Result<ShownSky> shown_sky(const Settings& settings, std::string_view model, const Atmosphere& atmosphere, int orders);

// cd m-2. Fails if the sky does not answer.
Result<double> luminance(const ShownSky& sky, const View& view);

// Where the eye is, what it looks at, how bright a picture of it is, and the direction whose luminance is noted.
struct Shot {
    std::string name;  // of the row
    SkyScene scene;
    Perspective camera;  // of a width that the settings give
    double ev100;
    double probe_zenith, probe_azimuth;  // radians; from the sun
};

struct Variation {
    std::string name;  // of the column
    ShownSky sky;
};

// Writes the pictures NAME-ROW-COLUMN.png and returns a table of one row a picture: row and column (words), eye_km, luminance_cd_m2.
Result<Table> sheet(const Settings& settings, std::string_view name, const std::vector<Shot>& shots,
                    const std::vector<Variation>& variations);

}  // namespace airlight::figures
