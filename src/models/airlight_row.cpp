#include "models/airlight_row.h"

namespace airlight {

namespace {

// The way of a row: its pieces, as if no shadow cut them.
class Way {
public:
    Way(const f32::AirlightAir& air, const AirlightTables& tables, f32::Length h, f32::Number mu)
        : air_(air), tables_(tables), h_(h), start_((air.bottom + h) * mu) {
        grounded_ = f32::meets_ground(h, mu, air.bottom);
        length_ = f32::airlight_length(air, h, mu, grounded_);
        const f32::Length end = start_ + length_;
        f32::Length x = start_, reach = f32::Length::of(0.0f);
        while (x < end) {
            const f32::Length to = f32::airlight_next_cut(air, densities_, h, start_, x, end, reach);
            pieces_.push_back({x, to, columns_, nodes_.size()});
            march(x, to, columns_, [&](const f32::AirlightNode& node) { nodes_.push_back(node); });
            x = to;
        }
    }

    f32::AirlightLight light(const f32::AirlightRay& ray) const {
        f32::AirlightSums sums = f32::airlight_nothing();
        for (const Piece& piece : pieces_) gather(ray, piece, sums);
        f32::AirlightLight light = f32::airlight_summed(air_, sums, columns_);
        if (grounded_)
            light.multiple = light.multiple + f32::airlight_ground(air_, tables_.transmittance_table(), tables_.diffuse_table(),
                                                                   f32::airlight_ground_sun(air_, ray, length_)) *
                                                  light.transmittance;
        return light;
    }

private:
    struct Piece {
        f32::Length from, to;
        f32::AirlightColumns before;
        std::size_t first_node;
    };

    // Calls at_node(node) along [from, to]; columns before become those after.
    template <class AtNode>
    void march(f32::Length from, f32::Length to, f32::AirlightColumns& columns, AtNode at_node) const {
        const f32::AirlightPiece piece = f32::airlight_piece(air_, h_, start_, from, to);
        for (int k = 0; k < air_.rule.count; ++k) at_node(f32::airlight_node(air_, densities_, start_, piece, k, columns));
        f32::airlight_end_piece(air_, densities_, piece, columns);
    }

    void gather(const f32::AirlightRay& ray, const Piece& piece, f32::AirlightSums& sums) const {
        const auto add = [&](const f32::AirlightNode& node) {
            f32::airlight_gather(air_, tables_.transmittance_table(), tables_.source_table(), ray, node, sums);
        };
        f32::Length to = f32::airlight_shadow_cut(air_, ray, piece.from, piece.to);
        if (to >= piece.to) {
            for (int k = 0; k < air_.rule.count; ++k) add(nodes_[piece.first_node + static_cast<std::size_t>(k)]);
            return;
        }
        f32::AirlightColumns columns = piece.before;
        for (f32::Length x = piece.from; x < piece.to; x = to, to = f32::airlight_shadow_cut(air_, ray, x, piece.to))
            march(x, to, columns, add);
    }

    const f32::AirlightAir& air_;
    const AirlightTables& tables_;
    Table2D<f32::Spectrum> densities_ = tables_.density_table();
    f32::Length h_, start_, length_;
    bool grounded_;
    f32::AirlightColumns columns_{};  // of the whole way
    std::vector<Piece> pieces_;
    std::vector<f32::AirlightNode> nodes_;
};

}  // namespace

std::vector<f32::AirlightLight> airlight_row(const f32::AirlightAir& air, const AirlightTables& tables,
                                             std::span<const f32::AirlightRay> rays) {
    const Way way(air, tables, rays[0].h, rays[0].mu);
    std::vector<f32::AirlightLight> lights;
    for (const f32::AirlightRay& ray : rays) lights.push_back(way.light(ray));
    return lights;
}

}  // namespace airlight
