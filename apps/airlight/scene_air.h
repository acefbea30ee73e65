// The light of a scene, for its frames: the sun above the air, the air's tables, the pass that draws it.
#pragma once

#include <optional>

#include "frame_of_scene.h"
#include "render/air_pass.h"
#include "render/light_pass.h"
#include "render/shafts_pass.h"
#include "transport/tables.h"

namespace airlight::cli {

// The file of a name that a scene writes, beside its own; the name, if there is none.
std::string beside(const Scene& scene, const std::string& name);

// What the sun shines with above the air, in lux of the primaries of sRGB.
render::Lights lights_of(const Scene& scene);

// The air of a scene on the scene's planet; none if it has none.
Result<std::optional<Atmosphere>> air_of(const Scene& scene);

// What methods of air are made of.
struct SceneAir {
    Atmosphere atmosphere;
    int orders;                    // of scattering
    std::optional<Tables> tables;  // for the wavelengths of a picture; none if they were not asked for
};

// Whether a method draws by tables that the CPU bakes. The others are there at once, or fill tables of their own between pictures.
bool needs_tables(AirMethodName method);

// `tables`: whether they are baked, or loaded.
Result<std::optional<SceneAir>> scene_air_of(const std::optional<Atmosphere>& air, bool tables, const TableWishes& wishes);

// Whether the tables of a bake are in the cache.
bool tables_are_kept(const Atmosphere& air, const TableWishes& wishes);

// Its pictures are in cd m-2 of the primaries of sRGB. `air` has tables if the scene's method needs them. An OpenGL context is current.
Result<std::optional<render::AirPass>> air_pass_of(const std::optional<SceneAir>& air, const Scene& scene);

// The scene's shadows, for pictures of a size. An OpenGL context is current.
Result<render::ShaftsPass> shafts_pass_of(const std::optional<Atmosphere>& air, const Scene& scene, int width, int height);

// Colours beyond the primaries, which a few wavelengths of a deep red sun have, are brought to their edge.
void bring_into_gamut(Image& image);

}  // namespace airlight::cli
