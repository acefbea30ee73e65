// Any bytes are a time or a refusal; a time that was read, written again, reads as the same.

#include <cmath>

#include "fuzz.h"
#include "sun/time.h"

using namespace airlight;
using fuzz::demand;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Result<Utc> time = parse_utc(fuzz::text_of(data, size));
    if (!time) {
        fuzz::demand_message(time.error());
        return 0;
    }
    demand(bool(utc_of(*time)), "a time that was read exists");
    const Result<Utc> again = parse_utc(utc_text(*time, 9));
    demand(again && std::abs(seconds_between(*time, *again)) < 2e-9, "a written time reads back");
    return 0;
}
