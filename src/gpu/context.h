// OpenGL 4.5 core without a window, through EGL: a GPU, or Mesa's software where there is none.
// Uses core; knows no physics.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "core/result.h"

namespace airlight::gpu {

// A context of OpenGL, current on the thread that made it for as long as it lives. It can be moved, not copied;
// every buffer, texture and program must be gone before it is.
class Context {
public:
    // Fails, with one reason, if there is no EGL display, it does not offer OpenGL 4.5, or a limit of the driver is too low.
    // What the driver reports as an error or as a performance warning is printed on stderr with its number.
    static Result<Context> create();

    // The context that is current on this thread, made by another library for a window, which keeps it and outlives this. Fails, with one
    // reason, if it is not OpenGL 4.5 core, or a limit of the driver is too low. What the driver reports is printed as above.
    static Result<Context> of_window();

    Context(Context&& other) noexcept;
    Context& operator=(Context&& other) noexcept;
    ~Context();

    // Who renders: "llvmpipe (LLVM 15.0.6, 256 bits)".
    std::string renderer() const;
    // Errors and performance warnings that the driver has reported since the context was made: 0, or there is a bug of ours.
    int errors() const;
    // Fails if the GPU was reset since the context was made (a driver that cannot tell never does): what it held is gone.
    Result<Done> check() const;

private:
    struct Reports;
    Context(void* display, void* context, std::unique_ptr<Reports> reports);

    void* display_;
    void* context_;                     // null: a window's
    std::unique_ptr<Reports> reports_;  // the driver keeps its address
};

// What a driver must offer beyond what OpenGL 4.5 promises: the integer limit `name` of glGetIntegerv is `least` or more.
struct Limit {
    unsigned name;
    int least;
    const char* what;  // "storage blocks in a vertex shader"
};
// Fails, naming the first limit that the driver of the current context misses and what it offers.
Result<Done> check_limits(std::span<const Limit> limits);

// The error of a context that glGetGraphicsResetStatus() calls lost (`status` is not GL_NO_ERROR).
Error lost_context(unsigned status);

}  // namespace airlight::gpu
