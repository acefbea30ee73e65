#include "render/air_exact.h"

#include "render/air_wavelengths.h"

namespace airlight::render {

namespace {

// On a piece of a ray. tests/parity/air_pass_test.cpp: within 1.1 % of twelve from space at sunset, 0.4 % elsewhere.
constexpr int nodes_per_piece = 8;

class ExactAir : public AirMethod {
public:
    ExactAir(const Tables& tables, std::span<const Vec3> colours) : groups_(air_wavelengths(tables, colours, nodes_per_piece)) {}

    std::string shader() const override { return "air_exact.frag"; }
    void prepare(const AirEye&, gpu::PassTimers&) override {}
    int pictures() const override { return static_cast<int>(groups_.size()); }
    void bind(int picture) const override { groups_[static_cast<std::size_t>(picture)].bind(); }

private:
    std::vector<AirWavelengths> groups_;
};

}  // namespace

std::unique_ptr<AirMethod> exact_air(const Tables& tables, std::span<const Vec3> colours) {
    return std::make_unique<ExactAir>(tables, colours);
}

}  // namespace airlight::render
