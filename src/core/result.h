// A value, or the error that kept us from it.
//
//     Result<Atmosphere> atmosphere = read_atmosphere(path);
//     if (!atmosphere) return atmosphere.error();
//     use(*atmosphere);
//
// Reading the value of a failed result is our own fault and asserts.
#pragma once

#include <cassert>
#include <utility>
#include <variant>

#include "core/error.h"

namespace airlight {

template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}

    explicit operator bool() const { return content_.index() == 0; }

    const T& operator*() const& {
        assert(*this);
        return *std::get_if<0>(&content_);
    }
    T& operator*() & {
        assert(*this);
        return *std::get_if<0>(&content_);
    }
    T&& operator*() && {
        assert(*this);
        return std::move(*std::get_if<0>(&content_));
    }
    const T* operator->() const { return &**this; }
    T* operator->() { return &**this; }

    const Error& error() const {
        assert(!*this);
        return *std::get_if<1>(&content_);
    }

private:
    std::variant<T, Error> content_;
};

// The value of a Result<Done>: nothing to say but that it was done.
struct Done {};

}  // namespace airlight
