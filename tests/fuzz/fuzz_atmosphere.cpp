// Any bytes are an atmosphere or a refusal; an atmosphere that was read, written again, reads back to the same bits.

#include "atmosphere/atmosphere_file.h"
#include "fuzz.h"

using namespace airlight;
using fuzz::demand;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Result<Atmosphere> atmosphere = parse_atmosphere(fuzz::text_of(data, size), "fuzz.toml");
    if (!atmosphere) {
        fuzz::demand_message(atmosphere.error());
        return 0;
    }
    const Result<Atmosphere> again = parse_atmosphere(atmosphere_text(*atmosphere), "written.toml");
    demand(again && *again == *atmosphere, "a written atmosphere reads back");
    return 0;
}
