// What a test needs before it can ask: its failure fails the case with its message.
#pragma once

#include <doctest/doctest.h>

#include <utility>

#include "core/result.h"

namespace airlight::test {

template <class T>
T must(Result<T> made) {
    if (!made) FAIL(made.error().message());
    return std::move(*made);
}

}  // namespace airlight::test
