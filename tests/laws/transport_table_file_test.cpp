// Table files: what is written is read, to the bit; what is not as it was written is refused with its reason.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <chrono>
#include <clocale>
#include <fstream>
#include <functional>
#include <limits>
#include <set>

#include "core/files.h"
#include "tools/small_tables.h"
#include "tools/table_seal.h"
#include "tools/temporary_folder.h"
#include "transport/table_file.h"

using namespace airlight;
using namespace airlight::test;

namespace {

// A small file, and the tables in it.
struct Sample {
    TemporaryFolder folder;
    std::filesystem::path path = folder.path / "small.tables";
    TableOrigin origin = table_origin(one_gas(), some_wavelengths(2), tiny_bake(2));
    PackTables tables = *bake_pack(air_optics(one_gas(), some_wavelengths(2)), tiny_bake(2), {});
    std::string bytes;

    Sample() {
        REQUIRE(write_tables(path, origin, std::span(&tables, 1)));
        bytes = *read_file(path);
    }
    // What reading says once the file holds `changed`; empty if it is read.
    std::string refusal(const std::string& changed) const {
        REQUIRE(write_file(path, changed));
        const auto read = read_tables(path, origin);
        return read ? "" : read.error().message();
    }
};

bool says(const std::string& message, const std::string& words) { return message.find(words) != std::string::npos; }

Atmosphere of_everything() {
    Atmosphere atmosphere = one_gas();
    const auto curve = [](auto y) { return *SpectrumOf<decltype(y)>::of({{400.0 * nm, y}, {700.0 * nm, 2.0 * y}}); };
    Constituent constituent = atmosphere.constituents[0];
    constituent.profile = LayerProfile{1.0 * km, 2.0 * km};
    constituent.scattering = curve(1e-6 * per_m);
    constituent.phase = HenyeyGreensteinPhase{curve(Number(0.3))};
    atmosphere.constituents.push_back(constituent);
    constituent.profile = TriangleProfile{10.0 * km, 20.0 * km, 30.0 * km};
    constituent.phase = CornetteShanksPhase{curve(Number(0.3))};
    atmosphere.constituents.push_back(constituent);
    constituent.profile = TabulatedProfile{*Curve<Length, Number>::of({{0.0 * km, Number(1.0)}, {5.0 * km, Number(0.5)}})};
    constituent.phase = TabulatedPhase{{0.0, 1.0, pi}, {400.0 * nm, 700.0 * nm}, {{1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}}};
    atmosphere.constituents.push_back(constituent);
    constituent.phase = IsotropicPhase{};
    atmosphere.constituents.push_back(constituent);
    return atmosphere;
}

struct Described {
    Atmosphere atmosphere = of_everything();
    std::vector<Wavelength> wavelengths = some_wavelengths(3);
    BakeSettings settings = tiny_bake(3);
    TableKey key() const { return table_key(atmosphere, wavelengths, settings); }
};

template <class Kind>
Kind& profile(Described& d, std::size_t i) {
    return std::get<Kind>(d.atmosphere.constituents[i].profile);
}
template <class Kind>
Kind& phase(Described& d, std::size_t i) {
    return std::get<Kind>(d.atmosphere.constituents[i].phase);
}
template <class X>
void grow(X& x) {
    x = x * (1.0 + 1e-15);  // the last bits
}

}  // namespace

