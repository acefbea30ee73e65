#include "transport/table_key.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <bit>
#include <variant>
#include <vector>

namespace airlight {

namespace {

// Raised when the same description is baked into other numbers, so that older tables are not taken for new ones.
constexpr std::uint64_t bake_version = 9;

// Structures are taken apart by structured bindings: a field that is added and forgotten here does not compile.
class CanonicalBytes {
public:
    TableKey hash() const {
        const XXH128_hash_t hash = XXH3_128bits(bytes_.data(), bytes_.size());
        return {hash.high64, hash.low64};
    }

    template <class... Parts>
    void add_all(const Parts&... parts) {
        (add(parts), ...);
    }

    void add(std::uint64_t word) {
        for (int shift = 0; shift < 64; shift += 8) bytes_.push_back(static_cast<unsigned char>(word >> shift));
    }
    void add(int x) { add(static_cast<std::uint64_t>(x)); }
    void add(bool x) { add(static_cast<std::uint64_t>(x)); }
    void add(double x) { add(std::bit_cast<std::uint64_t>(x == 0.0 ? 0.0 : x)); }  // -0 is 0
    template <int L, int W, int S, int P>
    void add(Quantity<double, L, W, S, P> x) {
        add(x.value);
    }
    template <class T>
    void add(std::span<const T> items) {
        add(static_cast<std::uint64_t>(items.size()));
        for (const T& item : items) add(item);
    }
    template <class T>
    void add(const std::vector<T>& items) {
        add(std::span<const T>(items));
    }
    template <class X, class Y>
    void add(const Curve<X, Y>& curve) {
        add(static_cast<std::uint64_t>(curve.samples().size()));
        for (const auto& [x, y] : curve.samples()) add_all(x, y);
    }
    template <class... Kinds>
    void add(const std::variant<Kinds...>& choice) {
        add(static_cast<std::uint64_t>(choice.index()));
        std::visit([this](const auto& kind) { this->add(kind); }, choice);  // clang 14 sees no use of this without it
    }

    void add(const ExponentialProfile& profile) {
        const auto& [scale_height, top] = profile;
        add_all(scale_height, top);
    }
    void add(const LayerProfile& profile) {
        const auto& [low, high] = profile;
        add_all(low, high);
    }
    void add(const TriangleProfile& profile) {
        const auto& [low, peak, high] = profile;
        add_all(low, peak, high);
    }
    void add(const TabulatedProfile& profile) {
        const auto& [densities] = profile;
        add(densities);
    }

    void add(const IsotropicPhase&) {}
    void add(const RayleighPhase& phase) {
        const auto& [depolarisation] = phase;
        add(depolarisation);
    }
    void add(const HenyeyGreensteinPhase& phase) {
        const auto& [g] = phase;
        add(g);
    }
    void add(const CornetteShanksPhase& phase) {
        const auto& [g] = phase;
        add(g);
    }
    void add(const TabulatedPhase& phase) {
        const auto& [angles, wavelengths, values] = phase;
        add_all(angles, wavelengths, values);
    }

    void add(const Constituent& constituent) {
        const auto& [name, profile, scattering, absorption, phase] = constituent;
        add_all(profile, scattering, absorption, phase);
    }
    void add(const Sun& sun) {
        const auto& [irradiance, angular_radius, limb_darkening_1, limb_darkening_2] = sun;
        add_all(irradiance, angular_radius, limb_darkening_1, limb_darkening_2);
    }
    void add(const Atmosphere& atmosphere) {
        const auto& [name, bottom_radius, top_altitude, constituents, ground_albedo, sun] = atmosphere;
        add_all(bottom_radius, top_altitude, constituents, ground_albedo, sun);
    }
    void add(const TableSizes& sizes) {
        const auto& [transmittance_mu, transmittance_altitude, sun, azimuth, view, altitude] = sizes;
        add_all(transmittance_mu, transmittance_altitude, sun, azimuth, view, altitude);
    }
    void add(const BakeSettings& settings) {
        const auto& [sizes, orders, extrapolate] = settings;
        add_all(sizes, orders, extrapolate);
    }

private:
    std::vector<unsigned char> bytes_;
};

}  // namespace

std::string key_text(const TableKey& key) { return fmt::format("{:016x}{:016x}", key.high, key.low); }

TableKey table_key(const Atmosphere& atmosphere, std::span<const Wavelength> wavelengths, const BakeSettings& settings) {
    CanonicalBytes bytes;
    bytes.add_all(bake_version, atmosphere, wavelengths, settings);
    return bytes.hash();
}

TableKey description_key(const Atmosphere& atmosphere, std::span<const Wavelength> wavelengths) {
    CanonicalBytes bytes;
    bytes.add_all(atmosphere, wavelengths);
    return bytes.hash();
}

}  // namespace airlight
