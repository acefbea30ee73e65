// Any bytes are tables of the origin asked for, with light in every texel, or a refusal; so are they with checksums that fit.

#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <cstring>

#include "cache_sample.h"
#include "fuzz.h"
#include "tools/table_seal.h"

using namespace airlight;
using fuzz::demand;

namespace {

// A file in memory.
class MemoryFile {
public:
    explicit MemoryFile(std::string_view bytes) : number_(::memfd_create("table file", MFD_CLOEXEC)) {
        demand(number_ >= 0 && ::write(number_, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()),
               "a file in memory can be made");
    }
    ~MemoryFile() { ::close(number_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    std::string path() const { return "/proc/self/fd/" + std::to_string(number_); }

private:
    int number_;
};

template <class TableType>
void check_light(const TableType& table) {
    for (const auto& cell : table.cells())
        for (const float x : cell.v) demand(std::isfinite(x) && x >= 0.0f, "light is finite and not negative");
}

void check(std::string_view bytes) {
    const MemoryFile file(bytes);
    const TableOrigin origin = fuzz::cache_origin();
    if (const auto tables = read_tables(file.path(), origin)) {
        demand(tables->size() == 1 && tables->front().source.cells().size() == 16 && tables->front().irradiance.cells().size() == 4 &&
                   tables->front().transmittance.cells().size() == 4,
               "tables have the sizes asked for");
        check_light(tables->front().transmittance);
        check_light(tables->front().source);
        check_light(tables->front().irradiance);
    } else {
        fuzz::demand_message(tables.error());
    }
    if (const auto state = read_bake_state(file.path(), origin)) {
        demand(state->orders_done >= 1 && state->orders_done < origin.settings.orders, "a state is begun and not finished");
        check_light(state->source_sum);
        check_light(state->irradiance_sum);
    } else {
        fuzz::demand_message(state.error());
    }
    if (const auto summary = read_table_summary(file.path()))
        demand(!summary->wavelengths.empty() && summary->bytes == bytes.size(), "a summary is of the file");
    else fuzz::demand_message(summary.error());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string bytes(fuzz::text_of(data, size));
    check(bytes);
    test::seal(bytes);
    check(bytes);
    return 0;
}
