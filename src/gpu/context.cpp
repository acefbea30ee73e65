#include "gpu/context.h"

#include <epoxy/gl.h>
// Not epoxy/egl.h: its entry points abort before a display exists.
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstdio>
#include <cstring>
#include <utility>

namespace airlight::gpu {

namespace {

Error no_opengl(const char* what) {
    return {"OpenGL", what,
            "Install a driver with OpenGL 4.5 (Debian: libgl1-mesa-dri renders in software), or build with -DAIRLIGHT_GPU=OFF."};
}

bool has_word(const char* words, const char* word) { return words && std::strstr(words, word); }

// A display without a window: Mesa's surfaceless platform, or the first device of a driver that lists devices.
EGLDisplay open_display() {
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (has_word(extensions, "EGL_MESA_platform_surfaceless")) {
        const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr)) return display;
    }
    if (!has_word(extensions, "EGL_EXT_platform_device")) return EGL_NO_DISPLAY;
    const auto query = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    EGLDeviceEXT device;
    EGLint count = 0;
    if (!query || !query(1, &device, &count) || count == 0) return EGL_NO_DISPLAY;
    const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
    return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) ? display : EGL_NO_DISPLAY;
}

EGLContext open_context(EGLDisplay display, EGLint reset_strategy) {
    const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION,
                             4,
                             EGL_CONTEXT_MINOR_VERSION,
                             5,
                             EGL_CONTEXT_OPENGL_PROFILE_MASK,
                             EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                             EGL_CONTEXT_OPENGL_DEBUG,
                             EGL_TRUE,
                             EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY,
                             reset_strategy,
                             EGL_NONE};
    return eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
}

// A context that tells when the GPU was reset, or one that does not where the driver has no other.
EGLContext open_context(EGLDisplay display) {
    if (!eglBindAPI(EGL_OPENGL_API)) return EGL_NO_CONTEXT;
    const EGLContext context = open_context(display, EGL_LOSE_CONTEXT_ON_RESET);
    return context != EGL_NO_CONTEXT ? context : open_context(display, EGL_NO_RESET_NOTIFICATION);
}

// Everything but notes, and what the shader compiler says, which comes back with Program::link().
bool is_complaint(GLenum source, GLenum type, GLenum severity) {
    if (source == GL_DEBUG_SOURCE_SHADER_COMPILER && type == GL_DEBUG_TYPE_ERROR) return false;
    if (type == GL_DEBUG_TYPE_OTHER || type == GL_DEBUG_TYPE_MARKER) return false;
    return severity != GL_DEBUG_SEVERITY_NOTIFICATION;
}

// The limits that OpenGL 4.5 leaves open, and our shaders count on.
constexpr Limit needed[] = {{GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS, 4, "storage blocks in a vertex shader"},
                            {GL_MAX_COLOR_ATTACHMENTS, 4, "colour attachments"},
                            {GL_MAX_3D_TEXTURE_SIZE, 1024, "texels along a side of a 3D texture"}};

}  // namespace

struct Context::Reports {
    int errors = 0;

    static void GLAPIENTRY add(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei, const GLchar* message,
                               const void* reports) {
        if (!is_complaint(source, type, severity)) return;
        ++static_cast<Reports*>(const_cast<void*>(reports))->errors;
        std::fprintf(stderr, "OpenGL %s %u: %s\n", type == GL_DEBUG_TYPE_ERROR ? "error" : "warning", id, message);
    }
};

Result<Context> Context::create() {
    const EGLDisplay display = open_display();
    if (display == EGL_NO_DISPLAY) return no_opengl("there is no EGL display without a window.");
    const EGLContext handle = open_context(display);
    if (handle == EGL_NO_CONTEXT) {
        eglTerminate(display);
        return no_opengl("the driver does not offer OpenGL 4.5 core.");
    }
    if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, handle)) {
        eglDestroyContext(display, handle);
        eglTerminate(display);
        return no_opengl("the driver offers no context without a surface.");
    }
    Context context(display, handle, std::make_unique<Reports>());
    if (const Result<Done> enough = check_limits(needed); !enough) return enough.error();
    return context;
}

Result<Context> Context::of_window() {
    if (epoxy_gl_version() < 45) return no_opengl("the window's driver does not offer OpenGL 4.5 core.");
    Context context(nullptr, nullptr, std::make_unique<Reports>());
    if (const Result<Done> enough = check_limits(needed); !enough) return enough.error();
    return context;
}

Context::Context(void* display, void* context, std::unique_ptr<Reports> reports)
    : display_(display), context_(context), reports_(std::move(reports)) {
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(Reports::add, reports_.get());
}

Context::Context(Context&& other) noexcept
    : display_(std::exchange(other.display_, nullptr)),
      context_(std::exchange(other.context_, nullptr)),
      reports_(std::move(other.reports_)) {}

Context& Context::operator=(Context&& other) noexcept {
    std::swap(display_, other.display_);
    std::swap(context_, other.context_);
    std::swap(reports_, other.reports_);
    return *this;
}

Context::~Context() {
    if (!reports_) return;
    glDebugMessageCallback(nullptr, nullptr);
    if (!context_) return;
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    eglTerminate(display_);
}

std::string Context::renderer() const { return reinterpret_cast<const char*>(glGetString(GL_RENDERER)); }

int Context::errors() const { return reports_->errors; }

Result<Done> Context::check() const {
    const GLenum status = glGetGraphicsResetStatus();
    if (status != GL_NO_ERROR) return lost_context(status);
    return Done{};
}

Result<Done> check_limits(std::span<const Limit> limits) {
    for (const Limit& limit : limits) {
        GLint offered = 0;
        glGetIntegerv(limit.name, &offered);
        if (offered >= limit.least) continue;
        return Error{
            "OpenGL",
            "the driver offers " + std::to_string(offered) + ' ' + limit.what + "; " + std::to_string(limit.least) + " are needed.",
            "Update the driver, or render in software with LIBGL_ALWAYS_SOFTWARE=1."};
    }
    return Done{};
}

Error lost_context(unsigned status) {
    const char* whose = status == GL_GUILTY_CONTEXT_RESET     ? "a shader of this program ran too long or out of bounds."
                        : status == GL_INNOCENT_CONTEXT_RESET ? "another program brought it down."
                                                              : "the driver does not say why.";
    return {"OpenGL", std::string("the GPU was reset: ") + whose,
            "Start again; if it comes back, use a smaller picture, or render in software with LIBGL_ALWAYS_SOFTWARE=1."};
}

}  // namespace airlight::gpu
