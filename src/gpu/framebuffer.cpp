#include "gpu/framebuffer.h"

#include <epoxy/gl.h>

#include <cassert>
#include <vector>

namespace airlight::gpu {

namespace {

unsigned create_name() {
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    return name;
}

}  // namespace

void DeleteFramebuffer::operator()(unsigned name) const { glDeleteFramebuffers(1, &name); }

Framebuffer::Framebuffer(TextureSize size) : size_(size), handle_(create_name()) {}

Result<Framebuffer> Framebuffer::create(std::initializer_list<const Texture*> colours, const Texture* depth) {
    assert(depth || colours.size() > 0);
    Framebuffer made(depth ? depth->size() : (*colours.begin())->size());
    std::vector<GLenum> written;
    for (const Texture* colour : colours) {
        written.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(written.size()));
        glNamedFramebufferTexture(made.name(), written.back(), colour->name(), 0);
    }
    if (depth) glNamedFramebufferTexture(made.name(), GL_DEPTH_ATTACHMENT, depth->name(), 0);
    glNamedFramebufferDrawBuffers(made.name(), static_cast<GLsizei>(written.size()), written.data());
    const GLenum status = glCheckNamedFramebufferStatus(made.name(), GL_DRAW_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        return Error{"OpenGL", "the driver cannot draw into this set of textures (status " + std::to_string(status) + ").",
                     "Update the driver, or render in software with LIBGL_ALWAYS_SOFTWARE=1."};
    return made;
}

void Framebuffer::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, name());
    glViewport(0, 0, size_.width, size_.height);
}

void Framebuffer::clear_colour(unsigned index, float red, float green, float blue, float alpha) const {
    const GLfloat colour[] = {red, green, blue, alpha};
    glClearNamedFramebufferfv(name(), GL_COLOR, static_cast<GLint>(index), colour);
}

void Framebuffer::clear_depth(float depth) const { glClearNamedFramebufferfv(name(), GL_DEPTH, 0, &depth); }

}  // namespace airlight::gpu
