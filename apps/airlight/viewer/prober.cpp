#include "prober.h"

#include <chrono>
#include <utility>

#include "../scene_air.h"
#include "models/model.h"

namespace airlight::cli {

Prober::Prober(TableWishes wishes) : wishes_(std::move(wishes)) { wishes_.progress = {}; }

bool Prober::answers(const Model& model, const Wish& wish) {
    const Scene &made = model.made_for.scene, &wished = wish.scene;
    return made.atmosphere == wished.atmosphere && made.weather == wished.weather && made.ground == wished.ground &&
           model.made_for.air == wish.air;
}

Prober::Answer Prober::answer_of(const Wish& wish, std::optional<Model> model, const TableWishes& wishes) {
    if (!model || !answers(*model, wish)) {
        const Result<std::optional<Atmosphere>> air = air_of(wish.scene);
        if (!air) return {air.error(), {}};
        if (!*air) return {Error{"", "there is no air", "Choose one."}, {}};
        const WavelengthGrid grid = WavelengthGrid::standard();
        Result<std::unique_ptr<Sky>> sky =
            make_sky("airlight", **air, {grid.begin(), grid.end()}, {.bake = wishes.bake, .cache = wishes.cache});
        if (!sky) return {sky.error(), {}};
        model = Model{wish, *std::move(sky), std::make_shared<const ColourWeights>(grid, (*air)->sun.irradiance)};
    }
    return {viewer::probed(*model->sky, *model->colour, wish.view), model};
}

void Prober::begin(const Wish& wish) { coming_ = std::async(std::launch::async, answer_of, wish, model_, wishes_); }

void Prober::ask(const Scene& scene, const viewer::ProbedView& view) {
    answer_.reset();
    next_ = Wish{scene, view, airs_};
}

const std::optional<Result<viewer::Probe>>& Prober::answer() {
    if (coming_.valid() && coming_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        Answer there = coming_.get();
        model_ = std::move(there.model);
        if (!next_) answer_ = std::move(there.probe);
    }
    if (next_ && !coming_.valid()) begin(*std::exchange(next_, std::nullopt));
    return answer_;
}

}  // namespace airlight::cli
