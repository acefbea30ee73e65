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

    // Asks for the sky of a scene in one direction. What was asked before is forgotten; never waits.
    void ask(const Scene& scene, const viewer::ProbedView& view);
    // The next one reads the air's files anew.
    void forget_air() { ++airs_; }
    // The answer; none before there is one.
    const std::optional<Result<viewer::Probe>>& answer();

private:
    struct Wish {
        Scene scene;
        viewer::ProbedView view;
        int air;  // how often airs were forgotten before
    };
    // Of one air on one planet.
    struct Model {
        Wish made_for;
        std::shared_ptr<const Sky> sky;
        std::shared_ptr<const ColourWeights> colour;
    };
    struct Answer {
        Result<viewer::Probe> probe;
        std::optional<Model> model;
    };
    static bool answers(const Model& model, const Wish& wish);
    static Answer answer_of(const Wish& wish, std::optional<Model> model, const TableWishes& wishes);
    void begin(const Wish& wish);

    TableWishes wishes_;
    int airs_ = 0;
    std::optional<Wish> next_;  // once what is being answered is
    std::optional<Model> model_;
    std::future<Answer> coming_;
    std::optional<Result<viewer::Probe>> answer_;
};

}  // namespace airlight::cli
