#include "models/airlight_row.h"

#include <algorithm>

namespace airlight {

namespace {

// The way of a row: its pieces, as if no shadow cut them.
class Way {
public:
    Way(const AirlightTables& tables, const f32::AirlightRule& rule, f32::Length h, f32::Number mu)
        : tables_(tables), rule_(rule), h_(h), mu_(mu) {
        const f32::AirlightAir& air = tables.air;
        grounded_ = f32::meets_ground(h, mu, air.bottom);
        length_ = f32::airlight_length(air, h, mu, grounded_);
        if (!(length_.value > 0.0f)) return;
        cuts_ = f32::airlight_air_cuts(air, densities_, h, mu, length_);
        pieces_.resize(static_cast<std::size_t>(cuts_.count - 1));
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            pieces_[i].before = columns_;
            f32::airlight_piece(air, rule, densities_, h, mu, cuts_.at[i], cuts_.at[i + 1], columns_, pieces_[i].nodes);
        }
    }

    f32::AirlightLight light(const f32::AirlightRay& ray) const {
        const f32::AirlightAir& air = tables_.air;
        f32::AirlightSums sums = f32::airlight_nothing();
        const f32::AirlightCuts shadow = shadow_cuts(ray);
        for (std::size_t i = 0; i < pieces_.size(); ++i) gather(ray, i, shadow, sums);
        f32::AirlightLight light = f32::airlight_summed(air, sums, columns_);
        if (grounded_)
            light.multiple = light.multiple + f32::airlight_ground(air, tables_.transmittance_table(), tables_.diffuse_table(),
                                                                   f32::airlight_ground_sun(air, ray, length_)) *
                                                  light.transmittance;
        return light;
    }

private:
    struct Piece {
        f32::AirlightColumns before;
        f32::AirlightPiece nodes;
    };

    // The ray's ends, and what lies between them of the shadow's.
    f32::AirlightCuts shadow_cuts(const f32::AirlightRay& ray) const {
        f32::AirlightCuts cuts{};
        cuts.count = 2;
        cuts.at[0] = tables_.air.bottom * 0.0;
        if (pieces_.empty()) return cuts;
        cuts.at[0] = cuts_.at[0];
        cuts.at[1] = cuts_.at[cuts_.count - 1];
        f32::airlight_cut_shadow(tables_.air, ray, cuts);
        return cuts;
    }

    void gather(const f32::AirlightRay& ray, std::size_t i, const f32::AirlightCuts& shadow, f32::AirlightSums& sums) const {
        const f32::Length from = cuts_.at[i], to = cuts_.at[i + 1];
        f32::AirlightCuts cuts{};
        cuts.count = 2;
        cuts.at[0] = from;
        cuts.at[1] = to;
        for (int k = 1; k + 1 < shadow.count; ++k) f32::airlight_cut(cuts, shadow.at[k]);
        if (cuts.count == 2) return gather(ray, pieces_[i].nodes, sums);
        f32::AirlightColumns columns = pieces_[i].before;
        f32::AirlightPiece nodes;
        for (int k = 0; k + 1 < cuts.count; ++k) {
            f32::airlight_piece(tables_.air, rule_, densities_, h_, mu_, cuts.at[k], cuts.at[k + 1], columns, nodes);
            gather(ray, nodes, sums);
        }
    }

    void gather(const f32::AirlightRay& ray, const f32::AirlightPiece& nodes, f32::AirlightSums& sums) const {
        for (int k = 0; k < rule_.count; ++k)
            f32::airlight_gather(tables_.air, tables_.transmittance_table(), tables_.source_table(), ray, nodes.node[k], sums);
    }

    const AirlightTables& tables_;
    const f32::AirlightRule& rule_;
    Table2D<f32::Spectrum> densities_ = tables_.density_table();
    f32::Length h_;
    f32::Number mu_;
    bool grounded_;
    f32::Length length_;
    f32::AirlightCuts cuts_{};
    f32::AirlightColumns columns_{};  // of the whole way
    std::vector<Piece> pieces_;
};

}  // namespace

std::vector<f32::AirlightLight> airlight_row(const AirlightTables& tables, const f32::AirlightRule& rule,
                                             std::span<const f32::AirlightRay> rays) {
    const Way way(tables, rule, rays[0].h, rays[0].mu);
    std::vector<f32::AirlightLight> lights;
    for (const f32::AirlightRay& ray : rays) lights.push_back(way.light(ray));
    return lights;
}

}  // namespace airlight
