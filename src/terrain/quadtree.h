// Which patches an eye needs: the quadtree cut where its levels reach, without what cannot be seen.
// Uses camera and units.
#pragma once

#include <functional>
#include <unordered_map>

#include "terrain/level_of_detail.h"
#include "terrain/node_bounds.h"

namespace airlight {

struct NodeHash {
    std::size_t operator()(const Node& node) const;
};

struct Culling {
    bool frustum = true;
    bool horizon = true;
};

// Which patches are wanted, whether an eye sees them or not.
struct PatchChoice {
    std::function<bool(const NodeBounds&)> culled;
    std::function<bool(const Node&, const NodeBounds&)> fine_enough;  // although the eye sees it finer
};

struct Selection {
    std::vector<Node> nodes;  // the nearest roughly first: children come before what is coarser
    int visited = 0;
    int culled = 0;
};

class Quadtree {
public:
    Quadtree(HeightField field, LevelReach reach);

    Selection select(const Camera& camera, Culling culling = {});
    // Where patches are coarser than the eye's their edges need not meet.
    Selection select(Vec3 eye, const PatchChoice& choice);

    const NodeBounds& bounds(const Node& node);
    const HeightField& field() const { return field_; }
    const LevelReach& reach() const { return reach_; }
    // The radius up to which triangles hide what is behind them, seen from an eye: the least ground, less what flat triangles at
    // the distance of the horizon sag below it.
    double solid_m(Vec3 eye) const;

private:
    void select(const Node& node, Vec3 eye, const PatchChoice& choice, Selection& selection);

    HeightField field_;
    LevelReach reach_;
    std::unordered_map<Node, NodeBounds, NodeHash> bounds_;  // of nodes lately asked for; a bound on its size, see bounds()
};

}  // namespace airlight