TEST_CASE("a change of any one field of the description, of the wavelengths or of the settings gives another key") {
    using Change = std::function<void(Described&)>;
    const std::vector<Change> changes = {
        [](Described& d) { grow(d.atmosphere.bottom_radius); },
        [](Described& d) { grow(d.atmosphere.top_altitude); },
        [](Described& d) { d.atmosphere.ground_albedo = SpectrumOf<Number>::constant(0.31); },
        [](Described& d) { d.atmosphere.sun.irradiance = d.atmosphere.sun.irradiance.scaled(1.01); },
        [](Described& d) { d.atmosphere.sun.angular_radius = 0.004; },
        [](Described& d) { d.atmosphere.sun.limb_darkening_1 = SpectrumOf<Number>::constant(0.1); },
        [](Described& d) { d.atmosphere.sun.limb_darkening_2 = SpectrumOf<Number>::constant(0.1); },
        [](Described& d) { d.atmosphere.constituents.pop_back(); },
        [](Described& d) { std::swap(d.atmosphere.constituents[0], d.atmosphere.constituents[1]); },
        [](Described& d) { d.atmosphere.constituents[1].scattering = d.atmosphere.constituents[1].scattering.scaled(1.1); },
        [](Described& d) { d.atmosphere.constituents[1].scattering = SpectrumOf<InverseLength>::constant(1e-6 * per_m); },
        [](Described& d) { d.atmosphere.constituents[1].absorption = SpectrumOf<InverseLength>::constant(1e-6 * per_m); },
        [](Described& d) { grow(profile<ExponentialProfile>(d, 0).scale_height); },
        [](Described& d) { grow(profile<ExponentialProfile>(d, 0).top); },
        [](Described& d) { grow(profile<LayerProfile>(d, 1).low); },
        [](Described& d) { grow(profile<LayerProfile>(d, 1).high); },
        [](Described& d) { grow(profile<TriangleProfile>(d, 2).low); },
        [](Described& d) { grow(profile<TriangleProfile>(d, 2).peak); },
        [](Described& d) { grow(profile<TriangleProfile>(d, 2).high); },
        [](Described& d) { profile<TabulatedProfile>(d, 3).densities = profile<TabulatedProfile>(d, 3).densities.scaled(0.9); },
        [](Described& d) {
            d.atmosphere.constituents[1].profile = TriangleProfile{1.0 * km, 2.0 * km, 2.0 * km};
        },
        [](Described& d) { phase<RayleighPhase>(d, 0).depolarisation = 0.03; },
        [](Described& d) { phase<HenyeyGreensteinPhase>(d, 1).g = SpectrumOf<Number>::constant(0.3); },
        [](Described& d) { phase<CornetteShanksPhase>(d, 2).g = SpectrumOf<Number>::constant(0.3); },
        [](Described& d) { d.atmosphere.constituents[1].phase = CornetteShanksPhase{phase<HenyeyGreensteinPhase>(d, 1).g}; },
        [](Described& d) { phase<TabulatedPhase>(d, 3).angles[1] = 1.1; },
        [](Described& d) { phase<TabulatedPhase>(d, 3).wavelengths[1] = 701.0 * nm; },
        [](Described& d) { phase<TabulatedPhase>(d, 3).values[1][2] = 1.1; },
        [](Described& d) { grow(d.wavelengths[1]); },
        [](Described& d) { d.wavelengths.pop_back(); },
        [](Described& d) { ++d.settings.orders; },
        [](Described& d) { d.settings.extrapolate = false; },
        [](Described& d) { ++d.settings.sizes.transmittance_mu; },
        [](Described& d) { ++d.settings.sizes.transmittance_altitude; },
        [](Described& d) { ++d.settings.sizes.sun; },
        [](Described& d) { ++d.settings.sizes.azimuth; },
        [](Described& d) { ++d.settings.sizes.view; },
        [](Described& d) { ++d.settings.sizes.altitude; },
    };
    std::set<std::string> keys = {key_text(Described{}.key())};
    for (std::size_t i = 0; i < changes.size(); ++i) {
        CAPTURE(i);
        Described changed;
        changes[i](changed);
        CHECK(keys.insert(key_text(changed.key())).second);
    }
}

TEST_CASE("the key of a description alone knows its fields, and nothing of the settings") {
    const auto key = [](const Described& d) { return description_key(d.atmosphere, d.wavelengths); };
    Described thicker, redder, finer;
    grow(thicker.atmosphere.top_altitude);
    redder.wavelengths.pop_back();
    ++finer.settings.sizes.sun;
    CHECK(key(thicker) != key(Described{}));
    CHECK(key(redder) != key(Described{}));
    CHECK(key(finer) == key(Described{}));
}

TEST_CASE("names, the sign of zero and the locale leave the key as it is") {
    const TableKey key = Described{}.key();
    Described same;
    same.atmosphere.name = "another name";
    same.atmosphere.constituents[0].name = "gas";
    same.atmosphere.sun.angular_radius = -0.0;
    CHECK(same.key() == key);
    // Locales with a decimal comma, where the system has one.
    for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8", "C.UTF-8"})
        if (std::setlocale(LC_ALL, locale) != nullptr) CHECK(Described{}.key() == key);
    std::setlocale(LC_ALL, "C");
    CHECK(key_text(TableKey{0x1, 0xabc}) == "00000000000000010000000000000abc");
}

