// What went wrong with a user's input: where, what, and what to do about it.
// Bad input is a value (Result in core/result.h), never an exception; our own faults are assertions.
// Uses nothing.
#pragma once

#include <string>
#include <string_view>

namespace airlight {

struct Error {
    std::string where;   // "earth.toml:14", "--zenith", "/data/sky.exr"; empty if there is only one place
    std::string what;    // the value, and the rule that it breaks: one sentence
    std::string remedy;  // what to do: one sentence; empty if it goes without saying

    // One message: "where: what" and, indented on a second line, the remedy.
    std::string message() const;
};

// The same error seen from further out: "earth.toml:14" in front of where it was noticed.
Error at(std::string_view where, Error error);

// The word of `candidates` (separated by spaces) that is nearest to `word`, for "did you mean"; empty if none is near.
std::string nearest_word(std::string_view word, std::string_view candidates);

}  // namespace airlight
