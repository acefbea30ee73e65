// Writes tests/corpus/cache anew, for when the form of table files changes:
//   cmake --build --preset release --target cache_corpus && build/release/tests/fuzz/cache_corpus tests/corpus/cache

#include <filesystem>
#include <limits>

#include "cache_sample.h"
#include "core/files.h"
#include "tools/table_seal.h"

using namespace airlight;

namespace {

template <class TableType>
TableType filled(TableType table, float first) {
    for (auto& cell : table.cells())
        for (float& x : cell.v) x = first++;
    return table;
}

void save(const std::filesystem::path& path, const Result<Done>& written) {
    if (written) return;
    std::fprintf(stderr, "%s: %s\n", path.c_str(), written.error().message().c_str());
    std::exit(1);
}
void save(const std::filesystem::path& path, const std::string& bytes) { save(path, write_file(path, bytes)); }

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    const TableOrigin origin = fuzz::cache_origin();
    const auto transmittance = filled(Table<f32::Spectrum, 2>({2, 2}), 0.0f);
    const auto source = filled(Table<f32::RadianceSpectrum, 4>({2, 2, 2, 2}), 1.0f);
    const auto irradiance = filled(Table<f32::IrradianceSpectrum, 2>({2, 2}), 2.0f);
    const PackTables tables{transmittance, source, irradiance};
    save(folder / "whole.tables", write_tables(folder / "whole.tables", origin, std::span(&tables, 1)));
    save(folder / "state.begun", write_bake_state(folder / "state.begun", origin, {2, source, irradiance, source, irradiance}));

    const std::string whole = *read_file(folder / "whole.tables");
    save(folder / "cut.tables", whole.substr(0, 5000));
    std::string changed = whole;
    changed[4100] = static_cast<char>(changed[4100] ^ 1);
    save(folder / "flipped-texel.tables", changed);
    changed = whole;
    changed[42] = '\x7f';  // the count of wavelengths
    save(folder / "many-wavelengths.tables", changed);
    changed = whole;
    test::set_field(changed, 8, std::uint32_t{3});
    save(folder / "version-3.tables", changed);
    changed = whole;
    test::set_field(changed, 4096, std::numeric_limits<float>::quiet_NaN());
    test::seal(changed);
    save(folder / "not-a-number.tables", changed);
    changed = whole;
    test::set_field(changed, test::entry_offset(whole, 1) + 40, ~std::uint64_t{0});
    test::seal(changed);
    save(folder / "far-offset.tables", changed);
    save(folder / "foreign.tables", std::string("[planet]\nradius = \"6360 km\"\n"));
}
