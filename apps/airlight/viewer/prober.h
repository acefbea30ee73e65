// Probes of the sky, computed on another thread: the first one in an air makes the model.
#pragma once

#include <future>
#include <optional>

#include "../frame_of_scene.h"
#include "viewer/probe.h"

namespace airlight::cli {

class Prober {
public:
    explicit Prober(TableWishes wishes);

    // Asks for the sky of a scene in one direction. What was asked before is forgotten.
    void ask(const Scene& scene, const viewer::ProbedView& view);
    // The answer; none before there is one.
    const std::optional<Result<viewer::Probe>>& answer();

private:
    // Of one air on one planet.
    struct Model {
        Scene scene;
        std::shared_ptr<const Sky> sky;
        std::shared_ptr<const ColourWeights> colour;
    };
    struct Answer {
        Result<viewer::Probe> probe;
        std::optional<Model> model;
    };
    static Answer answer_of(const Scene& scene, const viewer::ProbedView& view, std::optional<Model> model, const TableWishes& wishes);

    TableWishes wishes_;
    std::optional<Model> model_;
    std::future<Answer> coming_;
    std::optional<Result<viewer::Probe>> answer_;
};

}  // namespace airlight::cli
