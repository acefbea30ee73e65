// A context of OpenGL for one test case.
//
//     const GpuCase gpu;
//     if (!gpu) return;  // a line has said why
//
// When it goes, an error or a performance warning of the driver fails the case.
#pragma once

#include <doctest/doctest.h>

#include <optional>
#include <utility>

#include "gpu/context.h"

namespace airlight::test {

class GpuCase {
public:
    GpuCase() {
        Result<gpu::Context> made = gpu::Context::create();
        if (made) context_ = std::move(*made);
        else MESSAGE("[skipped] no OpenGL: " << made.error().message());
    }
    ~GpuCase() {
        if (!context_) return;
        CHECK(context_->errors() == 0);
        CHECK(context_->check());
    }
    GpuCase(const GpuCase&) = delete;
    GpuCase& operator=(const GpuCase&) = delete;

    explicit operator bool() const { return context_.has_value(); }
    const gpu::Context& context() const { return *context_; }
    bool software() const { return context_->renderer().starts_with("llvmpipe"); }

private:
    std::optional<gpu::Context> context_;
};

}  // namespace airlight::test