TEST_CASE("tables of three packs are read as they were written, to the bit") {
    TemporaryFolder folder;
    const std::vector<Wavelength> wavelengths = some_wavelengths(35);
    const TableOrigin origin = table_origin(one_gas(), wavelengths, tiny_bake(1));
    std::vector<PackTables> tables;
    for (const auto& group : packs(wavelengths)) tables.push_back(*bake_pack(air_optics(one_gas(), group), tiny_bake(1), {}));
    REQUIRE(write_tables(folder.path / "a", origin, tables));
    const auto read = read_tables(folder.path / "a", origin);
    REQUIRE(read);
    REQUIRE(read->size() == 3);
    for (std::size_t i = 0; i < 3; ++i) CHECK(same_bits((*read)[i], tables[i]));

    const TableFileSummary summary = *read_table_summary(folder.path / "a");
    CHECK(summary.name == "one gas");
    CHECK(summary.finished);
    CHECK(summary.key == origin.key);
    CHECK(summary.wavelengths == wavelengths);
    CHECK(summary.bytes == std::filesystem::file_size(folder.path / "a"));
}

TEST_CASE("a state is read as it was written, and is not taken for tables") {
    TemporaryFolder folder;
    const TableOrigin origin = table_origin(one_gas(), some_wavelengths(1), tiny_bake(3));
    BakeState state;
    BakeSteps steps;
    steps.order_done = [&](const BakeState& s) { state = s; };
    REQUIRE(bake_pack(air_optics(one_gas(), some_wavelengths(1)), tiny_bake(3), {}, steps));
    const std::filesystem::path path = folder.path / "state";
    REQUIRE(write_bake_state(path, origin, state));
    const auto read = read_bake_state(path, origin);
    REQUIRE(read);
    CHECK(read->orders_done == 2);
    CHECK(same_bits({{}, read->source, read->irradiance}, {{}, state.source, state.irradiance}));
    CHECK(same_bits({{}, read->source_sum, read->irradiance_sum}, {{}, state.source_sum, state.irradiance_sum}));
    CHECK(says(read_tables(path, origin).error().message(), "holds a bake that was not finished"));

    std::string more = *read_file(path);
    set_field(more, 48, std::uint32_t{3});
    seal(more);
    REQUIRE(write_file(path, more));
    CHECK(says(read_bake_state(path, origin).error().message(), "3 of 3 orders are done"));
}

TEST_CASE("a table file cut anywhere is refused, and the message counts its bytes") {
    const Sample sample;
    const std::size_t whole = sample.bytes.size();
    for (std::size_t cut = 0; cut < whole; cut += cut < 64 ? 1 : (cut < 600 ? 37 : 1997)) {
        CAPTURE(cut);
        const std::string refusal = sample.refusal(sample.bytes.substr(0, cut));
        CHECK(says(refusal, fmt::format("is truncated: {} of {} bytes", cut, cut < 24 ? 128 : whole)));
        CHECK(says(refusal, sample.path.string()));
    }
}

TEST_CASE("a flipped bit is refused, or changes nothing") {
    const Sample sample;
    int refused = 0;
    for (std::size_t i = 0; i < sample.bytes.size(); i += i < 336 ? 1 : 211) {
        CAPTURE(i);
        std::string changed = sample.bytes;
        changed[i] = static_cast<char>(changed[i] ^ (1 << (i % 8)));
        REQUIRE(write_file(sample.path, changed));
        const auto read = read_tables(sample.path, sample.origin);
        if (read) CHECK(same_bits(read->front(), sample.tables));
        refused += !read;
    }
    CHECK(refused > 128 + 2 * 8 + 3 * 64);  // the whole front, and some of the tables
}

