#include "prober.h"

#include <chrono>
#include <utility>

#include "../scene_air.h"
#include "models/model.h"

namespace airlight::cli {

Prober::Prober(TableWishes wishes) : wishes_(std::move(wishes)) { wishes_.progress = {}; }

Prober::Answer Prober::answer_of(const Scene& scene, const viewer::ProbedView& view, std::optional<Model> model,
                                 const TableWishes& wishes) {
    if (!model || model->scene.atmosphere != scene.atmosphere || model->scene.weather != scene.weather ||
        !(model->scene.ground == scene.ground)) {
        const Result<std::optional<Atmosphere>> air = air_of(scene);
        if (!air) return {air.error(), {}};
        if (!*air) return {Error{"", "there is no air", "Choose one."}, {}};
        const WavelengthGrid grid = WavelengthGrid::standard();
        Result<std::unique_ptr<Sky>> sky =
            make_sky("airlight", **air, {grid.begin(), grid.end()}, {.bake = wishes.bake, .cache = wishes.cache});
        if (!sky) return {sky.error(), {}};
        model = Model{scene, *std::move(sky), std::make_shared<const ColourWeights>(grid, (*air)->sun.irradiance)};
    }
    return {viewer::probed(*model->sky, *model->colour, view), model};
}

void Prober::ask(const Scene& scene, const viewer::ProbedView& view) {
    if (coming_.valid()) model_ = coming_.get().model;  // one at a time
    answer_.reset();
    coming_ = std::async(std::launch::async, answer_of, scene, view, model_, wishes_);
}

const std::optional<Result<viewer::Probe>>& Prober::answer() {
    if (coming_.valid() && coming_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        Answer there = coming_.get();
        model_ = std::move(there.model);
        answer_ = std::move(there.probe);
    }
    return answer_;
}

}  // namespace airlight::cli
