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

EGLContext open_context(EGLDisplay display) {
    const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION,
                             4,
                             EGL_CONTEXT_MINOR_VERSION,
                             5,
                             EGL_CONTEXT_OPENGL_PROFILE_MASK,
                             EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                             EGL_CONTEXT_OPENGL_DEBUG,
                             EGL_TRUE,
                             EGL_NONE};
    if (!eglBindAPI(EGL_OPENGL_API)) return EGL_NO_CONTEXT;
    return eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
}

// What the shader compiler says comes back with Program::link().
void GLAPIENTRY report(GLenum source, GLenum type, GLuint id, GLenum, GLsizei, const GLchar* message, const void* errors) {
    if (type != GL_DEBUG_TYPE_ERROR || source == GL_DEBUG_SOURCE_SHADER_COMPILER) return;
    ++*static_cast<int*>(const_cast<void*>(errors));
    std::fprintf(stderr, "OpenGL error %u: %s\n", id, message);
}

}  // namespace

Result<Context> Context::create() {
    const EGLDisplay display = open_display();
    if (display == EGL_NO_DISPLAY) return no_opengl("there is no EGL display without a window.");
    const EGLContext context = open_context(display);
    if (context == EGL_NO_CONTEXT) {
        eglTerminate(display);
        return no_opengl("the driver does not offer OpenGL 4.5 core.");
    }
    if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
        eglDestroyContext(display, context);
        eglTerminate(display);
        return no_opengl("the driver offers no context without a surface.");
    }
    int* errors = new int(0);
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(report, errors);
    return Context(display, context, errors);
}

Context::Context(Context&& other) noexcept
    : display_(std::exchange(other.display_, nullptr)),
      context_(std::exchange(other.context_, nullptr)),
      errors_(std::exchange(other.errors_, nullptr)) {}

Context& Context::operator=(Context&& other) noexcept {
    std::swap(display_, other.display_);
    std::swap(context_, other.context_);
    std::swap(errors_, other.errors_);
    return *this;
}

Context::~Context() {
    if (!context_) return;
    glDebugMessageCallback(nullptr, nullptr);
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    eglTerminate(display_);
    delete errors_;
}

std::string Context::renderer() const { return reinterpret_cast<const char*>(glGetString(GL_RENDERER)); }

}  // namespace airlight::gpu