TEST_CASE("what is not a table file of this program, this version or this description is refused with its reason") {
    const Sample sample;
    CHECK(sample.refusal(sample.bytes).empty());
    CHECK(says(sample.refusal("[planet]\nradius = \"6360 km\"\n"), "is not a table file of Airlight"));
    CHECK(says(sample.refusal(sample.bytes + "x"), "is damaged: it has"));

    std::string later = sample.bytes;
    set_field(later, 8, std::uint32_t{3});
    CHECK(says(sample.refusal(later), "was written by format version 3, this program reads 1\n  Delete it"));

    TableOrigin other = sample.origin;
    other.key = table_key(of_everything(), other.wavelengths, other.settings);
    REQUIRE(write_file(sample.path, sample.bytes));
    CHECK(says(read_tables(sample.path, other).error().message(), "belongs to another atmosphere"));
    CHECK(says(read_bake_state(sample.path, sample.origin).error().message(), "holds tables"));

    CHECK(says(read_tables(sample.folder.path / "absent", sample.origin).error().message(), "cannot be read: No such file"));
    CHECK(says(read_tables(sample.folder.path, sample.origin).error().message(), "is not a file"));
}

TEST_CASE("counts and sizes that lie are refused before anything is allocated") {
    const Sample sample;
    for (const std::size_t offset : {40u, 44u}) {
        for (const std::uint32_t count : {0u, 1u, 3u, 4096u, 0xffffffffu}) {
            if (count == field<std::uint32_t>(sample.bytes, offset)) continue;
            std::string changed = sample.bytes;
            set_field(changed, offset, count);
            seal(changed);
            CHECK(says(sample.refusal(changed), "is damaged: "));
        }
    }
    const std::size_t entry = entry_offset(sample.bytes, 1);
    for (const std::size_t at : {std::size_t{0}, std::size_t{16}, std::size_t{32}, std::size_t{40}, std::size_t{48}}) {
        std::string changed = sample.bytes;
        changed[entry + at + 1] = '\x7f';
        seal(changed);
        CHECK(says(sample.refusal(changed), "its list of sections is not that of its key"));
    }
}

TEST_CASE("a value that no light has is refused, on the way in and on the way out") {
    Sample sample;
    const auto offset = static_cast<std::size_t>(field<std::uint64_t>(sample.bytes, entry_offset(sample.bytes, 1) + 40));
    for (const float wrong : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -1.0f}) {
        std::string changed = sample.bytes;
        set_field(changed, offset + 4 * sizeof(float), wrong);
        CHECK(says(sample.refusal(changed), "is damaged: checksum of section source of pack 0"));
        seal(changed);
        CHECK(says(sample.refusal(changed),
                   fmt::format("is damaged: in section source of pack 0, value 5 is {}; it must be finite and not below 0", wrong)));

        sample.tables.irradiance.cells()[0].v[1] = wrong;
        const auto written = write_tables(sample.path, sample.origin, std::span(&sample.tables, 1));
        REQUIRE(!written);
        CHECK(says(written.error().message(), "is not written: in table irradiance, value 2 is"));
    }
}

TEST_CASE("a full disk or a missing folder is one message, what stood there stays, and nothing is left behind") {
    const Sample sample;
    std::filesystem::create_symlink("/dev/full", temporary_name(sample.path));  // what write_file() writes to, is full
    const auto full = write_tables(sample.path, sample.origin, std::span(&sample.tables, 1));
    REQUIRE(!full);
    CHECK(says(full.error().message(), "cannot be written: No space left on device"));
    CHECK(*read_file(sample.path) == sample.bytes);
    CHECK(!std::filesystem::is_symlink(temporary_name(sample.path)));

    CHECK(says(write_tables(sample.folder.path / "none" / "a", sample.origin, std::span(&sample.tables, 1)).error().message(),
               "cannot be written: No such file"));
}

TEST_CASE("tables of the default size are read in less than a second") {
    TemporaryFolder folder;
    const TableOrigin origin = table_origin(one_gas(), some_wavelengths(16), BakeSettings{});
    const TableSizes s = origin.settings.sizes;
    const PackTables tables{Table<f32::Spectrum, 2>({s.transmittance_mu, s.transmittance_altitude}),
                            Table<f32::RadianceSpectrum, 4>({s.sun, s.azimuth, s.view, s.altitude}),
                            Table<f32::IrradianceSpectrum, 2>({s.sun, s.altitude})};
    REQUIRE(write_tables(folder.path / "a", origin, std::span(&tables, 1)));
    const auto start = std::chrono::steady_clock::now();
    REQUIRE(read_tables(folder.path / "a", origin));
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    MESSAGE("read ", std::filesystem::file_size(folder.path / "a") >> 20, " MiB in ", seconds, " s");
    CHECK(seconds < 1.0);
}
