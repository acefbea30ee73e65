// What a fuzz target defines and what it may demand: a violated demand ends the program, and libFuzzer keeps the input.
// Uses core's errors; knows nothing of what is read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "core/error.h"

// Reads one input of any bytes; returns 0.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace airlight::fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) { return {reinterpret_cast<const char*>(data), size}; }

inline void demand(bool holds, const char* law) {
    if (holds) return;
    std::fprintf(stderr, "violated: %s\n", law);
    std::abort();
}

// A refusal says what is wrong.
inline void demand_message(const Error& error) {
    demand(!error.what.empty() && error.message().size() < 4096, "an error says what is wrong, and briefly");
}

}  // namespace airlight::fuzz
