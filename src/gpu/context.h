// OpenGL 4.5 core without a window, through EGL: a GPU, or Mesa's software where there is none.
// Uses core; knows no physics.
#pragma once

#include <string>

#include "core/result.h"

namespace airlight::gpu {

// A context of OpenGL, current on the thread that made it for as long as it lives. It can be moved, not copied;
// every buffer, texture and program must be gone before it is.
class Context {
public:
    // Fails, with one reason, if there is no EGL display or it does not offer OpenGL 4.5.
    // What the driver reports as an error in debug output is printed on stderr with its number.
    static Result<Context> create();

    Context(Context&& other) noexcept;
    Context& operator=(Context&& other) noexcept;
    ~Context();

    // Who renders: "llvmpipe (LLVM 15.0.6, 256 bits)".
    std::string renderer() const;
    // Errors that the driver has reported since the context was made.
    int errors() const { return *errors_; }

private:
    Context(void* display, void* context, int* errors) : display_(display), context_(context), errors_(errors) {}

    void* display_;
    void* context_;
    int* errors_;  // on the heap: the driver keeps its address
};

}  // namespace airlight::gpu
